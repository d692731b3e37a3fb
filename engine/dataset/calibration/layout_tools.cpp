// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cctype>
#include <cmath>

#include "engine/dataset/calibration/layouts.h"

namespace svoscope {

namespace {

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

}  // namespace

void refuseModel(const std::string& key, const std::string& model) {
  throw CalibrationKeyError{key, "must be pinhole, not " + model,
                            "recalibrate as a pinhole camera with radtan or equidistant "
                            "distortion (Kalibr: pinhole-radtan, pinhole-equi)"};
}

Distortion distortionNamed(const std::string& name) {
  const std::string n = lower(name);
  const auto is = [&](std::initializer_list<const char*> names) {
    return std::find(names.begin(), names.end(), n) != names.end();
  };
  if (is({"none", "", "no_distortion"})) return Distortion::none;
  if (is({"radtan", "radial-tangential", "radialtangential", "plumb_bob", "plumb-bob", "opencv",
          "brown", "brown_conrady", "rational_polynomial", "pinhole", "full_opencv"}))
    return Distortion::radtan;
  if (is({"equidistant", "equi", "fisheye", "kannala_brandt", "kannalabrandt8", "kannala_brandt8",
          "kannalabrandt", "kb4", "opencv_fisheye"}))
    return Distortion::equidistant;
  if (is({"fov", "atan"})) return Distortion::fov;
  throw CalibrationKeyError{"distortion_model", "is unknown: " + name,
                            "known models are none, radtan, equidistant and fov"};
}

void setRadtan(const std::vector<double>& coefficients, Camera& camera) {
  camera.coefficients = coefficients;
  auto& c = camera.coefficients;
  while (!c.empty() && c.back() == 0) c.pop_back();
  camera.distortion = c.empty() ? Distortion::none : Distortion::radtan;
  if (c.empty()) return;
  const std::size_t size = c.size() <= 4 ? 4 : c.size() <= 5 ? 5 : 8;
  if (c.size() > 8)
    throw CalibrationKeyError{"distortion coefficients",
                              "number " + std::to_string(c.size()) + ", at most 8 are known",
                              "leave out thin prism and tilt: k1 k2 p1 p2 k3 k4 k5 k6"};
  c.resize(size, 0.0);
}

std::vector<double> matrixValues(const YAML::Node& node, const std::string& key) {
  if (!node) throw CalibrationKeyError{key, "is missing", ""};
  if (node.IsMap() && node["data"]) return matrixValues(node["data"], key);
  if (!node.IsSequence()) throw CalibrationKeyError{key, "is not a list of numbers", ""};
  std::vector<double> values;
  try {
    for (const YAML::Node& item : node) {
      if (item.IsSequence()) {
        for (const YAML::Node& v : item) values.push_back(v.as<double>());
      } else {
        values.push_back(item.as<double>());
      }
    }
  } catch (const YAML::Exception&) {
    throw CalibrationKeyError{key, "holds something that is not a number", ""};
  }
  return values;
}

SE3 rigidMotion(const std::vector<double>& v, const std::string& key) {
  if (v.size() != 16 && v.size() != 12)
    throw CalibrationKeyError{key, "must hold 16 numbers, a 4x4 matrix", ""};
  Mat3 R;
  R << v[0], v[1], v[2], v[4], v[5], v[6], v[8], v[9], v[10];
  if (!(R * R.transpose()).isIdentity(1e-2) || R.determinant() < 0)
    throw CalibrationKeyError{key, "is not a rigid motion", ""};
  const SE3 T(R, Vec3(v[3], v[7], v[11]));
  if (!T.finite()) throw CalibrationKeyError{key, "is not finite", ""};
  return T;
}

namespace {

SE3 poseOfParts(const YAML::Node& t) {
  const auto value = [&](const char* key) { return requiredValue<double>(t, key); };
  const Eigen::Quaterniond q(value("qw"), value("qx"), value("qy"), value("qz"));
  if (!(std::abs(q.norm() - 1) < 0.1))
    throw CalibrationKeyError{"T_imu_cam", "is not a rigid motion", ""};
  return SE3(q.normalized(), Vec3(value("px"), value("py"), value("pz")));
}

YAML::Node child(const YAML::Node& node, const char* key) {
  return node.IsDefined() && node.IsMap() ? node[key] : YAML::Node(YAML::NodeType::Undefined);
}

}  // namespace

std::optional<SE3> bodyPoseIn(const YAML::Node& root) {
  if (!root.IsMap()) return std::nullopt;
  const YAML::Node cam0 = child(root, "cam0"), kalibr = cam0 ? cam0 : root;
  if (const YAML::Node T = child(kalibr, "T_BS"))
    return rigidMotion(matrixValues(T, "T_BS"), "T_BS");
  if (const YAML::Node T = child(kalibr, "T_cam_imu"))
    return rigidMotion(matrixValues(T, "T_cam_imu"), "T_cam_imu").inverse();
  const YAML::Node cameras = child(root, "cameras");
  if (cameras && cameras.IsSequence() && cameras.size() > 0) {
    if (const YAML::Node T = child(cameras[0], "T_B_C"))
      return rigidMotion(matrixValues(T, "T_B_C"), "T_B_C");
  }
  const YAML::Node basalt = child(child(root, "value0"), "T_imu_cam");
  if (basalt && basalt.IsSequence() && basalt.size() > 0) return poseOfParts(basalt[0]);
  return std::nullopt;
}

}  // namespace svoscope
