// SPDX-License-Identifier: MIT
#include "engine/dataset/synthetic/motion.h"

#include <cmath>

namespace svoscope::synthetic {

SE3 lookAt(const Vec3& eye, const Vec3& target, double roll) {
  const Vec3 forward = (target - eye).normalized();
  const Vec3 right = forward.cross(Vec3::UnitZ()).normalized();
  Mat3 R;
  R << right, forward.cross(right), forward;
  const Eigen::Quaterniond about_axis(Eigen::AngleAxisd(roll, Vec3::UnitZ()));
  return SE3(Eigen::Quaterniond(R) * about_axis, eye);
}

SE3 lookDown(const Vec3& eye, double yaw, double tilt_x, double tilt_y) {
  const Eigen::Quaterniond q = Eigen::Quaterniond(Eigen::AngleAxisd(yaw, Vec3::UnitZ())) *
                               Eigen::Quaterniond(Eigen::AngleAxisd(M_PI, Vec3::UnitX())) *
                               so3Exp(Vec3(tilt_x, tilt_y, 0));
  return SE3(q, eye);
}

Vec3 handShake(double t, double phase) {
  const auto wave = [&](double f1, double f2, double f3, double shift) {
    const double p = phase + shift;
    return 0.55 * std::sin(2 * M_PI * f1 * t + p) + 0.3 * std::sin(2 * M_PI * f2 * t + 2.3 * p) +
           0.15 * std::sin(2 * M_PI * f3 * t + 3.1 * p);
  };
  return {wave(0.31, 0.83, 1.73, 0.0), wave(0.37, 0.71, 1.91, 1.3), wave(0.29, 0.93, 1.57, 2.1)};
}

SE3 roomMotion(double t) {
  const double angle = -1.9 + 0.85 * std::sin(0.55 * t);
  const double radius = 1.9 + 0.2 * std::sin(0.63 * t + 0.5);
  const Vec3 shake = handShake(t, 0.4), look = handShake(t, 2.2);
  const Vec3 eye(radius * std::cos(angle) + 0.05 * shake.x(),
                 radius * std::sin(angle) + 0.05 * shake.y(),
                 1.35 + 0.25 * std::sin(0.5 * t) + 0.04 * shake.z());
  const Vec3 target(0.45 * std::sin(0.8 * t + 0.7) + 0.06 * look.x(), 0.4 + 0.06 * look.y(),
                    0.75 + 0.15 * std::sin(0.9 * t) + 0.06 * look.z());
  return lookAt(eye, target, 0.05 * std::sin(0.7 * t) + 0.015 * look.x());
}

SE3 spinMotion(double t) {
  // The turn sets in slowly: a monocular system has to see some translation first.
  const double angle = M_PI / 2 + 0.42 * (t - 1.5 * std::tanh(t / 1.5));
  const Vec3 shake = handShake(t, 1.1);
  const Vec3 eye(0.22 * std::sin(1.2 * t), 0.1 * std::sin(0.8 * t) + 0.02 * shake.y(),
                 1.4 + 0.08 * std::sin(0.9 * t));
  const Vec3 ray(std::cos(angle), std::sin(angle), -0.18 + 0.06 * std::sin(0.6 * t));
  return lookAt(eye, eye + ray, 0.04 * std::sin(0.5 * t));
}

SE3 deskMotion(double t) {
  const Vec3 shake = handShake(t, 0.9);
  const Vec3 eye(0.32 * std::sin(0.95 * t) + 0.01 * shake.x(),
                 -1.25 + 0.18 * std::sin(0.61 * t + 2.8) + 0.01 * shake.y(),
                 1.4 + 0.2 * std::sin(1.27 * t + 1.2) + 0.01 * shake.z());
  // The target moves along: the camera translates and turns by a degree or two only.
  const Vec3 target = Vec3(eye.x(), 0.0, eye.z() - 0.62) + 0.02 * handShake(t, 2.9);
  return lookAt(eye, target, 0.01 * shake.y());
}

SE3 floorMotion(double t) {
  const Vec3 shake = handShake(t, 1.7);
  const Vec3 eye(3.0 * std::sin(0.4 * t), 2.2 * std::sin(0.55 * t + 0.3),
                 1.9 + 0.35 * std::sin(0.5 * t));
  const double yaw = 0.4 * std::sin(0.35 * t) + 0.15 * std::sin(0.9 * t);
  return lookDown(eye, yaw, 0.08 * std::sin(0.7 * t) + 0.01 * shake.x(),
                  0.08 * std::cos(0.6 * t) + 0.01 * shake.y());
}

SE3 corridorMotion(double t) {
  const double step = 2 * M_PI * 0.9;  // rad/s, one stride is two steps
  const Vec3 shake = handShake(t, 0.2);
  const Vec3 eye(1.1 * t, 0.2 * std::sin(0.5 * t) + 0.025 * std::sin(step * t),
                 1.5 + 0.02 * std::sin(2 * step * t));
  const double yaw = 0.09 * std::sin(0.6 * t) + 0.012 * shake.x();
  const double pitch = -0.05 + 0.03 * std::sin(0.8 * t) + 0.008 * shake.y();
  const Vec3 ray(std::cos(yaw), std::sin(yaw), pitch);
  return lookAt(eye, eye + ray, 0.01 * std::sin(step * t));
}

SE3 streetMotion(double t) {
  const Vec3 eye(8.0 * t, 0.5 * std::sin(0.25 * t), 1.65 + 0.01 * std::sin(7.0 * t));
  const double yaw = 0.02 * std::sin(0.25 * t + 1.2) + 0.03 * std::sin(0.17 * t);
  const Vec3 ray(std::cos(yaw), std::sin(yaw), -0.02 + 0.004 * std::sin(6.0 * t));
  return lookAt(eye, eye + ray, 0.006 * std::sin(2.0 * t));
}

}  // namespace svoscope::synthetic
