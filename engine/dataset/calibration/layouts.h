// SPDX-License-Identifier: MIT
// One reader per layout of calibration files. Inside, what is wrong with a key is thrown as
// CalibrationKeyError; readCalibration() turns it into an input error.
#pragma once

#include <yaml-cpp/yaml.h>

#include <optional>
#include <string>
#include <vector>

#include "engine/dataset/calibration/calibration.h"

namespace svoscope {

struct CalibrationKeyError {
  std::string key, what;
  std::string remedy;  ///< empty: the layout's
};

/// What a reader gets: YAML and JSON as a tree, everything as text.
struct CalibrationSource {
  YAML::Node root;   ///< null if the file is no YAML
  std::string text;  ///< the whole file
  ImageSize images;
};

struct CalibrationLayout {
  const char* name;  ///< as shown: "Kalibr camchain"
  const char* form;  ///< what such a file holds, the remedy of its errors
  bool (*recognises)(const CalibrationSource& source);
  void (*read)(const CalibrationSource& source, Calibration& result);
};

/// In the order in which they are tried.
const std::vector<const CalibrationLayout*>& calibrationLayouts();

extern const CalibrationLayout kKalibrLayout, kSvoProLayout, kVikitLayout, kRosLayout, kOrbLayout,
    kVinsLayout, kBasaltLayout, kOpenCvLayout, kColmapLayout, kDsoLayout;

/// A value that must be there and of the type; CalibrationKeyError otherwise.
template <typename T>
T requiredValue(const YAML::Node& node, const std::string& key) {
  if (!node.IsMap() || !node[key]) throw CalibrationKeyError{key, "is missing", ""};
  try {
    return node[key].as<T>();
  } catch (const YAML::Exception&) {
    throw CalibrationKeyError{key, "has the wrong form", ""};
  }
}

/// Lens model by any of the names in use ("equi", "fisheye", "KannalaBrandt8", "opencv", ...).
Distortion distortionNamed(const std::string& name);

/// Coefficients in the order k1 k2 p1 p2 [k3 [k4 k5 k6]]; none of them, or zeros: no distortion.
void setRadtan(const std::vector<double>& coefficients, Camera& camera);

/// Numbers of a matrix: a flat sequence, rows of rows, or an OpenCV matrix with `data`.
std::vector<double> matrixValues(const YAML::Node& node, const std::string& key);

/// Rigid motion of 16 (or 12) numbers, row by row.
SE3 rigidMotion(const std::vector<double>& values, const std::string& key);

/// Pose of the (first) camera in the body by any of its names; empty if there is none.
std::optional<SE3> bodyPoseIn(const YAML::Node& root);

/// "recalibrate as pinhole with radtan or equi": for models this program does not have.
[[noreturn]] void refuseModel(const std::string& key, const std::string& model);

}  // namespace svoscope
