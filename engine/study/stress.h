// SPDX-License-Identifier: MIT
// Runs methods on sequences made hard in a known way and judges where each breaks.
#pragma once

#include <atomic>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "engine/base/methods.h"
#include "engine/base/result.h"
#include "engine/runner/parameters.h"
#include "engine/study/stress_table.h"

namespace svoscope {

enum class StressOutcome : std::uint8_t {
  held,    ///< tracked >= 98 %, error <= 0.5 % of the path
  shaky,   ///< tracked >= 90 %, error <= 2 %
  broken,  ///< anything else: lost for long, wrong, or never started
};
const char* stressOutcomeName(StressOutcome outcome);

/// One method on one sequence. Black frames count nowhere but in `recovery_s`.
struct StressRow {
  std::string stress, strength, sequence, method;
  int visible = 0;                         ///< frames that are not black
  std::optional<double> start_s;           ///< sequence time until the first good pose
  std::optional<double> tracked_fraction;  ///< visible frames with a good pose, from the start on
  int losses = 0;                          ///< times tracking was lost
  /// RMSE of the positions after Sim(3) alignment, relative to the length of the true path from the
  /// start on; empty if the alignment is not determined.
  std::optional<double> relative_ate;
  /// Blackouts: sequence time from the first frame that is not black again to the first good pose.
  std::optional<double> recovery_s;
  bool blackout = false;  ///< the sequence has one that begins after the start
  StressOutcome outcome = StressOutcome::broken;
};

struct StressOptions {
  std::vector<std::string> methods = methodIds();
  Parameters parameters;
  const std::atomic<bool>* stop = nullptr;           ///< ends the suite after the current frame
  std::function<void(const std::string&)> progress;  ///< what is being run
  std::function<Status(const StressRow&)> finished;  ///< each row as soon as it is known
};

/// All levels of all stresses with each method, synchronously: the same rows every time. Rows come
/// by stress, strength, method. What was done before `stop` is returned. Errors: of makeRunner, of
/// reading, and whatever `finished` returns.
Result<std::vector<StressRow>> runStresses(const std::vector<Stress>& stresses,
                                           const StressOptions& options);

}  // namespace svoscope
