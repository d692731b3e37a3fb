// SPDX-License-Identifier: MIT
// What view and shot open: a run, or several on the same sequence for comparison.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "app/run_settings.h"

namespace svoscope {

/// Runs beside those of --method.
struct CompareSettings {
  std::vector<std::string> recordings;    ///< --with: path, optionally =LABEL
  std::vector<std::string> trajectories;  ///< --trajectory: path, optionally =LABEL

  void addTo(CLI::App& command);
};

/// One runner for a single run, else a LockstepRunner over all; the budget of the history is shared
/// among the engines. SEQUENCE may be a recording. Errors name the file or option.
Result<std::unique_ptr<Runner>> openRuns(const RunSettings& run, const CompareSettings& compare,
                                         const RunnerOptions& options);

/// "runs/orb.txt=ORB-SLAM2" -> path and label; the label is the file's name without extension if
/// none is given.
std::pair<std::string, std::string> splitLabel(const std::string& argument);

}  // namespace svoscope
