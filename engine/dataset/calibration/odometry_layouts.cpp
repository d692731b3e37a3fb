// SPDX-License-Identifier: MIT
// Layouts of other odometries: SVO (vikit), SVO Pro, VINS, basalt.
#include "engine/dataset/calibration/layouts.h"

namespace svoscope {

namespace {

bool isMap(const CalibrationSource& s) { return s.root.IsDefined() && s.root.IsMap(); }

bool has(const YAML::Node& node, const char* key) { return node.IsMap() && node[key]; }

// ---- SVO (vikit)

bool isVikit(const CalibrationSource& s) { return isMap(s) && has(s.root, "cam_model"); }

void readVikit(const CalibrationSource& s, Calibration& result) {
  const auto value = [&](const char* key) { return requiredValue<double>(s.root, key); };
  const auto optional = [&](const char* key) { return has(s.root, key) ? value(key) : 0.0; };
  const auto model = requiredValue<std::string>(s.root, "cam_model");
  Camera& camera = result.camera;
  const double w = value("cam_width"), h = value("cam_height");
  camera.pinhole = {static_cast<int>(w), static_cast<int>(h), value("cam_fx"),
                    value("cam_fy"),     value("cam_cx"),     value("cam_cy")};
  if (model == "Pinhole" || model == "pinhole") {
    setRadtan({optional("cam_d0"), optional("cam_d1"), optional("cam_d2"), optional("cam_d3")},
              camera);
  } else if (model == "ATAN" || model == "Atan") {
    // Relative to the image; its corner, not the centre of a pixel, is the origin.
    Pinhole& p = camera.pinhole;
    p = {p.width, p.height, p.fx * w, p.fy * h, p.cx * w - 0.5, p.cy * h - 0.5};
    result.notes.push_back("ATAN intrinsics are relative to the image: turned into pixels");
    if (value("cam_d0") != 0) {
      camera.distortion = Distortion::fov;
      camera.coefficients = {value("cam_d0")};
    }
  } else {
    refuseModel("cam_model", model);
  }
}

// ---- SVO Pro

bool isSvoPro(const CalibrationSource& s) {
  return isMap(s) && has(s.root, "cameras") && s.root["cameras"].IsSequence() &&
         s.root["cameras"].size() > 0 && has(s.root["cameras"][0], "camera");
}

void readSvoPro(const CalibrationSource& s, Calibration& result) {
  const YAML::Node mounted = s.root["cameras"][0], cam = mounted["camera"];
  const auto type = requiredValue<std::string>(cam, "type");
  if (type != "pinhole") refuseModel("type", type);
  const auto k = matrixValues(cam["intrinsics"], "intrinsics");
  if (k.size() != 4)
    throw CalibrationKeyError{"intrinsics", "must hold 4 numbers: fx, fy, cx, cy", ""};
  Camera& camera = result.camera;
  camera.pinhole = {requiredValue<int>(cam, "image_width"),
                    requiredValue<int>(cam, "image_height"),
                    k[0],
                    k[1],
                    k[2],
                    k[3]};
  if (const YAML::Node d = cam["distortion"]) {
    camera.distortion = distortionNamed(requiredValue<std::string>(d, "type"));
    const auto values =
        d["parameters"] ? matrixValues(d["parameters"], "parameters") : std::vector<double>();
    if (camera.distortion == Distortion::radtan) {
      setRadtan(values, camera);
    } else if (camera.distortion != Distortion::none) {
      camera.coefficients = values;
    }
  }
  if (const auto T_body_cam = bodyPoseIn(s.root)) {
    result.T_body_cam = *T_body_cam;
    result.has_body = true;
  }
  if (s.root["cameras"].size() > 1) result.notes.push_back("the first of several cameras is used");
}

// ---- VINS

bool isVins(const CalibrationSource& s) {
  return isMap(s) && has(s.root, "model_type") && has(s.root, "image_width");
}

void readVins(const CalibrationSource& s, Calibration& result) {
  const auto model = requiredValue<std::string>(s.root, "model_type");
  Camera& camera = result.camera;
  Pinhole& p = camera.pinhole;
  p.width = requiredValue<int>(s.root, "image_width");
  p.height = requiredValue<int>(s.root, "image_height");
  const YAML::Node k = s.root["projection_parameters"];
  if (!k) throw CalibrationKeyError{"projection_parameters", "is missing", ""};
  const auto value = [&](const char* key) { return requiredValue<double>(k, key); };
  if (model == "PINHOLE") {
    p.fx = value("fx"), p.fy = value("fy"), p.cx = value("cx"), p.cy = value("cy");
    const YAML::Node d = s.root["distortion_parameters"];
    if (d)
      setRadtan({requiredValue<double>(d, "k1"), requiredValue<double>(d, "k2"),
                 requiredValue<double>(d, "p1"), requiredValue<double>(d, "p2")},
                camera);
  } else if (model == "KANNALA_BRANDT") {
    p.fx = value("mu"), p.fy = value("mv"), p.cx = value("u0"), p.cy = value("v0");
    camera.distortion = Distortion::equidistant;
    camera.coefficients = {value("k2"), value("k3"), value("k4"), value("k5")};
  } else {
    refuseModel("model_type", model);
  }
}

// ---- basalt

bool isBasalt(const CalibrationSource& s) {
  return isMap(s) && has(s.root, "value0") && has(s.root["value0"], "intrinsics");
}

void readBasalt(const CalibrationSource& s, Calibration& result) {
  const YAML::Node root = s.root["value0"], cam = root["intrinsics"][0];
  if (!cam) throw CalibrationKeyError{"intrinsics", "is empty", ""};
  const auto type = requiredValue<std::string>(cam, "camera_type");
  if (type != "pinhole" && type != "kb4" && type != "pinhole-radtan8")
    refuseModel("camera_type", type);
  const YAML::Node k = cam["intrinsics"];
  const auto value = [&](const char* key) { return requiredValue<double>(k, key); };
  const auto size = matrixValues(root["resolution"], "resolution");
  if (size.size() < 2) throw CalibrationKeyError{"resolution", "must hold [[width, height]]", ""};
  Camera& camera = result.camera;
  camera.pinhole = {static_cast<int>(size[0]),
                    static_cast<int>(size[1]),
                    value("fx"),
                    value("fy"),
                    value("cx"),
                    value("cy")};
  if (type == "kb4") {
    camera.distortion = Distortion::equidistant;
    camera.coefficients = {value("k1"), value("k2"), value("k3"), value("k4")};
  } else if (type == "pinhole-radtan8") {
    setRadtan({value("k1"), value("k2"), value("p1"), value("p2"), value("k3"), value("k4"),
               value("k5"), value("k6")},
              camera);
  }
  if (const auto T_body_cam = bodyPoseIn(s.root)) {
    result.T_body_cam = *T_body_cam;
    result.has_body = true;
  }
}

}  // namespace

const CalibrationLayout kVikitLayout = {"SVO (vikit)",
                                        "a vikit camera has cam_model (Pinhole or ATAN), "
                                        "cam_width, cam_height, cam_fx, cam_fy, cam_cx, "
                                        "cam_cy and cam_d0 to cam_d3",
                                        isVikit, readVikit};
const CalibrationLayout kSvoProLayout = {
    "SVO Pro",
    "an SVO Pro calibration has cameras with type pinhole, image_width, image_height, intrinsics "
    "and distortion",
    isSvoPro, readSvoPro};
const CalibrationLayout kVinsLayout = {
    "VINS",
    "a VINS camera has model_type, image_width, image_height, projection_parameters and "
    "distortion_parameters",
    isVins, readVins};
const CalibrationLayout kBasaltLayout = {
    "basalt", "a basalt calibration has value0 with intrinsics, resolution and T_imu_cam", isBasalt,
    readBasalt};

}  // namespace svoscope
