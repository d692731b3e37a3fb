// SPDX-License-Identifier: MIT
// The results of a benchmark as they lie in its folder, with errors computed anew from
// trajectories.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "engine/bench/bench_plan.h"

namespace svoscope {

/// Figures of one run. What the run did not have is empty.
struct RunFigures {
  std::optional<double> ate_m, ate_median_m, ate_max_m, scale;
  std::optional<double> rpe_trans_m, rpe_rot_rad;
  std::optional<double> tracked;      ///< fraction of the frames since the start, 0..1
  std::optional<double> init_time_s;  ///< from the first frame
  std::optional<double> init_frame, frames;
  std::optional<double> keyframes, losses, relocalisations, relocalisation_time_s;
  std::optional<double> fps, tracking_ms, mapping_ms;  ///< median times of a frame
  std::optional<double> points, segments, memory_mb;
};

struct RunResult {
  int run = 1;
  bool present = false;  ///< there is a finished cell (peers: a trajectory)
  CellRecord record;     ///< not for peers
  RunFigures figures;
  bool good = false;  ///< counts in means: it started and tracked enough
  std::string why;    ///< why it does not
  std::optional<EvalResult> evaluation;
  std::vector<double> lost;  ///< times of lost frames after the start, s
};

/// A row of the tables: one figure of a run.
struct FigureInfo {
  const char* key;    ///< in results.csv: "ate_m"
  const char* label;  ///< "ATE rmse"
  const char* unit;   ///< "m"; may be empty
  int digits;         ///< after the point
  std::optional<double> RunFigures::*value;
  bool less_is_better;
};
const std::vector<FigureInfo>& figureTable();
const FigureInfo& figure(const std::string& key);  ///< must exist

/// Mean and spread over the runs that count.
struct Spread {
  int count = 0;                                   ///< values
  double mean = 0, stddev = 0, low = 0, high = 0;  ///< stddev: of the sample, 0 for one value
};

/// A column of the tables: one of ours, or another's.
struct ResultSystem {
  BenchSystem system;
  bool peer = false;
};

struct BenchResults {
  BenchConfig config;
  std::vector<ResultSystem> systems;                      ///< ours first
  std::vector<SequenceFacts> facts;                       ///< by sequence
  std::vector<std::vector<std::vector<RunResult>>> runs;  ///< [sequence][system][run]
  std::vector<std::string> machines, builds;              ///< that occur

  int own = 0;      ///< of `systems`, the first
  int missing = 0;  ///< cells that are not there

  /// Values of the runs that count.
  std::vector<double> values(std::size_t sequence, std::size_t system,
                             const FigureInfo& info) const;
  std::optional<Spread> spread(std::size_t sequence, std::size_t system,
                               const FigureInfo& info) const;
  /// The run with the median ATE among those that count (the lower of two); null if none does.
  const RunResult* typical(std::size_t sequence, std::size_t system) const;
  /// Every run that there is counts, and there is one.
  bool completes(std::size_t sequence, std::size_t system) const;
  /// Why no run counts: "never initialised", "not run". Empty if one does.
  std::string failure(std::size_t sequence, std::size_t system) const;
};

std::optional<Spread> spreadOf(const std::vector<double>& values);

/// Reads DIR. Cells that are missing or of another plan are "not run". Input error if there is no
/// bench.yaml.
Result<BenchResults> readBenchResults(const std::filesystem::path& dir);

}  // namespace svoscope
