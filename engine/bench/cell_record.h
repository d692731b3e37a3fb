// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "engine/base/result.h"

namespace svoscope {

/// How a cell ended: cell.json beside its results.
struct CellRecord {
  std::string configuration, build;  ///< fingerprints
  std::string version;               ///< as printed
  std::string machine;               ///< processor
  int exit_code = 0;
  int signal = 0;  ///< that ended it, 0: none
  bool timed_out = false;
  std::string reason;  ///< why it is no result; empty if it is
  double wall_s = 0;

  /// Ended by itself: what came from outside (kill, power) is run again.
  bool finished() const { return signal == 0; }
};

Status writeCellRecord(const std::filesystem::path& folder, const CellRecord& record);
/// Empty if there is none or it cannot be understood.
std::optional<CellRecord> readCellRecord(const std::filesystem::path& folder);

}  // namespace svoscope
