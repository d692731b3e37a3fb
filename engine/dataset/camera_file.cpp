// SPDX-License-Identifier: MIT
#include "engine/dataset/camera_file.h"

#include <yaml-cpp/yaml.h>

#include <fstream>
#include <iomanip>
#include <limits>

namespace svoscope {
namespace {

namespace fs = std::filesystem;

const char* const kLayout =
    "a camera file has cam0 with camera_model, intrinsics [fx, fy, cx, cy], distortion_model, "
    "distortion_coeffs and resolution [width, height]";

struct KeyError {
  std::string key, what;
};

template <typename T>
T required(const YAML::Node& node, const char* key) {
  if (!node[key]) throw KeyError{key, "is missing"};
  try {
    return node[key].as<T>();
  } catch (const YAML::Exception&) {
    throw KeyError{key, "has the wrong form"};
  }
}

Distortion distortionOf(const YAML::Node& node) {
  const auto name = required<std::string>(node, "distortion_model");
  const auto model = parseDistortion(name == "radial-tangential" ? "radtan" : name);
  if (!model) throw KeyError{"distortion_model", "is unknown: " + name};
  return model.value();
}

Camera cameraOf(const YAML::Node& node) {
  const auto model = node["camera_model"] ? required<std::string>(node, "camera_model") : "pinhole";
  if (model != "pinhole") throw KeyError{"camera_model", "must be pinhole, not " + model};
  const auto k = required<std::vector<double>>(node, "intrinsics");
  if (k.size() != 4) throw KeyError{"intrinsics", "must hold 4 numbers: fx, fy, cx, cy"};
  const auto size = required<std::vector<int>>(node, "resolution");
  if (size.size() != 2) throw KeyError{"resolution", "must hold 2 numbers: width, height"};
  Camera camera;
  camera.pinhole = {size[0], size[1], k[0], k[1], k[2], k[3]};
  camera.distortion = distortionOf(node);
  if (camera.distortion != Distortion::none) {
    const char* key = node["distortion_coeffs"] ? "distortion_coeffs" : "distortion_coefficients";
    camera.coefficients = required<std::vector<double>>(node, key);
  }
  if (node["rate_hz"]) camera.rate_hz = required<double>(node, "rate_hz");
  return camera;
}

SE3 bodyPoseOf(const YAML::Node& node) {
  if (!node["T_BS"]) return SE3();
  const auto v = required<std::vector<double>>(node["T_BS"], "data");
  if (v.size() != 16) throw KeyError{"T_BS", "must hold 16 numbers, a 4x4 matrix"};
  Mat3 R;
  R << v[0], v[1], v[2], v[4], v[5], v[6], v[8], v[9], v[10];
  if (!(R * R.transpose()).isIdentity(1e-2) || R.determinant() < 0)
    throw KeyError{"T_BS", "is not a rigid motion"};
  const SE3 T(R, Vec3(v[3], v[7], v[11]));
  if (!T.finite()) throw KeyError{"T_BS", "is not finite"};
  return T;
}

}  // namespace

Result<MountedCamera> readSensorFile(const fs::path& file) {
  std::error_code ec;
  if (!fs::is_regular_file(file, ec))
    return inputError(file.filename().string() + " is missing", file.string(), kLayout);
  try {
    const YAML::Node root = YAML::LoadFile(file.string());
    if (!root.IsMap()) return inputError("no calibration in the file", file.string(), kLayout);
    const YAML::Node node = root["cam0"] ? root["cam0"] : root;
    MountedCamera mounted{cameraOf(node), bodyPoseOf(node)};
    const Status status = mounted.camera.check();
    if (!status) return inputError(status.error().what, file.string(), status.error().remedy);
    return mounted;
  } catch (const KeyError& e) {
    return inputError(e.key + " " + e.what, file.string(), kLayout);
  } catch (const YAML::Exception& e) {
    return inputError(std::string("not valid YAML: ") + e.what(), file.string(), kLayout);
  }
}

Result<Camera> readCameraFile(const fs::path& file) {
  auto mounted = readSensorFile(file);
  if (!mounted) return mounted.error();
  return mounted.value().camera;
}

Status writeCameraFile(const Camera& camera, const fs::path& file) {
  std::ofstream out(file);
  out << std::setprecision(std::numeric_limits<double>::max_digits10);
  const Pinhole& p = camera.pinhole;
  out << "# Kalibr camchain layout; pixel centres at integer coordinates\n"
      << "cam0:\n  camera_model: pinhole\n  intrinsics: [" << p.fx << ", " << p.fy << ", " << p.cx
      << ", " << p.cy
      << "]  # fx, fy, cx, cy\n  distortion_model: " << distortionName(camera.distortion)
      << "\n  distortion_coeffs: [";
  for (size_t i = 0; i < camera.coefficients.size(); ++i)
    out << (i ? ", " : "") << camera.coefficients[i];
  out << "]\n  resolution: [" << p.width << ", " << p.height << "]\n";
  if (camera.rate_hz > 0) out << "  rate_hz: " << camera.rate_hz << "\n";
  if (!out.flush())
    return outputError("the file cannot be written", file.string(),
                       "check that the folder exists, is writable and has space left");
  return Done{};
}

}  // namespace svoscope
