// SPDX-License-Identifier: MIT
#include "engine/dataset/calibration/calibration.h"

#include <fmt/format.h>

#include <fstream>
#include <iterator>
#include <optional>

#include "engine/dataset/calibration/layouts.h"

namespace svoscope {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostBytes = 1 << 20;  // a calibration has a few hundred

const char* const kForm =
    "a camera file has cam0 with camera_model, intrinsics [fx, fy, cx, cy], distortion_model, "
    "distortion_coeffs and resolution [width, height]; files of Kalibr, ROS, OpenCV, ORB-SLAM, "
    "SVO, VINS, basalt, DSO and COLMAP are read as they are";

const char* const kBodyForm =
    "the pose of the camera in the body is T_BS (ASL), T_cam_imu (Kalibr), T_B_C (SVO Pro) or "
    "T_imu_cam (basalt)";

Result<std::string> readText(const fs::path& file) {
  std::error_code ec;
  if (!fs::exists(file, ec))
    return inputError(file.filename().string() + " is missing", file.string(), kForm);
  std::ifstream in(file, std::ios::binary);
  if (!in || fs::is_directory(file, ec))
    return inputError("the file cannot be read", file.string(), "check that you may read it");
  std::string text(kMostBytes + 1, '\0');
  in.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(in.gcount()));
  if (text.size() > kMostBytes)
    return inputError("this is too large for a calibration", file.string(), kForm);
  if (text.rfind("\xEF\xBB\xBF", 0) == 0) text.erase(0, 3);
  return text;
}

/// The text as a tree; OpenCV's first line ("%YAML:1.0") is no valid directive and is passed over.
std::optional<YAML::Node> parseYaml(const std::string& text, std::string& problem) {
  std::string yaml = text;
  if (yaml.rfind("%YAML", 0) == 0)
    yaml.erase(0, yaml.find('\n') == std::string::npos ? yaml.size() : yaml.find('\n') + 1);
  try {
    return YAML::Load(yaml);
  } catch (const YAML::Exception& e) {
    problem = e.what();
  }
  return std::nullopt;
}

const CalibrationLayout* recognise(const CalibrationSource& source) {
  for (const CalibrationLayout* layout : calibrationLayouts()) {
    if (layout->recognises(source)) return layout;
  }
  return nullptr;
}

Result<Calibration> readAs(const CalibrationLayout& layout, const CalibrationSource& source,
                           const std::string& file) {
  Calibration result;
  result.format = layout.name;
  try {
    layout.read(source, result);
  } catch (const CalibrationKeyError& e) {
    return inputError(e.key + " " + e.what, file, e.remedy.empty() ? layout.form : e.remedy);
  } catch (const YAML::Exception& e) {
    return inputError(std::string("the file has an unexpected form: ") + e.what(), file,
                      layout.form);
  }
  Pinhole& p = result.camera.pinhole;
  if (p.width == 0 && p.height == 0 && source.images.width > 0) {
    p.width = source.images.width;
    p.height = source.images.height;
    result.notes.push_back("the file gives no resolution: the images' is taken");
  }
  const Status status = result.camera.check();
  if (!status) return inputError(status.error().what, file, status.error().remedy);
  const Status plausible = plausibleIntrinsics(p, file);
  if (!plausible) return plausible.error();
  return result;
}

}  // namespace

const std::vector<const CalibrationLayout*>& calibrationLayouts() {
  static const std::vector<const CalibrationLayout*> kLayouts = {
      &kSvoProLayout, &kVikitLayout,  &kRosLayout,    &kOrbLayout,    &kVinsLayout,
      &kBasaltLayout, &kKalibrLayout, &kOpenCvLayout, &kColmapLayout, &kDsoLayout};
  return kLayouts;
}

Status plausibleIntrinsics(const Pinhole& p, const std::string& file) {
  const bool short_focal = p.fx < p.width / 20.0 || p.fy < p.height / 20.0;
  const bool outside = p.cx < 0 || p.cy < 0 || p.cx > p.width || p.cy > p.height;
  if (!short_focal && !outside) return Done{};
  const std::string given =
      fmt::format("fx {:.6g}, fy {:.6g}, cx {:.6g}, cy {:.6g}", p.fx, p.fy, p.cx, p.cy);
  if (short_focal && p.cx > 0 && p.cx < 1 && p.cy > 0 && p.cy < 1 && p.fx < 5 && p.fy < 5) {
    return inputError("the intrinsics are relative to the image, not in pixels: " + given, file,
                      fmt::format("for {} x {} pixels they are [{:.3f}, {:.3f}, {:.3f}, {:.3f}]",
                                  p.width, p.height, p.fx * p.width, p.fy * p.height,
                                  p.cx * p.width - 0.5, p.cy * p.height - 0.5));
  }
  if (short_focal) {
    return inputError(
        fmt::format("a focal length under a twentieth of the image of {} x {}: {}", p.width,
                    p.height, given),
        file,
        "are they millimetres? pixels = millimetres * image width / sensor width in millimetres");
  }
  return inputError(fmt::format("the principal point lies outside the image of {} x {}: {}",
                                p.width, p.height, given),
                    file, "was the calibration made for another size of the images?");
}

Result<Calibration> readCalibration(const fs::path& file, ImageSize images) {
  auto text = readText(file);
  if (!text) return text.error();
  CalibrationSource source;
  source.text = std::move(text.value());
  source.images = images;
  std::string problem;
  if (const auto root = parseYaml(source.text, problem)) source.root = *root;
  const CalibrationLayout* layout = recognise(source);
  if (layout) return readAs(*layout, source, file.string());
  if (!problem.empty()) return inputError("not valid YAML: " + problem, file.string(), kForm);
  if (!source.root.IsMap()) return inputError("no calibration in the file", file.string(), kForm);
  // What comes nearest to the form of a Kalibr file says which key is missing.
  return readAs(kKalibrLayout, source, file.string());
}

Result<SE3> readExtrinsics(const fs::path& file) {
  auto text = readText(file);
  if (!text) return text.error();
  std::string problem;
  const auto root = parseYaml(text.value(), problem);
  if (!root) return inputError("not valid YAML: " + problem, file.string(), kBodyForm);
  try {
    if (const auto T_body_cam = bodyPoseIn(*root)) return *T_body_cam;
  } catch (const CalibrationKeyError& e) {
    return inputError(e.key + " " + e.what, file.string(), kBodyForm);
  } catch (const YAML::Exception& e) {
    return inputError(std::string("the file has an unexpected form: ") + e.what(), file.string(),
                      kBodyForm);
  }
  return inputError("the file does not say where the camera sits on the body", file.string(),
                    kBodyForm);
}

}  // namespace svoscope
