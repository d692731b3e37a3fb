// SPDX-License-Identifier: MIT
// The results of a benchmark: runs by sequence and system, and what is taken from several of them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/bench/bench_plan.h"
#include "engine/bench/cell_record.h"
#include "engine/report/run_figures.h"

namespace svoscope {

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

}  // namespace svoscope
