// SPDX-License-Identifier: MIT
// What the open runs have in common: metrics of each so far, their paths in one frame of reference,
// and how far they are apart.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "engine/eval/run_metrics.h"
#include "ui/model/run_cache.h"
#include "ui/model/runs.h"
#include "ui/model/truth.h"

namespace svoscope::ui {

struct ComparedRun {
  RunStyle style;
  RunMetrics metrics;             ///< of the rows so far; without map and fps
  TruthState truth;               ///< against ground truth; not valid without
  std::vector<float> frames;      ///< index of each row: x of the columns below
  std::vector<Vec3f> path;        ///< position per row in the common frame; NaN if unknown
  std::vector<float> error;       ///< distance from ground truth, m; NaN if unknown
  std::vector<float> difference;  ///< distance from the current run's position; NaN if unknown
  std::vector<float> inliers, time_ms;  ///< NaN for trajectories
  std::vector<int> losses;              ///< rows at which tracking was lost
  bool aligned = false;                 ///< path is known
  std::string problem;                  ///< why not, if there are poses
};

/// Rows and truth of a run, as the inspector keeps them.
struct CompareSource {
  const RunCache* rows = nullptr;
  Truth* truth = nullptr;
};

class CompareData {
 public:
  /// Recomputes if anything changed; while frames keep coming (not `settled`), every tenth.
  void update(const Runs& runs, const std::vector<CompareSource>& sources, Alignment mode,
              bool settled);

  const std::vector<ComparedRun>& runs() const { return runs_; }
  /// Paths are in metres (aligned to ground truth); else in map units of the current run.
  bool metric() const { return metric_; }
  /// Ground truth up to now in the common frame; empty if there is none.
  const std::vector<Vec3f>& truthPath() const { return truth_path_; }
  std::uint64_t version() const { return version_; }  ///< changes with the content

 private:
  struct Key {
    int frame = -2, generations = 0, current = -1;
    Alignment mode = Alignment::sim3;
    bool sameButFrame(const Key& o) const {
      return generations == o.generations && current == o.current && mode == o.mode;
    }
  };
  void toTruth(const std::vector<CompareSource>& sources, const Trajectory& truth, int current);
  void toCurrent(const std::vector<CompareSource>& sources, int current, Alignment mode);
  void differences(int current);

  std::vector<ComparedRun> runs_;
  std::vector<Vec3f> truth_path_;
  bool metric_ = false;
  std::uint64_t version_ = 0;
  Key key_;
};

/// Row of a frame in increasing `frames`; -1 if there is none.
int rowOf(const std::vector<float>& frames, int frame);

/// One column per run: what the metric table shows, and its CSV.
struct MetricRow {
  std::string name, hint;
  std::vector<std::string> values;  ///< "–" if not defined
  int best = -1;                    ///< column of the best value; -1: none, or all the same
};
std::vector<MetricRow> metricRows(const CompareData& data, bool ground_truth);
std::string metricsCsv(const CompareData& data, bool ground_truth);
/// Frame, then error, difference, inliers and time of each run.
std::string compareCsv(const CompareData& data);
/// Frame, run and position in the common frame.
std::string pathsCsv(const CompareData& data);

}  // namespace svoscope::ui
