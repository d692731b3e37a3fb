// SPDX-License-Identifier: MIT
// Renders a scene of textured rectangles: exact perspective, filtered textures, smooth silhouettes.
#pragma once

#include <opencv2/core/mat.hpp>

#include "engine/dataset/synthetic/scene.h"
#include "engine/geometry/camera.h"
#include "engine/geometry/se3.h"

namespace svoscope::synthetic {

struct View {
  cv::Mat gray;   ///< CV_32FC1, grey levels, not rounded
  cv::Mat depth;  ///< CV_32FC1, z at the pixel centres, m; 0 where nothing is hit
};

/// The view of a camera at T_world_cam. `extra` are further quads given in the camera frame.
View render(const Scene& scene, const Pinhole& camera, const SE3& T_world_cam,
            const std::vector<Quad>& extra = {});

/// Depth only: what render() puts into View::depth.
cv::Mat renderDepth(const Scene& scene, const Pinhole& camera, const SE3& T_world_cam,
                    const std::vector<Quad>& extra = {});

}  // namespace svoscope::synthetic
