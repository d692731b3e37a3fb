// SPDX-License-Identifier: MIT
#include "engine/report/run_figures.h"

namespace svoscope {

const std::vector<FigureInfo>& figureTable() {
  using F = RunFigures;
  static const std::vector<FigureInfo> table = {
      {"rpe_trans_m", "RPE trans", "m", 4, &F::rpe_trans_m, true},
      {"rpe_rot_rad", "RPE rot", "rad", 4, &F::rpe_rot_rad, true},
      {"ate_m", "ATE rmse", "m", 4, &F::ate_m, true},
      {"ate_median_m", "ATE median", "m", 4, &F::ate_median_m, true},
      {"ate_max_m", "ATE max", "m", 4, &F::ate_max_m, true},
      {"scale", "Scale", "", 4, &F::scale, true},
      {"tracked", "Tracked", "", 3, &F::tracked, false},
      {"init_time_s", "Initialisation time", "s", 2, &F::init_time_s, true},
      {"init_frame", "First frame with a pose", "", 0, &F::init_frame, true},
      {"keyframes", "Keyframes", "", 0, &F::keyframes, true},
      {"losses", "Losses", "", 1, &F::losses, true},
      {"relocalisations", "Relocalisations", "", 1, &F::relocalisations, false},
      {"relocalisation_time_s", "Relocalisation time", "s", 3, &F::relocalisation_time_s, true},
      {"fps", "Frames per second", "1/s", 0, &F::fps, false},
      {"tracking_ms", "Tracking time", "ms", 2, &F::tracking_ms, true},
      {"mapping_ms", "Mapping time", "ms", 2, &F::mapping_ms, true},
      {"points", "Points of the map", "", 0, &F::points, false},
      {"segments", "Segments of the map", "", 0, &F::segments, false},
      {"memory_mb", "Largest memory", "MiB", 0, &F::memory_mb, true},
      {"frames", "Frames", "", 0, &F::frames, false}};
  return table;
}

const FigureInfo& figure(const std::string& key) {
  for (const FigureInfo& info : figureTable()) {
    if (key == info.key) return info;
  }
  return figureTable().front();
}

}  // namespace svoscope
