// SPDX-License-Identifier: MIT
#include "engine/study/depth_study.h"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/io/depth_study_writer.h"
#include "engine/io/lab_writer.h"
#include "engine/study/rule_variants.h"
#include "tests/support/support.h"

namespace svoscope {
namespace {

DepthStudyResult smallStudy(std::string& failure) {
  auto sequence = openSequence("synthetic:room");
  DepthStudyOptions o;
  o.max_frames = 50;
  o.keyframe_every = 20;
  o.max_age = 40;
  o.seeds_per_keyframe = 60;
  o.poses = groundTruthPoses(*sequence.value());
  o.poses_from = "groundtruth";
  auto result = runDepthStudy(*sequence.value(), o);
  if (!result.ok()) failure = result.error().message();
  return result.ok() ? result.value() : DepthStudyResult();
}

TEST(DepthStudy, SeedsFindTheDepthOfASmallSynthetic) {
  std::string failure;
  const DepthStudyResult result = smallStudy(failure);
  ASSERT_EQ(failure, "");
  EXPECT_EQ(result.frames, 50);
  EXPECT_EQ(result.keyframes, 3);
  ASSERT_EQ(result.rows.size(), ruleVariants().size());
  EXPECT_EQ(result.rows[0].rule, "KL");
  EXPECT_EQ(result.rows[3].rule, "JS both");
  for (const DepthStudyRow& r : result.rows) {
    EXPECT_EQ(r.seeds, r.converged + r.rejected + r.unfinished);
    EXPECT_EQ(r.seeds, result.rows[0].seeds);
    EXPECT_GT(r.measurements, r.seeds);
    ASSERT_GT(r.accepted, 20);
    EXPECT_LT(*r.error_quantiles[2], 0.03);
    EXPECT_LT(static_cast<double>(r.accepted_wrong) / r.accepted, 0.2);
  }
}

TEST(DepthStudy, WritesFilesWithoutNan) {
  std::string failure;
  const DepthStudyResult result = smallStudy(failure);
  ASSERT_EQ(failure, "");
  const test::TemporaryFolder folder;
  ASSERT_TRUE(writeDepthStudy(folder.path(), result).ok());
  LabOptions lab;
  lab.seeds = 100;
  lab.hopeless = 1;  // no figure exists
  ASSERT_TRUE(writeLab(folder.path(), runLab(lab)).ok());
  for (const char* name : {"depth_study.csv", "depth_study.json", "lab.csv", "curves.csv"}) {
    const std::string text = test::readText(folder / name);
    EXPECT_GT(text.size(), 100u);
    EXPECT_EQ(text.find("nan"), std::string::npos) << name;
    EXPECT_EQ(text.find("inf"), std::string::npos) << name;
  }
  for (const char* name : {"depth_study.png", "lab.png"})
    EXPECT_GT(std::filesystem::file_size(folder / name), 10000u);
  EXPECT_EQ(
      test::readText(folder / "lab.csv")
          .rfind(
              "rule,median_updates,median_relative_error,wrong_at_recall_0.8,wrong_at_recall_0.6",
              0),
      0u);
}

TEST(DepthStudy, WithoutPosesIsAnInputError) {
  auto sequence = openSequence("synthetic:room");
  DepthStudyOptions o;
  o.max_frames = 5;
  const auto result = runDepthStudy(*sequence.value(), o);
  ASSERT_FALSE(result.ok());
  EXPECT_EQ(result.error().kind, ErrorKind::input);
}

TEST(DepthStudy, GroundTruthIsInterpolatedInTime) {
  auto sequence = openSequence("synthetic:room");
  const auto poses = groundTruthPoses(*sequence.value());
  ASSERT_EQ(static_cast<int>(poses.size()), sequence.value()->size());
  ASSERT_TRUE(poses[10]);
  EXPECT_LT(
      (poses[10]->translation() - sequence.value()->groundTruth()[10].T_world_cam.translation())
          .norm(),
      1e-9);
}

}  // namespace
}  // namespace svoscope
