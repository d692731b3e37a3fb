// SPDX-License-Identifier: MIT
// A plane with one straight edge, seen by an ideal camera: the truth of segment tests.
#pragma once

#include <cmath>

#include "engine/frame/pyramid.h"
#include "engine/geometry/camera.h"
#include "engine/geometry/se3.h"

namespace svoscope::test {

struct EdgeWorld {
  Pinhole camera{320, 240, 260, 260, 159.5, 119.5};
  Vec3 a{-0.5, -0.35, 2.0}, b{0.6, 0.3, 2.8};  ///< on the edge, in the world
  Vec3 side{0.4, -0.8, 0.1};                   ///< spans the plane together with the edge
  double width = 0.006;                        ///< of the blurred step, map units

  PyramidPtr render(const SE3& T_cam_world) const {
    const Vec3 along = (b - a).normalized();
    const Vec3 across = (side - side.dot(along) * along).normalized(), normal = along.cross(across);
    const SE3 T = T_cam_world.inverse();
    cv::Mat image(camera.height, camera.width, CV_8U);
    for (int y = 0; y < image.rows; ++y) {
      for (int x = 0; x < image.cols; ++x) {
        const Vec3 ray = T.quaternion() * camera.unproject({double(x), double(y)});
        const double s = normal.dot(a - T.translation()) / normal.dot(ray);
        const double d = across.dot(T.translation() + s * ray - a);
        image.at<std::uint8_t>(y, x) =
            cv::saturate_cast<std::uint8_t>(70 + 110 / (1 + std::exp(-d / width)));
      }
    }
    return buildPyramid(image, 3);
  }
};

}  // namespace svoscope::test
