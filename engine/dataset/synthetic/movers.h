// SPDX-License-Identifier: MIT
// Textured boxes that move through a scene on their own: a stress for the tracker, exact in depth.
#pragma once

#include <functional>
#include <vector>

#include "engine/dataset/synthetic/scene.h"
#include "engine/dataset/synthetic/spec.h"
#include "engine/geometry/se3.h"

namespace svoscope::synthetic {

struct Mover {
  std::vector<Quad> quads;  ///< own frame: standing on z = 0, centred; textures of the scene
  std::function<SE3(double)> motion;  ///< T_world_mover at a time in s
};

/// `spec.movers` boxes that suit the preset: people in rooms and corridors, vehicles in the street,
/// things on the desk. Adds their textures to `scene`. Their motion does not depend on `speed`,
/// except where they keep company with a camera that drives or walks along.
std::vector<Mover> buildMovers(const SyntheticSpec& spec, Scene& scene);

}  // namespace svoscope::synthetic
