// SPDX-License-Identifier: MIT
#include "engine/io/map_ply.h"

#include <fmt/format.h>

#include "engine/io/text_output.h"

namespace svoscope {

Status writeMapPly(const std::filesystem::path& file, const std::vector<MapPointView>& points,
                   const std::string& rule) {
  std::string rows;
  std::size_t count = 0;
  const auto add = [&](const MapPointView& point, const Vec3f& p) {
    rows += fmt::format("{:.9g} {:.9g} {:.9g} {:.6g} {} {} {}\n", p.x(), p.y(), p.z(), point.sigma,
                        point.observations, static_cast<int>(point.type), point.reference_keyframe);
    ++count;
  };
  for (const MapPointView& point : points) {
    add(point, point.position);
    if (point.type == FeatureType::segment) add(point, point.position_end);
  }
  const std::string header = fmt::format(
      "ply\nformat ascii 1.0\n"
      "comment positions in the world frame, unit of the map\n"
      "comment sigma of the inverse depth when promoted\n"
      "comment kind 0 corner, 1 edgelet, 2 segment end point; the two ends of a segment follow "
      "each other\n"
      "comment seed rule {}\n"
      "element vertex {}\n"
      "property float x\nproperty float y\nproperty float z\n"
      "property float sigma\nproperty int observations\nproperty uchar kind\n"
      "property int reference_keyframe\nend_header\n",
      rule, count);
  return writeWhole(file, header + rows);
}

}  // namespace svoscope
