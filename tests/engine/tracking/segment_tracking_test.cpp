// SPDX-License-Identifier: MIT
// End to end: the three methods on short rendered sequences.
#include "engine/tracking/segment_tracking.h"

#include <gtest/gtest.h>

#include "engine/dataset/synthetic/synthetic.h"
#include "engine/eval/evaluate.h"
#include "engine/runner/make_runner.h"
#include "engine/tracking/tracker.h"

namespace svoscope {
namespace {

struct Figures {
  int frames = 0, tracked = 0;  ///< since the start
  double mean_segments = 0;
  std::size_t landmarks = 0;
  int keyframes = 0;
};

Figures run(const std::string& spec, bool segments) {
  auto sequence = openSyntheticSequence(spec);
  EXPECT_TRUE(sequence.ok());
  TrackerParameters parameters;
  parameters.mapping.segments.enabled = segments;
  Tracker tracker(sequence.value()->camera().pinhole, parameters);
  Figures f;
  for (int i = 0; i < sequence.value()->size(); ++i) {
    const auto image = sequence.value()->read(i);
    EXPECT_TRUE(image.ok());
    tracker.process(i, image.value().timestamp, image.value().gray);
    if (auto job = tracker.takeMappingJob())
      tracker.applyMapping(runMappingJob(*job, parameters.mapping));
    const FrameRecord& r = tracker.record();
    f.frames += f.frames > 0 || r.pose_good;
    f.tracked += r.pose_good;
    f.mean_segments += r.funnel.inlier_segments;
  }
  f.mean_segments /= std::max(f.frames, 1);
  f.landmarks = tracker.map().segments.size();
  f.keyframes = static_cast<int>(tracker.map().keyframes.size());
  for (const auto& [id, s] : tracker.map().segments) EXPECT_GE(s.views.size(), 2u);
  return f;
}

class SegmentTracking : public testing::TestWithParam<const char*> {};

TEST_P(SegmentTracking, SegmentsAreFollowedAndBecomeLandmarks) {
  const Figures f = run(GetParam(), true);
  EXPECT_GT(f.frames, 40);
  EXPECT_EQ(f.tracked, f.frames);
  EXPECT_GT(f.mean_segments, 0.5);  // few at first: their depth is known late
  EXPECT_GT(f.landmarks, 2u);
}
INSTANTIATE_TEST_SUITE_P(Presets, SegmentTracking,
                         testing::Values("synthetic:corridor?frames=70&size=320x240",
                                         "synthetic:room?frames=60"));

TEST(SegmentTracking, MethodSvoHasNone) {
  const Figures f = run("synthetic:corridor?frames=40&size=320x240", false);
  EXPECT_EQ(f.mean_segments, 0);
  EXPECT_EQ(f.landmarks, 0u);
}

TEST(SegmentTracking, RemovingKeyframesKeepsTheMapConsistent) {
  auto sequence = openSyntheticSequence("synthetic:corridor?frames=90&size=320x240");
  TrackerParameters parameters;
  parameters.mapping.segments.enabled = true;
  parameters.keyframe.max_keyframes = 3;
  Tracker tracker(sequence.value()->camera().pinhole, parameters);
  for (int i = 0; i < sequence.value()->size(); ++i) {
    tracker.process(i, i / 30.0, sequence.value()->read(i).value().gray);
    if (auto job = tracker.takeMappingJob())
      tracker.applyMapping(runMappingJob(*job, parameters.mapping));
    for (const auto& [id, k] : tracker.map().keyframes) {
      for (const std::int64_t s : k.segments) ASSERT_TRUE(tracker.map().segments.count(s));
    }
    for (const auto& [id, s] : tracker.map().segments) {
      for (const SegmentView& v : s.views)
        ASSERT_TRUE(tracker.map().keyframes.count(v.keyframe_id));
    }
  }
}

TEST(MakeRunner, KnowsTheThreeMethods) {
  for (const char* method : {"svo", "pl-svo", "it-svo"}) {
    RunnerOptions options;
    options.method = method;
    options.threaded = false;
    EXPECT_TRUE(
        makeRunner(openSyntheticSequence("synthetic:room?frames=5&size=160x120").value(), options)
            .ok());
  }
  RunnerOptions options;
  options.method = "lines";
  EXPECT_FALSE(makeRunner(openSyntheticSequence("synthetic:room?frames=5").value(), options).ok());
}

}  // namespace
}  // namespace svoscope
