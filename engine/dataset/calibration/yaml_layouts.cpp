// SPDX-License-Identifier: MIT
// Layouts with names of their own for everything: Kalibr and ASL, ROS, OpenCV, ORB-SLAM.
#include <cmath>

#include "engine/dataset/calibration/layouts.h"

namespace svoscope {

namespace {

bool isMap(const CalibrationSource& s) { return s.root.IsDefined() && s.root.IsMap(); }

bool has(const YAML::Node& node, const char* key) { return node.IsMap() && node[key]; }

// ---- Kalibr camchain and ASL sensor.yaml

YAML::Node firstCamera(const YAML::Node& root) {
  return root["cam0"] ? YAML::Node(root["cam0"]) : root;
}

bool isKalibr(const CalibrationSource& s) {
  if (!isMap(s)) return false;
  const YAML::Node cam = s.root["cam0"] ? YAML::Node(s.root["cam0"]) : s.root;
  return has(cam, "intrinsics");
}

void setBody(const YAML::Node& root, Calibration& result) {
  const auto T_body_cam = bodyPoseIn(root);
  result.has_body = T_body_cam.has_value();
  if (T_body_cam) result.T_body_cam = *T_body_cam;
}

void readKalibr(const CalibrationSource& s, Calibration& result) {
  const YAML::Node cam = firstCamera(s.root);
  const std::string model =
      has(cam, "camera_model") ? requiredValue<std::string>(cam, "camera_model") : "pinhole";
  if (model != "pinhole") refuseModel("camera_model", model);
  const auto k = requiredValue<std::vector<double>>(cam, "intrinsics");
  if (k.size() != 4)
    throw CalibrationKeyError{"intrinsics", "must hold 4 numbers: fx, fy, cx, cy", ""};
  const auto size = requiredValue<std::vector<int>>(cam, "resolution");
  if (size.size() != 2)
    throw CalibrationKeyError{"resolution", "must hold 2 numbers: width, height", ""};
  Camera& camera = result.camera;
  camera.pinhole = {size[0], size[1], k[0], k[1], k[2], k[3]};
  camera.distortion = distortionNamed(requiredValue<std::string>(cam, "distortion_model"));
  if (camera.distortion != Distortion::none) {
    const char* key =
        has(cam, "distortion_coeffs") ? "distortion_coeffs" : "distortion_coefficients";
    camera.coefficients = requiredValue<std::vector<double>>(cam, key);
  }
  if (has(cam, "rate_hz")) camera.rate_hz = requiredValue<double>(cam, "rate_hz");
  setBody(s.root, result);
}

// ---- ROS camera_info

bool isRos(const CalibrationSource& s) {
  // OpenCV's own files have the same keys but none of these.
  const bool of_ros = isMap(s) && (has(s.root, "distortion_model") || has(s.root, "camera_name") ||
                                   has(s.root, "projection_matrix"));
  return of_ros && has(s.root, "image_width") && has(s.root, "camera_matrix");
}

/// fx, fy, cx, cy of a 3x3 matrix.
void setMatrix(const std::vector<double>& k, const char* key, Pinhole& p) {
  if (k.size() != 9) throw CalibrationKeyError{key, "must hold 9 numbers, a 3x3 matrix", ""};
  p.fx = k[0], p.fy = k[4], p.cx = k[2], p.cy = k[5];
}

void setDistortion(const std::string& model, std::vector<double> coefficients, Camera& camera) {
  camera.distortion = distortionNamed(model);
  if (camera.distortion == Distortion::radtan) return setRadtan(coefficients, camera);
  if (camera.distortion == Distortion::none) return;
  camera.coefficients = std::move(coefficients);
}

void readRos(const CalibrationSource& s, Calibration& result) {
  Camera& camera = result.camera;
  camera.pinhole.width = requiredValue<int>(s.root, "image_width");
  camera.pinhole.height = requiredValue<int>(s.root, "image_height");
  setMatrix(matrixValues(s.root["camera_matrix"], "camera_matrix"), "camera_matrix",
            camera.pinhole);
  const std::string model = has(s.root, "distortion_model")
                                ? requiredValue<std::string>(s.root, "distortion_model")
                                : "plumb_bob";
  const YAML::Node d = s.root["distortion_coefficients"];
  setDistortion(model, d ? matrixValues(d, "distortion_coefficients") : std::vector<double>(),
                camera);
  result.notes.push_back(
      "camera_matrix and distortion are used, as of images that are not rectified");
}

// ---- OpenCV FileStorage

const char* firstOf(const YAML::Node& root, std::initializer_list<const char*> keys) {
  for (const char* key : keys) {
    if (has(root, key)) return key;
  }
  return nullptr;
}

const char* matrixKey(const YAML::Node& root) {
  return firstOf(root, {"camera_matrix", "Camera_Matrix", "cameraMatrix", "intrinsic_matrix", "K",
                        "M1", "mtx"});
}

bool isOpenCv(const CalibrationSource& s) { return isMap(s) && matrixKey(s.root) != nullptr; }

void readOpenCv(const CalibrationSource& s, Calibration& result) {
  Camera& camera = result.camera;
  const char* key = matrixKey(s.root);
  setMatrix(matrixValues(s.root[key], key), key, camera.pinhole);
  const char* d = firstOf(s.root, {"distortion_coefficients", "Distortion_Coefficients",
                                   "distCoeffs", "dist_coeffs", "dist_coeff", "dist", "D", "D1"});
  const char* fisheye = firstOf(s.root, {"fisheye_model"});
  const bool wide = fisheye && requiredValue<std::string>(s.root, fisheye) != "0";
  setDistortion(wide ? "fisheye" : "opencv", d ? matrixValues(s.root[d], d) : std::vector<double>(),
                camera);
  if (const char* w = firstOf(s.root, {"image_width", "image_Width", "width", "Width"}))
    camera.pinhole.width = requiredValue<int>(s.root, w);
  if (const char* h = firstOf(s.root, {"image_height", "image_Height", "height", "Height"}))
    camera.pinhole.height = requiredValue<int>(s.root, h);
  if (const char* size = firstOf(s.root, {"image_size", "imageSize"})) {
    const auto v = matrixValues(s.root[size], size);
    if (v.size() == 2) {
      camera.pinhole.width = static_cast<int>(std::lround(v[0]));
      camera.pinhole.height = static_cast<int>(std::lround(v[1]));
    }
  }
}

// ---- ORB-SLAM2 and 3

const char* orbPrefix(const YAML::Node& root) {
  if (has(root, "Camera.fx")) return "Camera.";
  return has(root, "Camera1.fx") ? "Camera1." : nullptr;
}

bool isOrb(const CalibrationSource& s) { return isMap(s) && orbPrefix(s.root) != nullptr; }

void readOrb(const CalibrationSource& s, Calibration& result) {
  const std::string prefix = orbPrefix(s.root);
  const auto value = [&](const char* name) { return requiredValue<double>(s.root, prefix + name); };
  const auto optional = [&](const char* name) {
    return has(s.root, (prefix + name).c_str()) ? value(name) : 0.0;
  };
  Camera& camera = result.camera;
  Pinhole& p = camera.pinhole;
  p = {0, 0, value("fx"), value("fy"), value("cx"), value("cy")};
  if (has(s.root, "Camera.width")) p.width = requiredValue<int>(s.root, "Camera.width");
  if (has(s.root, "Camera.height")) p.height = requiredValue<int>(s.root, "Camera.height");
  const std::string type =
      has(s.root, "Camera.type") ? requiredValue<std::string>(s.root, "Camera.type") : "PinHole";
  if (distortionNamed(type) == Distortion::equidistant) {
    camera.distortion = Distortion::equidistant;
    camera.coefficients = {value("k1"), value("k2"), value("k3"), value("k4")};
  } else {
    setRadtan({optional("k1"), optional("k2"), optional("p1"), optional("p2"), optional("k3")},
              camera);
  }
  if (has(s.root, "Camera.fps")) camera.rate_hz = requiredValue<double>(s.root, "Camera.fps");
}

}  // namespace

const CalibrationLayout kKalibrLayout = {
    "Kalibr camchain",
    "a camera file has cam0 with camera_model, intrinsics [fx, fy, cx, cy], distortion_model, "
    "distortion_coeffs and resolution [width, height]",
    isKalibr, readKalibr};
const CalibrationLayout kRosLayout = {
    "ROS camera_info",
    "a camera_info file has image_width, image_height, camera_matrix, distortion_model and "
    "distortion_coefficients",
    isRos, readRos};
const CalibrationLayout kOpenCvLayout = {
    "OpenCV FileStorage",
    "an OpenCV calibration has camera_matrix (3x3), distortion_coefficients, image_width and "
    "image_height",
    isOpenCv, readOpenCv};
const CalibrationLayout kOrbLayout = {
    "ORB-SLAM settings",
    "ORB-SLAM settings have Camera.fx, fy, cx, cy, k1, k2, p1, p2, width and height", isOrb,
    readOrb};

}  // namespace svoscope
