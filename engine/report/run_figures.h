// SPDX-License-Identifier: MIT
// The figures of a run that a report shows, and how they are called.
#pragma once

#include <optional>
#include <string>
#include <vector>

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

}  // namespace svoscope
