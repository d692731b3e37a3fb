// SPDX-License-Identifier: MIT
// Layouts that are plain text: DSO camera.txt and COLMAP cameras.txt.
#include <map>
#include <sstream>

#include "engine/base/text_rows.h"
#include "engine/dataset/calibration/layouts.h"

namespace svoscope {

namespace {

/// Words of the lines that are neither blank nor comments.
std::vector<std::vector<std::string>> words(const std::string& text) {
  std::vector<std::vector<std::string>> rows;
  std::istringstream in(text);
  std::string line;
  while (std::getline(in, line)) {
    if (!line.empty() && line[0] == '#') continue;
    std::istringstream fields(line);
    std::vector<std::string> row;
    for (std::string word; fields >> word;) row.push_back(word);
    if (!row.empty()) rows.push_back(std::move(row));
  }
  return rows;
}

std::vector<double> numbers(const std::vector<std::string>& row, std::size_t first,
                            const std::string& key) {
  std::vector<double> values;
  for (std::size_t i = first; i < row.size(); ++i) {
    const auto value = parseNumber(row[i]);
    if (!value) throw CalibrationKeyError{key, "holds '" + row[i] + "', not a number", ""};
    values.push_back(*value);
  }
  return values;
}

// ---- DSO

struct DsoModel {
  Distortion distortion;
  std::size_t coefficients;
};
const std::map<std::string, DsoModel>& dsoModels() {
  static const std::map<std::string, DsoModel> kModels = {
      {"Pinhole", {Distortion::none, 0}},
      {"FOV", {Distortion::fov, 1}},
      {"RadTan", {Distortion::radtan, 4}},
      {"EquiDistant", {Distortion::equidistant, 4}},
      {"KannalaBrandt", {Distortion::equidistant, 4}}};
  return kModels;
}

bool isNumber(const std::string& word) { return parseNumber(word).has_value(); }

bool isDso(const CalibrationSource& s) {
  const auto rows = words(s.text);
  if (rows.size() < 2 || rows[1].size() != 2) return false;
  if (!isNumber(rows[1][0]) || !isNumber(rows[1][1])) return false;
  if (dsoModels().count(rows[0][0])) return true;
  return rows[0].size() == 5 && isNumber(rows[0][0]);
}

/// fx, fy, cx, cy and the lens; without a name the fifth number is the angle of the FOV model.
void readDso(const CalibrationSource& s, Calibration& result) {
  const auto rows = words(s.text);
  const bool named = dsoModels().count(rows[0][0]) > 0;
  const DsoModel model = named ? dsoModels().at(rows[0][0]) : DsoModel{Distortion::fov, 1};
  const auto k = numbers(rows[0], named ? 1 : 0, "line 1");
  if (k.size() < 4 + model.coefficients)
    throw CalibrationKeyError{"line 1", "has too few numbers", ""};
  const auto size = numbers(rows[1], 0, "line 2");
  Camera& camera = result.camera;
  Pinhole& p = camera.pinhole;
  p = {static_cast<int>(size[0]), static_cast<int>(size[1]), k[0], k[1], k[2], k[3]};
  if (p.cx < 1 && p.cy < 1) {
    // Relative values: the origin is the corner of the image, not the centre of its first pixel.
    p = {p.width,
         p.height,
         k[0] * size[0],
         k[1] * size[1],
         k[2] * size[0] - 0.5,
         k[3] * size[1] - 0.5};
    result.notes.push_back("the intrinsics are relative to the image: turned into pixels");
  }
  const std::vector<double> lens(k.begin() + 4,
                                 k.begin() + 4 + static_cast<std::ptrdiff_t>(model.coefficients));
  if (model.distortion == Distortion::radtan) return setRadtan(lens, camera);
  if (model.distortion == Distortion::fov && lens[0] == 0) return;
  camera.distortion = model.distortion;
  camera.coefficients = lens;
}

// ---- COLMAP

/// Positions of fx fy cx cy and of the coefficients k1 k2 p1 p2 ... among the parameters.
struct ColmapModel {
  std::size_t parameters;
  bool one_focal;
  Distortion distortion;
};
const std::map<std::string, ColmapModel>& colmapModels() {
  static const std::map<std::string, ColmapModel> kModels = {
      {"SIMPLE_PINHOLE", {3, true, Distortion::none}},
      {"PINHOLE", {4, false, Distortion::none}},
      {"SIMPLE_RADIAL", {4, true, Distortion::radtan}},
      {"RADIAL", {5, true, Distortion::radtan}},
      {"OPENCV", {8, false, Distortion::radtan}},
      {"FULL_OPENCV", {12, false, Distortion::radtan}},
      {"OPENCV_FISHEYE", {8, false, Distortion::equidistant}},
      {"FOV", {5, false, Distortion::fov}}};
  return kModels;
}

bool isColmap(const CalibrationSource& s) {
  const auto rows = words(s.text);
  if (rows.empty() || rows[0].size() < 7 || !isNumber(rows[0][0]) || isNumber(rows[0][1]))
    return false;
  return isNumber(rows[0][2]) && isNumber(rows[0][3]);
}

void readColmap(const CalibrationSource& s, Calibration& result) {
  const auto rows = words(s.text);
  const std::string& name = rows[0][1];
  const auto found = colmapModels().find(name);
  if (found == colmapModels().end()) refuseModel("MODEL", name);
  const ColmapModel& model = found->second;
  const auto size = numbers({rows[0][2], rows[0][3]}, 0, "WIDTH and HEIGHT");
  auto v = numbers(rows[0], 4, "PARAMS");
  if (v.size() != model.parameters)
    throw CalibrationKeyError{"PARAMS",
                              "has " + std::to_string(v.size()) + " numbers, " + name + " takes " +
                                  std::to_string(model.parameters),
                              ""};
  if (model.one_focal) v.insert(v.begin(), v[0]);
  Camera& camera = result.camera;
  // Its pixel centres lie at .5: half a pixel less here.
  camera.pinhole = {
      static_cast<int>(size[0]), static_cast<int>(size[1]), v[0], v[1], v[2] - 0.5, v[3] - 0.5};
  std::vector<double> lens(v.begin() + 4, v.end());
  if (model.distortion == Distortion::radtan) return setRadtan(lens, camera);
  if (model.distortion == Distortion::none) return;
  camera.distortion = model.distortion;
  camera.coefficients = lens;
  if (rows.size() > 1) result.notes.push_back("the first of several cameras is used");
}

}  // namespace

const CalibrationLayout kDsoLayout = {
    "DSO",
    "a DSO calibration has the lines '[Pinhole|FOV|RadTan|EquiDistant] fx fy cx cy ...', "
    "'width height'",
    isDso, readDso};
const CalibrationLayout kColmapLayout = {
    "COLMAP cameras.txt", "a line is CAMERA_ID MODEL WIDTH HEIGHT PARAMS...", isColmap, readColmap};

}  // namespace svoscope
