// SPDX-License-Identifier: MIT
#include "ui/panels/export.h"

#include <cmath>

#include "engine/eval/estimate.h"
#include "ui/widgets/controls.h"

namespace svoscope::ui {

std::string trajectoryText(const std::vector<FrameRecord>& records) {
  const int map_id = mainMap(records);
  std::string text;
  for (const FrameRecord& r : records) {
    if (!hasPoseIn(r, map_id)) continue;
    const Vec3& t = r.T_world_cam.translation();
    const Eigen::Quaterniond& q = r.T_world_cam.quaternion();
    text += format("%.6f %.9f %.9f %.9f %.9f %.9f %.9f %.9f\n", r.timestamp, t.x(), t.y(), t.z(),
                   q.x(), q.y(), q.z(), q.w());
  }
  return text;
}

std::string framesCsv(const RunCache& run) {
  std::string text = "frame,timestamp,state,keyframe";
  for (const SeriesInfo& s : seriesTable()) text += std::string(",") + s.group + ": " + s.label;
  for (int s = 0; s < kStageCount; ++s) text += format(",%s ms", stageName(static_cast<Stage>(s)));
  text += "\n";
  for (std::size_t i = 0; i < run.records().size(); ++i) {
    const FrameRecord& r = run.records()[i];
    text += format("%d,%.6f,%s,%d", r.index, r.timestamp, stateName(r.state), r.is_keyframe);
    for (std::size_t s = 0; s < seriesTable().size(); ++s) {
      const float v = run.column(s)[i];
      text += std::isfinite(v) ? format(",%g", v) : ",";
    }
    for (const double ms : r.time_ms) text += format(",%.3f", ms);
    text += "\n";
  }
  return text;
}

}  // namespace svoscope::ui
