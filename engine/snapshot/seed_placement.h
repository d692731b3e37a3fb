// SPDX-License-Identifier: MIT
// Where a seed's belief lies in the world and in the image: follows from the belief and the poses,
// and so is computed alike when a snapshot is built and when it is read from a recording.
#pragma once

#include "engine/snapshot/snapshot.h"

namespace svoscope {

struct SeedPlacement {
  SE3 T_world_kf;   ///< of the seed's keyframe
  SE3 T_cam_world;  ///< of the frame
  const Pinhole& camera;
  double search_sigmas = 3;  ///< half width of the span, standard deviations
  bool wanted = true;        ///< off: the seed is left as it is
};

/// Fills visible, px, px_near, px_far, position, position_near, position_far and, for segments,
/// position_end from px_ref, mu, sigma, px_ref_end and mu_end.
void placeSeed(SeedView& seed, const SeedPlacement& placement);

}  // namespace svoscope
