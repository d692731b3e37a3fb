// SPDX-License-Identifier: MIT
#include "engine/eval/association.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace svoscope {

namespace {

/// Index of the pose nearest in time, the earlier one on a tie.
int nearest(const Trajectory& sorted, double timestamp) {
  const auto after =
      std::lower_bound(sorted.begin(), sorted.end(), timestamp,
                       [](const StampedPose& pose, double t) { return pose.timestamp < t; });
  if (after == sorted.begin()) return 0;
  const auto before = after - 1;
  const bool take_before =
      after == sorted.end() || timestamp - before->timestamp <= after->timestamp - timestamp;
  return static_cast<int>((take_before ? before : after) - sorted.begin());
}

Error nothingMatches(const Trajectory& gt, const Trajectory& est, double max_dt) {
  const auto range = [](const Trajectory& t) {
    return t.empty()
               ? std::string("is empty")
               : fmt::format("covers {:.3f} to {:.3f} s", t.front().timestamp, t.back().timestamp);
  };
  const bool apart =
      !gt.empty() && !est.empty() &&
      (gt.back().timestamp < est.front().timestamp || est.back().timestamp < gt.front().timestamp);
  const bool empty = gt.empty() || est.empty();
  return inputError(
      empty   ? fmt::format("the {} has no pose", gt.empty() ? "ground truth" : "estimate")
      : apart ? std::string("the timestamps do not overlap")
              : fmt::format("no timestamps match within {} s", max_dt),
      "association",
      fmt::format(
          "the ground truth {}, the estimate {}; {}", range(gt), range(est),
          empty ? "there is nothing to compare"
          : apart
              ? "are both of the same sequence? `svoscope eval` shifts clocks by --offset"
              : "`svoscope eval` takes a wider limit, --max-dt, and shifts clocks by --offset"));
}

}  // namespace

Result<std::vector<PosePair>> associateByTime(const Trajectory& gt, const Trajectory& est,
                                              double max_dt) {
  std::vector<PosePair> pairs;
  if (gt.empty() || est.empty()) return nothingMatches(gt, est, max_dt);
  const bool est_longer = est.size() > gt.size();
  const Trajectory& longer = est_longer ? est : gt;
  const Trajectory& shorter = est_longer ? gt : est;
  for (int i = 0; i < static_cast<int>(shorter.size()); ++i) {
    const int j = nearest(longer, shorter[i].timestamp);
    if (std::abs(longer[j].timestamp - shorter[i].timestamp) > max_dt) continue;
    pairs.push_back(est_longer ? PosePair{i, j} : PosePair{j, i});
  }
  if (pairs.empty()) return nothingMatches(gt, est, max_dt);
  return pairs;
}

Result<std::vector<PosePair>> associateByRow(const Trajectory& gt, const Trajectory& est) {
  if (gt.size() != est.size()) {
    return inputError(
        fmt::format("{} rows of ground truth, {} of the estimate", gt.size(), est.size()),
        "association", "rows without timestamps are matched by number: both files need as many");
  }
  std::vector<PosePair> pairs;
  for (int i = 0; i < static_cast<int>(gt.size()); ++i) pairs.push_back({i, i});
  return pairs;
}

}  // namespace svoscope
