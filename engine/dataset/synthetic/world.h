// SPDX-License-Identifier: MIT
// What a preset consists of: a scene, a lens and a motion.
#pragma once

#include <functional>

#include "engine/dataset/synthetic/movers.h"
#include "engine/dataset/synthetic/scene.h"
#include "engine/dataset/synthetic/spec.h"
#include "engine/geometry/se3.h"

namespace svoscope::synthetic {

struct World {
  /// An empty world whose textures suit the image size asked for.
  World(const SyntheticSpec& spec, double width, double focal_px);

  Scene scene;
  double focal = 525;                 ///< px at the preset's own width
  double preset_width = 640;          ///< px
  std::function<SE3(double)> motion;  ///< T_world_cam at a time in s, before `speed`
  std::vector<Mover> movers;
};

/// Builds the preset of the specification, which must come from parseSyntheticSpec().
World buildWorld(const SyntheticSpec& spec);

World buildRoom(const SyntheticSpec& spec);  ///< room, still, spin
World buildDesk(const SyntheticSpec& spec);
World buildFloor(const SyntheticSpec& spec);
World buildCorridor(const SyntheticSpec& spec);
World buildStreet(const SyntheticSpec& spec);

}  // namespace svoscope::synthetic
