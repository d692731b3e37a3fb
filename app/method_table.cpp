// SPDX-License-Identifier: MIT
#include "app/method_table.h"

#include <fmt/format.h>

namespace svoscope {

namespace {

template <typename T>
std::string orDash(const std::optional<T>& value, const char* pattern) {
  return value ? fmt::format(fmt::runtime(pattern), *value) : "-";
}

std::string row(const RunMetrics& run) {
  std::optional<double> percent, ate, rpe_m, rpe_deg;
  if (run.tracked_fraction_after_init) percent = 100 * *run.tracked_fraction_after_init;
  if (run.evaluation) ate = run.evaluation->ate.rmse;
  if (run.evaluation && run.evaluation->rpe) {
    rpe_m = run.evaluation->rpe->trans_rmse_m;
    rpe_deg = run.evaluation->rpe->rot_rmse_rad * 57.29577951308232;
  }
  const StageTime& tracking = run.time_ms[static_cast<std::size_t>(Stage::tracking)];
  return fmt::format("{:<8}{:>10}{:>7}{:>11}{:>8}{:>11}{:>10}{:>10}{:>13}{:>10}\n", run.method,
                     orDash(percent, "{:.1f} %"), orDash(run.init_frame, "{}"), run.keyframes,
                     run.losses, orDash(ate, "{:.4f}"), orDash(rpe_m, "{:.4f}"),
                     orDash(rpe_deg, "{:.3f}"), fmt::format("{:.2f}", tracking.median_ms),
                     fmt::format("{:.1f}", run.fps));
}

}  // namespace

std::string methodTable(const std::vector<RunMetrics>& runs) {
  std::string text = fmt::format("{:<8}{:>10}{:>7}{:>11}{:>8}{:>11}{:>10}{:>10}{:>13}{:>10}\n",
                                 "method", "tracked", "start", "keyframes", "losses", "ATE m",
                                 "RPE m", "RPE deg", "tracking ms", "frames/s");
  for (const RunMetrics& run : runs) text += row(run);
  return text;
}

}  // namespace svoscope
