// SPDX-License-Identifier: MIT
#include "engine/tracking/keyframe_policy.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace svoscope {
namespace {

/// Evidence for which a keyframe is taken.
KeyframeEvidence due() {
  KeyframeEvidence e;
  e.landmarks = 100;
  e.inliers = 150;
  e.required = 20;
  e.frames_since_last = 10;
  e.displacement_px = 60;
  e.shares_landmarks = true;
  e.nearest_distance = 0.2;
  e.nearest_angle_deg = 5;
  return e;
}

void expectRefused(const KeyframeEvidence& e, const std::string& reason) {
  const KeyframeDecision d = decideKeyframe(e, {});
  EXPECT_FALSE(d.take) << d.reason;
  EXPECT_THAT(d.reason, testing::HasSubstr(reason));
}

void expectTaken(const KeyframeEvidence& e, const std::string& reason) {
  const KeyframeDecision d = decideKeyframe(e, {});
  EXPECT_TRUE(d.take) << d.reason;
  EXPECT_THAT(d.reason, testing::HasSubstr(reason));
}

TEST(KeyframePolicy, TakesOneWhenLandmarksThinOutAndTheCameraMoved) {
  expectTaken(due(), "moved 60 px");
}

TEST(KeyframePolicy, NoneWhileLandmarksAreMany) {
  KeyframeEvidence e = due();
  e.landmarks = 121;
  expectRefused(e, "121 landmarks > 120");
}

TEST(KeyframePolicy, NoneRightAfterTheLast) {
  KeyframeEvidence e = due();
  e.frames_since_last = 1;
  e.landmarks = 10;
  expectRefused(e, "1 frames since the last");
}

TEST(KeyframePolicy, AtOnceWhenLandmarksRunOut) {
  KeyframeEvidence e = due();
  e.landmarks = 69;
  e.displacement_px = 5;
  e.nearest_distance = 0;
  e.nearest_angle_deg = 0;
  expectTaken(e, "69 landmarks < 70");
}

TEST(KeyframePolicy, NoneWhileTheCameraStandsHoweverFewTheLandmarks) {
  KeyframeEvidence e = due();
  e.landmarks = 10;
  e.displacement_px = 3.9;
  e.nearest_distance = 0.009;
  expectRefused(e, "stands: moved 3.9 px");
  e.shares_landmarks = false;  // no motion is known
  expectTaken(e, "10 landmarks < 70");
  e.shares_landmarks = true;
  e.nearest_distance = 0.011;
  expectTaken(e, "10 landmarks < 70");
}

TEST(KeyframePolicy, NoneWithoutImageMotion) {
  KeyframeEvidence e = due();
  e.displacement_px = 39;
  expectRefused(e, "moved 39 px");
  e.shares_landmarks = false;  // nothing to compare with
  expectTaken(e, "landmarks");
}

TEST(KeyframePolicy, NoneBesideAnotherUnlessTurned) {
  KeyframeEvidence e = due();
  e.nearest_distance = 0.09;
  expectRefused(e, "a keyframe lies within");
  e.nearest_angle_deg = 21;
  expectTaken(e, "landmarks");
}

}  // namespace
}  // namespace svoscope
