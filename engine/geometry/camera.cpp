// SPDX-License-Identifier: MIT
#include "engine/geometry/camera.h"

#include <cmath>
#include <limits>

namespace svoscope {
namespace {

const double kPi = 3.14159265358979323846;
const double kNaN = std::numeric_limits<double>::quiet_NaN();
const int kMaxIterations = 50;

/// Radial factor (1 + k1 u + k2 u^2 + k3 u^3) / (1 + k4 u + k5 u^2 + k6 u^3) and its derivative in
/// u = r^2.
struct Radial {
  double value = 1, slope = 0;
};
Radial radialPart(const std::vector<double>& k, double u) {
  const double k3 = k.size() > 4 ? k[4] : 0.0;
  const double above = 1.0 + u * (k[0] + u * (k[1] + u * k3));
  const double d_above = k[0] + u * (2.0 * k[1] + u * 3.0 * k3);
  if (k.size() < 8) return {above, d_above};
  const double below = 1.0 + u * (k[5] + u * (k[6] + u * k[7]));
  const double d_below = k[5] + u * (2.0 * k[6] + u * 3.0 * k[7]);
  return {above / below, (d_above * below - above * d_below) / (below * below)};
}

/// d of r times the radial factor; u = r^2. Not positive: the lens model folds back and pixels
/// there have no unique ray.
double radialSlope(const std::vector<double>& k, double u) {
  const Radial radial = radialPart(k, u);
  return radial.value + 2.0 * u * radial.slope;
}

Vec2 distortRadtan(const std::vector<double>& k, const Vec2& x, Mat2* J) {
  const double p1 = k[2], p2 = k[3];
  const double u = x.squaredNorm(), a = x.x(), b = x.y();
  const auto [radial, slope] = radialPart(k, u);
  if (J) {
    *J << radial + 2 * a * a * slope + 2 * p1 * b + 6 * p2 * a,
        2 * a * b * slope + 2 * p1 * a + 2 * p2 * b,  //
        2 * a * b * slope + 2 * p1 * a + 2 * p2 * b,
        radial + 2 * b * b * slope + 6 * p1 * b + 2 * p2 * a;
  }
  return {a * radial + 2 * p1 * a * b + p2 * (u + 2 * a * a),
          b * radial + p1 * (u + 2 * b * b) + 2 * p2 * a * b};
}

/// True if the radial part grows all the way from the centre to radius sqrt(u).
bool onFirstBranch(const std::vector<double>& k, double u) {
  for (int i = 1; i <= 16; ++i)
    if (radialSlope(k, u * i / 16.0) <= 0) return false;
  return true;
}

/// Newton's method with step halving: a full step may leave the branch that holds the solution.
Vec2 undistortRadtan(const std::vector<double>& k, const Vec2& target) {
  Vec2 x = Vec2::Zero(), residual = -target;
  Mat2 J;
  for (int i = 0; i < kMaxIterations && residual.norm() > 1e-13; ++i) {
    distortRadtan(k, x, &J);
    const Vec2 step = -(J.inverse() * residual);
    double scale = 1.0;
    bool better = false;
    for (; scale > 1e-4 && !better; scale *= 0.5) {
      const Vec2 candidate = x + scale * step;
      const Vec2 r = distortRadtan(k, candidate, nullptr) - target;
      if (r.norm() < residual.norm() && radialSlope(k, candidate.squaredNorm()) > 0) {
        x = candidate;
        residual = r;
        better = true;
      }
    }
    if (!better) break;
  }
  if (!(residual.norm() < 1e-9) || !onFirstBranch(k, x.squaredNorm())) return {kNaN, kNaN};
  return x;
}

double distortedAngle(const std::vector<double>& k, double theta, double* slope) {
  const double u = theta * theta;
  if (slope) *slope = 1 + u * (3 * k[0] + u * (5 * k[1] + u * (7 * k[2] + u * 9 * k[3])));
  return theta * (1 + u * (k[0] + u * (k[1] + u * (k[2] + u * k[3]))));
}

Vec2 distortEquidistant(const std::vector<double>& k, const Vec2& x) {
  const double r = x.norm();
  if (r < 1e-12) return x;
  return x * (distortedAngle(k, std::atan(r), nullptr) / r);
}

Vec2 undistortEquidistant(const std::vector<double>& k, const Vec2& target) {
  const double rd = target.norm();
  if (rd < 1e-12) return target;
  double theta = std::min(rd, 0.5 * kPi), slope = 1;
  for (int i = 0; i < kMaxIterations; ++i) {
    const double error = distortedAngle(k, theta, &slope) - rd;
    if (!(slope > 0)) break;
    theta -= error / slope;
    if (std::abs(error) < 1e-14) break;
  }
  const double error = distortedAngle(k, theta, &slope) - rd;
  // Rays at 90 degrees and beyond never meet the plane z = 1.
  if (!(std::abs(error) < 1e-9) || !(slope > 0) || !(theta > 0) || theta >= 0.5 * kPi)
    return {kNaN, kNaN};
  return target * (std::tan(theta) / rd);
}

Vec2 distortFov(double w, const Vec2& x) {
  const double r = x.norm();
  if (r < 1e-12) return x * (2.0 * std::tan(0.5 * w) / w);
  return x * (std::atan(2.0 * r * std::tan(0.5 * w)) / (w * r));
}

Vec2 undistortFov(double w, const Vec2& target) {
  const double rd = target.norm(), scale = 2.0 * std::tan(0.5 * w);
  if (rd < 1e-12) return target * (w / scale);
  if (rd * w >= 0.5 * kPi) return {kNaN, kNaN};
  return target * (std::tan(rd * w) / (scale * rd));
}

bool countFits(Distortion d, size_t n) {
  switch (d) {
    case Distortion::none:
      return n == 0;
    case Distortion::radtan:
      return n == 4 || n == 5 || n == 8;
    case Distortion::equidistant:
      return n == 4;
    case Distortion::fov:
      return n == 1;
  }
  return false;
}

const char* expectedCount(Distortion d) {
  switch (d) {
    case Distortion::none:
      return "none has no coefficients";
    case Distortion::radtan:
      return "radtan has 4, 5 or 8 coefficients: k1 k2 p1 p2 [k3 [k4 k5 k6]]";
    case Distortion::equidistant:
      return "equidistant has 4 coefficients: k1 k2 k3 k4";
    case Distortion::fov:
      return "fov has 1 coefficient: w in radians";
  }
  return "";
}

}  // namespace

Vec2 Camera::project(const Vec3& p) const {
  Vec2 x = p.head<2>() / p.z();
  switch (distortion) {
    case Distortion::none:
      break;
    case Distortion::radtan:
      x = distortRadtan(coefficients, x, nullptr);
      break;
    case Distortion::equidistant:
      x = distortEquidistant(coefficients, x);
      break;
    case Distortion::fov:
      x = distortFov(coefficients[0], x);
      break;
  }
  return {pinhole.fx * x.x() + pinhole.cx, pinhole.fy * x.y() + pinhole.cy};
}

Vec3 Camera::unproject(const Vec2& px) const {
  Vec2 x = pinhole.unproject(px).head<2>();
  switch (distortion) {
    case Distortion::none:
      break;
    case Distortion::radtan:
      x = undistortRadtan(coefficients, x);
      break;
    case Distortion::equidistant:
      x = undistortEquidistant(coefficients, x);
      break;
    case Distortion::fov:
      x = undistortFov(coefficients[0], x);
      break;
  }
  return {x.x(), x.y(), 1.0};
}

Status Camera::check() const {
  const char* const where = "camera calibration";
  const auto wrong = [&](const std::string& what, const std::string& remedy) {
    return inputError(what, where, remedy);
  };
  if (pinhole.width <= 0 || pinhole.height <= 0)
    return wrong("resolution " + std::to_string(pinhole.width) + " x " +
                     std::to_string(pinhole.height) + " is not positive",
                 "resolution is [width, height] in pixels");
  const bool focal_ok =
      std::isfinite(pinhole.fx) && std::isfinite(pinhole.fy) && pinhole.fx > 0 && pinhole.fy > 0;
  if (!focal_ok)
    return wrong("the focal length is not positive", "intrinsics are [fx, fy, cx, cy] in pixels");
  if (!std::isfinite(pinhole.cx) || !std::isfinite(pinhole.cy))
    return wrong("the principal point is not finite", "intrinsics are [fx, fy, cx, cy] in pixels");
  if (!countFits(distortion, coefficients.size()))
    return wrong(std::to_string(coefficients.size()) + " distortion coefficients",
                 expectedCount(distortion));
  for (double c : coefficients)
    if (!std::isfinite(c))
      return wrong("a distortion coefficient is not finite", expectedCount(distortion));
  if (distortion == Distortion::fov && !(coefficients[0] > 1e-6 && coefficients[0] < kPi))
    return wrong("the distortion angle w is outside 0..pi", expectedCount(distortion));
  if (!std::isfinite(rate_hz) || rate_hz < 0)
    return wrong("rate_hz is negative or not finite", "rate_hz is the frame rate, 0 if unknown");
  return Done{};
}

Result<Distortion> parseDistortion(const std::string& name) {
  if (name == "none") return Distortion::none;
  if (name == "radtan" || name == "plumb_bob") return Distortion::radtan;
  if (name == "equidistant" || name == "kannala_brandt") return Distortion::equidistant;
  if (name == "fov") return Distortion::fov;
  return inputError("unknown distortion model '" + name + "'", "camera calibration",
                    "known models are none, radtan (plumb_bob), equidistant (kannala_brandt), fov");
}

const char* distortionName(Distortion d) {
  switch (d) {
    case Distortion::none:
      return "none";
    case Distortion::radtan:
      return "radtan";
    case Distortion::equidistant:
      return "equidistant";
    case Distortion::fov:
      return "fov";
  }
  return "none";
}

Result<Camera> cameraPreset(const std::string& name) {
  Camera camera;
  camera.rate_hz = 30;
  if (name == "tum-fr1") {
    camera.pinhole = {640, 480, 517.306408, 516.469215, 318.643040, 255.313989};
    camera.distortion = Distortion::radtan;
    camera.coefficients = {0.262383, -0.953104, -0.005358, 0.002628, 1.163314};
  } else if (name == "tum-fr2") {
    camera.pinhole = {640, 480, 520.908620, 521.007327, 325.141442, 249.701764};
    camera.distortion = Distortion::radtan;
    camera.coefficients = {0.231222, -0.784899, -0.003257, -0.000105, 0.917205};
  } else if (name == "tum-fr3") {
    camera.pinhole = {640, 480, 535.4, 539.2, 320.1, 247.6};
  } else {
    return inputError("unknown camera preset '" + name + "'", "camera calibration",
                      "presets are tum-fr1, tum-fr2, tum-fr3");
  }
  return camera;
}

}  // namespace svoscope
