// SPDX-License-Identifier: MIT
// Figures printed in: IT-SVO: Improved Semi-Direct Monocular Visual Odometry Combined with JS
// Divergence in Restricted Mobile Devices, Sensors 2021, 21(6), 2025, tables 1 to 7.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace svoscope {

constexpr const char* kPaperCitation =
    "IT-SVO: Improved Semi-Direct Monocular Visual Odometry Combined with JS Divergence in "
    "Restricted "
    "Mobile Devices. Sensors 2021, 21(6), 2025";

struct PaperErrors {
  double rpe_trans_m, rpe_rot_rad, ate_m;
};

/// In the order SVO, PL-SVO, IT-SVO; empty where the paper prints "-".
struct PaperRow {
  int table;             ///< 1, 3, 6, 7: errors; 2, 4: relocalisation time, s; 5: frames per second
  std::string sequence;  ///< as printed
  std::array<std::optional<PaperErrors>, 3> errors;
  std::array<std::optional<double>, 3> value;
};

const std::vector<PaperRow>& paperRows();
/// The paper's methods in our names, in its order.
const std::array<std::string, 3>& paperMethods();
const char* paperTableTitle(int table);

/// Whether our sequence is the paper's: "rgbd_dataset_freiburg1_xyz" is "fr1_xyz", "MH_01_easy" is
/// "MH01". An excerpt under a name of its own is not.
bool samePaperSequence(const std::string& paper, const std::string& ours);

}  // namespace svoscope
