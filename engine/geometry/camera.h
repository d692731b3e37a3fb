// SPDX-License-Identifier: MIT
// Camera models. Camera frame: x right, y down, z forward. Pixel centres lie at integer
// coordinates. The engine works on rectified images: Pinhole only; Camera adds the lens
// distortion of the images as they come from disk and is used to rectify them
// (engine/frame/rectifier.h).
#pragma once

#include <string>
#include <vector>

#include "engine/base/result.h"
#include "engine/base/types.h"

namespace svoscope {

/// Ideal pinhole of the rectified image.
struct Pinhole {
  int width = 0, height = 0;              ///< px
  double fx = 0, fy = 0, cx = 0, cy = 0;  ///< px

  /// Pixel of a point in the camera frame; z must be positive.
  Vec2 project(const Vec3& p) const {
    const double iz = 1.0 / p.z();
    return {fx * p.x() * iz + cx, fy * p.y() * iz + cy};
  }
  /// Point on the plane z = 1 seen at a pixel.
  Vec3 unproject(const Vec2& px) const { return {(px.x() - cx) / fx, (px.y() - cy) / fy, 1.0}; }
  /// Unit bearing of a pixel.
  Vec3 bearing(const Vec2& px) const { return unproject(px).normalized(); }
  /// d project / d p, px per unit of p.
  Mat23 projectJacobian(const Vec3& p) const {
    const double iz = 1.0 / p.z(), iz2 = iz * iz;
    Mat23 J;
    J << fx * iz, 0, -fx * p.x() * iz2, 0, fy * iz, -fy * p.y() * iz2;
    return J;
  }
  /// Mean focal length, px: one pixel is about 1 / focal() radians.
  double focal() const { return 0.5 * (fx + fy); }
  /// True if px lies at least `border` px inside the image.
  bool inside(const Vec2& px, double border) const {
    return px.x() >= border && px.y() >= border && px.x() < width - 1 - border &&
           px.y() < height - 1 - border;
  }
};

enum class Distortion { none, radtan, equidistant, fov };

/// Camera of the images on disk: pinhole with lens distortion.
/// radtan: k1 k2 p1 p2 [k3] (Brown-Conrady), with k4 k5 k6 the rational model of OpenCV;
/// equidistant: k1..k4 (Kannala-Brandt);
/// fov: one coefficient w in radians (Devernay-Faugeras).
struct Camera {
  Pinhole pinhole;
  Distortion distortion = Distortion::none;
  std::vector<double> coefficients;
  double rate_hz = 0;  ///< nominal frame rate, 0 if unknown

  /// Pixel of a point in the camera frame (z > 0), distortion applied.
  Vec2 project(const Vec3& p) const;
  /// Point on the plane z = 1 seen at a distorted pixel (iterative for radtan and
  /// equidistant). Not finite where the model has no inverse.
  Vec3 unproject(const Vec2& px) const;
  /// The error names the field that is wrong: resolution, focal length, coefficient count, NaN.
  Status check() const;
};

/// Parses "none", "radtan" ("plumb_bob"), "equidistant" ("kannala_brandt"), "fov".
Result<Distortion> parseDistortion(const std::string& name);
const char* distortionName(Distortion d);

/// Built-in calibrations "tum-fr1", "tum-fr2", "tum-fr3" (TUM RGB-D benchmark, published values).
Result<Camera> cameraPreset(const std::string& name);

}  // namespace svoscope
