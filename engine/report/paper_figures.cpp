// SPDX-License-Identifier: MIT
#include "engine/report/paper_figures.h"

#include <cctype>

namespace svoscope {

namespace {

using Errors = std::optional<PaperErrors>;
const Errors kFailed = std::nullopt;

PaperRow errors(int table, const char* sequence, Errors svo, Errors pl_svo, Errors it_svo) {
  return {table, sequence, {svo, pl_svo, it_svo}, {}};
}

PaperRow values(int table, const char* sequence, std::optional<double> svo, double pl_svo,
                double it_svo) {
  return {table, sequence, {}, {svo, pl_svo, it_svo}};
}

bool endsWith(const std::string& text, const std::string& end) {
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

std::string normalised(const std::string& name) {
  std::string text;
  for (const char c : name) {
    if (std::isalnum(static_cast<unsigned char>(c))) text += static_cast<char>(std::tolower(c));
  }
  const std::string dataset = "rgbddataset", camera = "freiburg";
  if (text.rfind(dataset, 0) == 0) text.erase(0, dataset.size());
  if (text.rfind(camera, 0) == 0) text.replace(0, camera.size(), "fr");
  for (const char* level : {"easy", "medium", "difficult"}) {
    if (endsWith(text, level)) text.resize(text.size() - std::string(level).size());
  }
  return text;
}

}  // namespace

const std::vector<PaperRow>& paperRows() {
  // In tables 6 and 7 the print leaves open to which rows the figures of SVO belong; as read.
  static const std::vector<PaperRow> rows = {
      errors(1, "fr1_xyz", kFailed, {{0.2249, 0.0043, 1.31}}, {{0.1609, 0.0029, 0.84}}),
      errors(1, "fr2_desk", kFailed, {{0.2214, 0.0021, 2.66}}, {{0.1172, 0.0021, 2.03}}),
      values(2, "fr1_xyz", {}, 2.776, 1.082),
      values(2, "fr2_desk", {}, 1.832, 0.689),
      errors(3, "MH01", {{0.8252, 0.5833, 9.021}}, {{0.3362, 0.0191, 2.39}},
             {{0.3172, 0.0183, 1.04}}),
      errors(3, "MH02", {{1.1371, 0.7270, 13.24}}, {{0.5373, 0.0154, 3.27}},
             {{0.4953, 0.0167, 2.03}}),
      values(4, "MH01", 5.717, 2.159, 1.463),
      values(4, "MH02", 7.238, 4.384, 2.017),
      values(5, "fr1_xyz", 69, 53, 49),
      values(5, "fr2_desk", 76, 61, 65),
      values(5, "MH01", 68, 50, 47),
      values(5, "MH02", 61, 46, 51),
      errors(6, "fr1_desk", {{0.7133, 0.3826, 3.47}}, {{0.1628, 0.0031, 1.08}},
             {{0.2123, 0.0036, 2.01}}),
      errors(6, "fr1_desk2", {{1.4341, 0.6154, 4.91}}, {{0.2329, 0.0047, 1.37}},
             {{0.2215, 0.0044, 1.22}}),
      errors(6, "fr1_rpy", kFailed, {{0.2055, 0.0035, 0.35}}, {{0.1743, 0.0032, 0.31}}),
      errors(6, "fr1_floor", {{1.8755, 0.7561, 5.59}}, {{0.2124, 0.0043, 1.92}},
             {{0.1917, 0.0041, 1.87}}),
      errors(6, "fr2_xyz", {{0.7274, 0.4842, 4.42}}, {{0.2179, 0.0045, 0.91}},
             {{0.1412, 0.0028, 0.36}}),
      errors(6, "fr2_large_no_loop", kFailed, {{0.1315, 0.0027, 1.97}}, {{0.1128, 0.0020, 1.85}}),
      errors(6, "fr2_360_hemisphere", kFailed, {{0.1103, 0.0022, 1.85}}, {{0.1044, 0.0019, 1.79}}),
      errors(6, "fr2_360_kidnap", kFailed, {{0.1227, 0.0025, 1.96}}, {{0.1219, 0.0023, 1.84}}),
      errors(7, "V1_01_easy", {{4.3739, 0.8272, 13.24}}, {{0.1801, 0.0092, 2.66}},
             {{0.1898, 0.0094, 2.71}}),
      errors(7, "V2_01_easy", {{4.0105, 0.9194, 9.02}}, {{0.1472, 0.0089, 1.74}},
             {{0.1543, 0.0091, 1.79}}),
      errors(7, "mav03_medium", kFailed, {{0.2796, 0.0154, 6.92}}, {{0.2533, 0.0115, 5.85}}),
      errors(7, "V2_02_medium", kFailed, {{0.2247, 0.0201, 5.77}}, {{0.2134, 0.0184, 5.10}})};
  return rows;
}

const std::array<std::string, 3>& paperMethods() {
  static const std::array<std::string, 3> methods = {"svo", "pl-svo", "it-svo"};
  return methods;
}

const char* paperTableTitle(int table) {
  switch (table) {
    case 1:
      return "Errors on TUM RGB-D";
    case 2:
      return "Relocalisation time on TUM RGB-D, s";
    case 3:
      return "Errors on EuRoC";
    case 4:
      return "Relocalisation time on EuRoC, s";
    case 5:
      return "Frames per second";
    case 6:
      return "Errors on further TUM RGB-D sequences";
    default:
      return "Errors on further EuRoC sequences";
  }
}

bool samePaperSequence(const std::string& paper, const std::string& ours) {
  return normalised(paper) == normalised(ours);
}

}  // namespace svoscope
