// SPDX-License-Identifier: MIT
#include "ui/panels/export.h"

#include "engine/eval/estimate.h"
#include "engine/io/frames_csv.h"
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
  std::string text = framesCsvHeader() + "\n";
  for (const FrameRecord& record : run.records()) text += framesCsvRow(record) + "\n";
  return text;
}

}  // namespace svoscope::ui
