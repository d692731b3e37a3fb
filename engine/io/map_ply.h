// SPDX-License-Identifier: MIT
// The map as a point cloud that common viewers open.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "engine/base/result.h"
#include "engine/snapshot/snapshot.h"

namespace svoscope {

/// ASCII PLY: x y z (world, map scale), sigma (of inverse depth), observations (keyframes that see
/// the point), kind (0 corner, 1 edgelet, 2 segment end point; a segment is two rows in a row),
/// reference_keyframe. `rule` is the
/// seeds' update rule, kept as a comment. Output error naming the file.
Status writeMapPly(const std::filesystem::path& file, const std::vector<MapPointView>& points,
                   const std::string& rule);

}  // namespace svoscope
