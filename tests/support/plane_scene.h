// SPDX-License-Identifier: MIT
// A pinhole camera looking at one textured plane: exact images, depths and points.
#pragma once

#include <opencv2/core/mat.hpp>
#include <vector>

#include "engine/frame/pyramid.h"
#include "engine/geometry/camera.h"
#include "engine/geometry/se3.h"

namespace svoscope::test {

/// Gain and offset applied to the rendered grey levels.
struct Light {
  double gain = 1, offset = 0;
};

class PlaneScene {
 public:
  /// The plane normal . p = distance in the world; the texture is a sum of waves whose shortest is
  /// `wavelength` map units.
  PlaneScene(const Pinhole& camera, const Vec3& normal, double distance, double wavelength,
             unsigned seed = 1);

  const Pinhole& camera() const { return camera_; }
  /// CV_8UC1, one exact sample at each pixel centre.
  cv::Mat render(const SE3& T_cam_world, Light light = {}) const;
  PyramidPtr pyramid(const SE3& T_cam_world, int levels, Light light = {}) const {
    return buildPyramid(render(T_cam_world, light), levels);
  }
  /// The point of the plane seen at a pixel, in the world.
  Vec3 point(const SE3& T_cam_world, const Vec2& px) const;
  /// z of that point in the camera, and its inverse distance along the ray.
  double depth(const SE3& T_cam_world, const Vec2& px) const {
    return (T_cam_world * point(T_cam_world, px)).z();
  }
  double inverseDistance(const SE3& T_cam_world, const Vec2& px) const {
    return 1.0 / (T_cam_world * point(T_cam_world, px)).norm();
  }

 private:
  struct Wave {
    double u, v, phase, amplitude;
  };
  double grey(const Vec3& p_world) const;

  Pinhole camera_;
  Vec3 normal_, axis_u_, axis_v_;
  double distance_;
  std::vector<Wave> waves_;
};

/// 320 x 240, focal length 300 px.
Pinhole smallCamera();

/// Pixels of a regular grid, `border` px from the sides.
std::vector<Vec2> gridPixels(const Pinhole& camera, int step, int border);

/// Angle between two rotations, degrees.
double angleDeg(const SE3& a, const SE3& b);

}  // namespace svoscope::test
