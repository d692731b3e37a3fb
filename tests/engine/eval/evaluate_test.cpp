// SPDX-License-Identifier: MIT
// ATE and RPE against published trajectories with figures from an independent program, and against
// values that can be worked out by hand.
#include "engine/eval/evaluate.h"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <random>
#include <vector>

#include "engine/eval/trajectory_file.h"
#include "tests/support/support.h"

namespace svoscope {
namespace {

struct Known {
  const char* ground_truth;
  const char* estimate;
  Alignment alignment;
  const char* delta;
  bool all_pairs;
  int matched;
  double scale;
  std::vector<double> ate;  ///< rmse, mean, median, max, m; empty: not given
  double rpe_trans, rpe_rot;
};

std::vector<Known> knownFigures() {
  const char *desk_gt = "fr2_desk_groundtruth.txt", *desk = "fr2_desk_ORB.txt";
  const char *kitti_gt = "KITTI_00_gt.txt", *kitti = "KITTI_00_ORB.txt";
  return {
      {desk_gt,
       desk,
       Alignment::se3,
       "1f",
       false,
       2225,
       1,
       {0.008146, 0.007517, 0.007437, 0.024338},
       0.003598,
       0.005002},
      {desk_gt,
       desk,
       Alignment::sim3,
       "1f",
       false,
       2225,
       0.997002,
       {0.006187, 0.005642, 0.005340, 0.021576},
       0.003590,
       0.005002},
      {desk_gt, desk, Alignment::sim3, "30f", true, 2225, 0.997002, {}, 0.007738, 0.008686},
      {"freiburg1_xyz-groundtruth.txt",
       "freiburg1_xyz-rgbdslam.txt",
       Alignment::se3,
       "1f",
       false,
       786,
       1,
       {0.013473, 0.012029, 0.011176, 0.034727},
       0.005759,
       0.006158},
      {kitti_gt,
       kitti,
       Alignment::none,
       "10m",
       false,
       4541,
       1,
       {7.790289, 7.011750, 6.801632, 13.458509},
       0.226261,
       0.011344},
      {kitti_gt,
       kitti,
       Alignment::se3,
       "10m",
       false,
       4541,
       1,
       {1.303450, 1.156997, 1.065625, 3.587949},
       0.226261,
       0.011344},
      {kitti_gt,
       kitti,
       Alignment::sim3,
       "10m",
       false,
       4541,
       1.004698,
       {0.937709, 0.872693, 0.844691, 2.693500},
       0.206822,
       0.008995},
  };
}

TEST(Evaluate, AgreesWithKnownFiguresOfPublishedTrajectories) {
  SVOSCOPE_SKIP_WITHOUT_DATA(data);
  const auto folder = *data / "trajectories";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << "folder 'trajectories' absent";
  for (const Known& known : knownFigures()) {
    SCOPED_TRACE(std::string(known.estimate) + " " + alignmentName(known.alignment) + " " +
                 known.delta);
    const auto gt = loadTrajectory(folder / known.ground_truth);
    const auto est = loadTrajectory(folder / known.estimate);
    ASSERT_TRUE(gt.ok()) << gt.error().message();
    ASSERT_TRUE(est.ok()) << est.error().message();
    EvalOptions options;
    options.alignment = known.alignment;
    options.delta = parseDelta(known.delta).value();
    options.all_pairs = known.all_pairs;
    options.by_row = gt.value().format == TrajectoryFormat::kitti;
    const auto result = evaluate(gt.value().poses, est.value().poses, options);
    ASSERT_TRUE(result.ok()) << result.error().message();
    const EvalResult& r = result.value();
    constexpr double kTolerance = 2e-6;
    EXPECT_EQ(r.matched, known.matched);
    EXPECT_NEAR(r.scale, known.scale, kTolerance);
    if (!known.ate.empty()) {
      EXPECT_NEAR(r.ate.rmse, known.ate[0], kTolerance);
      EXPECT_NEAR(r.ate.mean, known.ate[1], kTolerance);
      EXPECT_NEAR(r.ate.median, known.ate[2], kTolerance);
      EXPECT_NEAR(r.ate.max, known.ate[3], kTolerance);
    }
    ASSERT_TRUE(r.rpe.has_value());
    EXPECT_NEAR(r.rpe->trans_rmse_m, known.rpe_trans, kTolerance);
    EXPECT_NEAR(r.rpe->rot_rmse_rad, known.rpe_rot, kTolerance);
  }
}

/// A curve in space at `rate` Hz, heading along it.
Trajectory spiral(int count, double rate = 10) {
  Trajectory poses;
  for (int i = 0; i < count; ++i) {
    const double t = i / rate;
    poses.push_back(
        {t, SE3(so3Exp(Vec3(0.1 * t, 0.3 * t, 0)), Vec3(std::cos(t), std::sin(t), 0.2 * t))});
  }
  return poses;
}

Trajectory moved(const Trajectory& poses, const Sim3& S) {
  Trajectory result = poses;
  for (StampedPose& pose : result) pose.T_world_cam = S * pose.T_world_cam;
  return result;
}

TEST(Evaluate, FindsTheSimilarityThatMovedATrajectory) {
  const Trajectory gt = spiral(100);
  Sim3 S;
  S.scale = 0.25;
  S.T = SE3(so3Exp(Vec3(0.3, -1.2, 0.5)), Vec3(4, -5, 6));
  const auto result = evaluate(gt, moved(gt, S));
  ASSERT_TRUE(result.ok()) << result.error().message();
  EXPECT_NEAR(result.value().scale, 4.0, 1e-9);
  EXPECT_LT(result.value().ate.max, 1e-9);
  EXPECT_LT(result.value().rpe->trans_rmse_m, 1e-9);
  EXPECT_LT(result.value().rpe->rot_rmse_rad, 1e-7);
  EXPECT_EQ(result.value().errors.size(), 100u);
}

TEST(Evaluate, WithoutAlignmentTheErrorIsTheOffset) {
  const Trajectory gt = spiral(50);
  Sim3 S;
  S.T = SE3(Mat3(Mat3::Identity()), Vec3(3, 4, 0));
  EvalOptions options;
  options.alignment = Alignment::none;
  const auto result = evaluate(gt, moved(gt, S), options);
  ASSERT_TRUE(result.ok());
  const ErrorStatistics& ate = result.value().ate;
  for (const double v : {ate.rmse, ate.mean, ate.median, ate.max, ate.min})
    EXPECT_NEAR(v, 5, 1e-12);
  EXPECT_NEAR(ate.stddev, 0, 1e-12);
}

TEST(Evaluate, AlignmentOnTheFirstPosesLeavesTheRestAsItIs) {
  const Trajectory gt = spiral(60);
  Trajectory est = gt;
  for (std::size_t i = 40; i < est.size(); ++i) {
    est[i].T_world_cam = SE3(est[i].T_world_cam.quaternion(),
                             Vec3(est[i].T_world_cam.translation() + Vec3(0, 0, 1)));
  }
  EvalOptions options;
  options.align_first = 40;
  const EvalResult r = evaluate(gt, est, options).value();
  EXPECT_EQ(r.aligned_on, 40);
  EXPECT_NEAR(r.scale, 1, 1e-9);
  EXPECT_LT(r.errors[39].error_m, 1e-9);
  EXPECT_NEAR(r.errors[40].error_m, 1, 1e-9);
  options.align_first = 1000;  // more than there are: all
  EXPECT_EQ(evaluate(gt, est, options).value().aligned_on, 60);
  options.align_first = 2;
  EXPECT_FALSE(evaluate(gt, est, options).ok());
}

TEST(Evaluate, TheOffsetIsAddedToTheEstimate) {
  const Trajectory gt = spiral(60);
  Trajectory est = gt;
  for (StampedPose& pose : est) pose.timestamp += 50.01;
  EvalOptions options;
  options.time_offset = -50.01;
  const auto result = evaluate(gt, est, options);
  ASSERT_TRUE(result.ok()) << result.error().message();
  EXPECT_EQ(result.value().matched, 60);
  EXPECT_LT(result.value().ate.max, 1e-9);
  EXPECT_NEAR(result.value().errors[0].timestamp, gt[0].timestamp, 1e-9);
}

TEST(Evaluate, RelativeErrorIsMissingWhenNothingIsOneIntervalApart) {
  EvalOptions options;
  options.delta = parseDelta("100s").value();
  const auto result = evaluate(spiral(50), spiral(50), options);
  ASSERT_TRUE(result.ok());
  EXPECT_FALSE(result.value().rpe.has_value());
}

TEST(Evaluate, EmptyAndUnrelatedTrajectoriesAreErrors) {
  EXPECT_FALSE(evaluate({}, spiral(10)).ok());
  EXPECT_FALSE(evaluate(spiral(10), {}).ok());
  Trajectory later = spiral(10);
  for (StampedPose& pose : later) pose.timestamp += 1000;
  const auto result = evaluate(spiral(10), later);
  ASSERT_FALSE(result.ok());
  EXPECT_EQ(result.error().kind, ErrorKind::input);
  EXPECT_NE(result.error().message().find("covers 1000.000"), std::string::npos);
}

TEST(Statistics, OfOddEvenAndNoValues) {
  const ErrorStatistics odd = statisticsOf({3, 1, 2});
  EXPECT_DOUBLE_EQ(odd.median, 2);
  EXPECT_DOUBLE_EQ(odd.min, 1);
  EXPECT_DOUBLE_EQ(odd.max, 3);
  EXPECT_NEAR(odd.rmse, std::sqrt(14.0 / 3), 1e-15);
  EXPECT_NEAR(odd.stddev, std::sqrt(2.0 / 3), 1e-15);
  EXPECT_DOUBLE_EQ(statisticsOf({1, 2, 3, 10}).median, 2.5);
  EXPECT_DOUBLE_EQ(statisticsOf({}).rmse, 0);
}

}  // namespace
}  // namespace svoscope
