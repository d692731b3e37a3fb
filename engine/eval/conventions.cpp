// SPDX-License-Identifier: MIT
#include "engine/eval/conventions.h"

#include <fmt/format.h>

#include <cmath>

namespace svoscope {

namespace {

constexpr double kFarBetter = 1.0 / 3;   // error by error; missing extrinsics give up to 0.4
constexpr int kLeastMatches = 10;        // fewer fit by chance
constexpr double kMostShift = 1.0;       // s, to both sides
constexpr double kLeastShift = 0.01;     // s, below it clocks count as equal
constexpr double kLeastRotation = 0.03;  // rad, relative errors below it raise no doubt

/// ATE over at least nine tenths of the matches: over fewer, any error is smaller.
double ate(const Trajectory& truth, const Trajectory& estimate, const EvalOptions& options,
           int matched) {
  const auto result = evaluate(truth, estimate, options);
  const bool comparable = result.ok() && 10 * result.value().matched >= 9 * matched;
  return comparable ? result.value().ate.rmse : HUGE_VAL;
}

/// Length of the path that was matched: an error is small or large against it.
double pathLength(const EvalResult& result) {
  double length = 0;
  for (std::size_t i = 1; i < result.errors.size(); ++i)
    length += (result.errors[i].position_gt - result.errors[i - 1].position_gt).norm();
  return length;
}

/// Best offset of the estimate's clock on a grid, refined by halving the step.
double bestShift(const Trajectory& truth, const Trajectory& estimate, EvalOptions options,
                 int matched, double& error) {
  const double given = options.time_offset;
  const auto at = [&](double shift) {
    options.time_offset = given + shift;
    return ate(truth, estimate, options, matched);
  };
  double best = 0;
  error = at(0);
  for (double shift = -kMostShift; shift <= kMostShift; shift += 0.05) {
    const double e = at(shift);
    if (e < error) error = e, best = shift;
  }
  for (double step = 0.025; step > 2e-3; step *= 0.5) {
    for (const double shift : {best - step, best + step}) {
      const double e = at(shift);
      if (e < error) error = e, best = shift;
    }
  }
  return best;
}

void doubtClock(const Trajectory& truth, const Trajectory& estimate, const EvalResult& result,
                std::vector<ConventionDoubt>& doubts) {
  if (result.options.by_row) return;
  double error = 0;
  const double shift = bestShift(truth, estimate, result.options, result.matched, error);
  if (std::abs(shift) < kLeastShift || !(error < kFarBetter * result.ate.rmse)) return;
  doubts.push_back({fmt::format("the clocks seem to differ: with {:+.3f} s the ATE is {:.4f} m "
                                "instead of {:.4f} m",
                                shift, error, result.ate.rmse),
                    fmt::format("--offset {:.3f}", result.options.time_offset + shift)});
}

void doubtPoses(const Trajectory& truth, const Trajectory& estimate, const EvalResult& result,
                std::vector<ConventionDoubt>& doubts) {
  const auto suspect = [&](const Trajectory& other, const char* what, const char* option) {
    const double error = ate(truth, other, result.options, result.matched);
    if (error < kFarBetter * result.ate.rmse)
      doubts.push_back({fmt::format("{}: the ATE is then {:.4f} m instead of {:.4f} m", what, error,
                                    result.ate.rmse),
                        option});
  };
  if (result.options.orientations)
    suspect(invertedPoses(estimate), "the estimate seems to hold poses of the world in the camera",
            "--invert");
  suspect(mirroredPoses(estimate), "the estimate seems to be of a left-handed (mirrored) world",
          "--mirror");
}

void doubtQuaternions(const Trajectory& truth, const Trajectory& estimate, const EvalResult& result,
                      bool truth_is_tum, bool estimate_is_tum,
                      std::vector<ConventionDoubt>& doubts) {
  if (!result.rpe || result.rpe->rot_rmse_rad < kLeastRotation) return;
  const auto suspect = [&](bool of_truth, bool of_estimate, const char* whose, const char* option) {
    const auto other =
        evaluate(of_truth ? reorderedQuaternions(truth) : truth,
                 of_estimate ? reorderedQuaternions(estimate) : estimate, result.options);
    if (!other.ok() || !other.value().rpe) return;
    const double before = result.rpe->rot_rmse_rad, after = other.value().rpe->rot_rmse_rad;
    if (after < kFarBetter * before)
      doubts.push_back(
          {fmt::format("the quaternions of {} seem to begin with w: the rotational RPE is then "
                       "{:.4f} rad instead of {:.4f} rad",
                       whose, after, before),
           option});
  };
  if (estimate_is_tum) suspect(false, true, "the estimate", "--quaternion est-wxyz");
  if (truth_is_tum) suspect(true, false, "the ground truth", "--quaternion gt-wxyz");
  if (truth_is_tum && estimate_is_tum)
    suspect(true, true, "both trajectories", "--quaternion wxyz");
}

}  // namespace

std::vector<ConventionDoubt> conventionDoubts(const Trajectory& ground_truth,
                                              const Trajectory& estimate, const EvalResult& result,
                                              bool truth_is_tum, bool estimate_is_tum) {
  std::vector<ConventionDoubt> doubts;
  if (result.matched < kLeastMatches) return doubts;
  // What is right to a thousandth of the path leaves nothing to doubt.
  if (result.ate.rmse > 1e-3 * pathLength(result)) {
    doubtClock(ground_truth, estimate, result, doubts);
    doubtPoses(ground_truth, estimate, result, doubts);
  }
  doubtQuaternions(ground_truth, estimate, result, truth_is_tum, estimate_is_tum, doubts);
  return doubts;
}

std::string clockDoubt(const Trajectory& gt, const Trajectory& est) {
  if (gt.empty() || est.empty()) return "";
  const bool overlap =
      est.front().timestamp <= gt.back().timestamp && gt.front().timestamp <= est.back().timestamp;
  if (overlap) return "";
  return fmt::format(
      "the estimate runs from {:.3f} to {:.3f} s, the ground truth from {:.3f} to "
      "{:.3f} s: if both begin together, --offset {:.6f}",
      est.front().timestamp, est.back().timestamp, gt.front().timestamp, gt.back().timestamp,
      gt.front().timestamp - est.front().timestamp);
}

Trajectory invertedPoses(const Trajectory& poses) {
  Trajectory result = poses;
  for (StampedPose& pose : result) pose.T_world_cam = pose.T_world_cam.inverse();
  return result;
}

Trajectory mirroredPoses(const Trajectory& poses) {
  Trajectory result = poses;
  for (StampedPose& pose : result) {
    const Eigen::Quaterniond& q = pose.T_world_cam.quaternion();
    Vec3 t = pose.T_world_cam.translation();
    t.x() = -t.x();
    // A mirror at x = 0 keeps turns about x and reverses those about y and z.
    pose.T_world_cam = SE3(Eigen::Quaterniond(q.w(), q.x(), -q.y(), -q.z()), t);
  }
  return result;
}

Trajectory reorderedQuaternions(const Trajectory& poses) {
  Trajectory result = poses;
  for (StampedPose& pose : result) {
    const Eigen::Quaterniond& q = pose.T_world_cam.quaternion();
    pose.T_world_cam =
        SE3(Eigen::Quaterniond(q.x(), q.y(), q.z(), q.w()), pose.T_world_cam.translation());
  }
  return result;
}

}  // namespace svoscope
