// SPDX-License-Identifier: MIT
// What comes out of a recording is what went in.
#include <gtest/gtest.h>

#include <opencv2/core.hpp>

#include "engine/mapping/seed_update.h"
#include "engine/runner/search_detail.h"
#include "tests/support/recorded_run.h"
#include "tests/support/snapshot_text.h"

namespace svoscope {
namespace {

using test::RecordedRun;
using test::synchronous;

constexpr const char* kRoom = "synthetic:room?frames=30";

void expectSame(const Snapshot& recorded, const Snapshot& kept) {
  const auto a = test::textOf(recorded), b = test::textOf(kept);
  ASSERT_EQ(a.size(), b.size()) << "frame " << kept.record.index;
  for (std::size_t i = 0; i < a.size(); ++i)
    ASSERT_EQ(a[i], b[i]) << "frame " << kept.record.index << ", line " << i;
}

void expectSameImage(const Snapshot& recorded, const Snapshot& kept) {
  ASSERT_EQ(recorded.pyramid != nullptr, kept.pyramid != nullptr);
  if (!kept.pyramid) return;
  ASSERT_EQ(recorded.pyramid->size(), kept.pyramid->size());
  for (std::size_t level = 0; level < kept.pyramid->size(); ++level) {
    const cv::Mat &a = (*recorded.pyramid)[level], &b = (*kept.pyramid)[level];
    ASSERT_EQ(a.size(), b.size());
    EXPECT_LT(cv::norm(a, b, cv::NORM_L1) / static_cast<double>(b.total()), 2.0)
        << "grey levels, level " << level;
  }
}

/// Frames in an order that goes back and forth, so that differences are unpacked from everywhere.
void expectSameRun(const Runner& recorded, const std::vector<SnapshotPtr>& kept) {
  const std::size_t n = kept.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Snapshot& wanted = *kept[i * 7 % n];
    const SnapshotPtr found = recorded.at(wanted.record.index);
    ASSERT_NE(found, nullptr) << wanted.record.index;
    expectSame(*found, wanted);
    expectSameImage(*found, wanted);
    if (testing::Test::HasFatalFailure()) return;
  }
}

class RoundTrip : public testing::TestWithParam<const char*> {};

TEST_P(RoundTrip, SnapshotsAreTheSameBitByBit) {
  RecordedRun run(kRoom, synchronous(GetParam()));
  ASSERT_TRUE(run.finish().ok());
  const auto recorded = run.open();
  ASSERT_NE(recorded, nullptr);
  const auto& kept = run.kept->snapshots;
  ASSERT_EQ(kept.size(), 30u);
  expectSameRun(*recorded, kept);
  const Snapshot& last = *kept.back();
  EXPECT_GT(last.seeds->size(), 50u);
  EXPECT_GT(last.seed_updates->size(), 20u);
  EXPECT_GT(last.points->size(), 20u);
  EXPECT_GT(last.features.size(), 50u);
  const bool segments = std::any_of(last.seeds->begin(), last.seeds->end(), [](const SeedView& s) {
    return s.type == FeatureType::segment;
  });
  EXPECT_EQ(segments, std::string(GetParam()) != "svo");
}

INSTANTIATE_TEST_SUITE_P(Methods, RoundTrip, testing::Values("svo", "pl-svo", "it-svo"),
                         [](const auto& test_case) {
                           std::string name = test_case.param;
                           name.erase(std::remove(name.begin(), name.end(), '-'), name.end());
                           return name;
                         });

TEST(Recording, AThreadedRunIsTheSameToo) {
  RunnerOptions options;
  options.method = "it-svo";
  RecordedRun run("synthetic:room?frames=60&size=320x240", options);
  ASSERT_TRUE(run.finish().ok());
  const auto recorded = run.open();
  ASSERT_NE(recorded, nullptr);
  ASSERT_EQ(run.kept->snapshots.size(), 60u);
  expectSameRun(*recorded, run.kept->snapshots);
}

TEST(Recording, HoldsWhatTheRunIs) {
  RecordedRun run("synthetic:room?frames=5&size=320x240", synchronous("it-svo"));
  ASSERT_TRUE(run.finish().ok());
  const auto recorded = run.open();
  ASSERT_NE(recorded, nullptr);
  const RunInfo &a = recorded->info(), &b = run.runner->info();
  EXPECT_EQ(a.sequence, b.sequence);
  EXPECT_EQ(a.method, "it-svo");
  EXPECT_EQ(a.frames, 5);
  EXPECT_EQ(a.rate_hz, b.rate_hz);
  EXPECT_EQ(a.camera.fx, b.camera.fx);
  EXPECT_EQ(a.camera.height, 240);
  EXPECT_EQ(a.original_camera.pinhole.cx, b.original_camera.pinhole.cx);
  ASSERT_EQ(a.ground_truth.size(), b.ground_truth.size());
  EXPECT_EQ(a.ground_truth.back().T_world_cam.matrix(), b.ground_truth.back().T_world_cam.matrix());
  const auto parameters = recorded->parameters(), original = run.runner->parameters();
  ASSERT_EQ(parameters.size(), original.size());
  for (std::size_t i = 0; i < original.size(); ++i) {
    EXPECT_EQ(parameters[i].key, original[i].key);
    EXPECT_EQ(parameters[i].value, original[i].value);
    EXPECT_EQ(parameters[i].maximum, original[i].maximum);
  }
}

TEST(Recording, ASearchIsExplainedFromTheRecordedImages) {
  RecordedRun run(kRoom, synchronous("it-svo"));
  ASSERT_TRUE(run.finish().ok());
  const auto recorded = run.open();
  ASSERT_NE(recorded, nullptr);
  const Snapshot& kept = *run.kept->snapshots.back();
  const SnapshotPtr found = recorded->at(kept.record.index);
  ASSERT_TRUE(found && found->mapping);
  EXPECT_EQ(found->mapping->search.search_sigmas, kept.mapping->search.search_sigmas);
  EXPECT_EQ(found->mapping->filter.rule, FilterRule::js);
  // Panels complete the keyframe's image, which a recorded snapshot does not hold.
  Snapshot completed = *found;
  auto keyframes = std::make_shared<std::vector<KeyframeView>>(*found->keyframes);
  for (KeyframeView& k : *keyframes) k.pyramid = recorded->at(k.frame_index)->pyramid;
  completed.keyframes = keyframes;
  int compared = 0;
  for (const SeedUpdateView& update : *kept.seed_updates) {
    if (update.outcome != SearchOutcome::matched || update.frame_index != kept.record.index)
      continue;
    const auto seed = std::find_if(kept.seeds->begin(), kept.seeds->end(),
                                   [&](const SeedView& s) { return s.id == update.seed_id; });
    if (seed == kept.seeds->end() || seed->type == FeatureType::segment) continue;
    const auto live = explainSearch(*seed, update, kept, run.runner->info());
    const auto replayed = explainSearch(*seed, update, completed, recorded->info());
    ASSERT_TRUE(live.ok() && replayed.ok());
    ASSERT_EQ(live.value().profile.size(), replayed.value().profile.size());
    EXPECT_EQ(live.value().best >= 0, replayed.value().best >= 0);
    ++compared;
  }
  EXPECT_GT(compared, 5);
}

TEST(Recording, UnreadableFramesAreRowsWithoutContent) {
  RecordedRun run("synthetic:room?frames=8&size=320x240", synchronous("svo"), {3});
  ASSERT_TRUE(run.finish().ok());
  const auto recorded = run.open();
  ASSERT_NE(recorded, nullptr);
  expectSameRun(*recorded, run.kept->snapshots);
  const SnapshotPtr empty = recorded->at(3);
  EXPECT_EQ(empty->pyramid, nullptr);
  EXPECT_EQ(empty->seeds, nullptr);
  ASSERT_EQ(empty->events.size(), 1u);
  EXPECT_EQ(empty->events[0].kind, EventKind::warning);
}

TEST(Recording, AResetForgetsWhatCameBefore) {
  RecordedRun run("synthetic:room?frames=12&size=320x240", synchronous("svo"));
  run.send(Command::Kind::run_to_frame, 8);
  run.send(Command::Kind::reset);
  run.send(Command::Kind::run_to_frame, 4);
  ASSERT_TRUE(run.recorder->close().ok());
  const auto recorded = run.open();
  ASSERT_NE(recorded, nullptr);
  ASSERT_EQ(run.kept->snapshots.size(), 5u);
  expectSameRun(*recorded, run.kept->snapshots);
  EXPECT_EQ(recorded->at(5), nullptr);
  EXPECT_FALSE(recorded->parameters().empty());
}

TEST(Recording, ParametersHoldFromTheFrameTheyWereSetAt) {
  RecordedRun run("synthetic:room?frames=6&size=320x240", synchronous("svo"));
  run.send(Command::Kind::run_to_frame, 2);
  run.send(Command::Kind::set_parameter, -1, "search.sigmas", "2.25");
  run.send(Command::Kind::set_parameter, -1, "no.such", "1");
  ASSERT_TRUE(run.finish().ok());
  const auto recorded = run.open();
  ASSERT_NE(recorded, nullptr);
  EXPECT_EQ(recorded->at(2)->mapping->search.search_sigmas, 3.0);
  EXPECT_EQ(recorded->at(3)->mapping->search.search_sigmas, 2.25);
  recorded->send({Command::Kind::run_to_frame, 5, "", ""});
  const auto events = recorded->events(0);
  EXPECT_TRUE(std::any_of(events.begin(), events.end(), [](const Event& e) {
    return e.text.find("no.such") != std::string::npos;
  }));
  EXPECT_EQ(events.back().kind, EventKind::finished);
}

/// A field that is added to a value must be added to its list in engine/recording/columns.h, and
/// then the version of the tables rises.
TEST(Recording, NoFieldIsForgotten) {
  EXPECT_EQ(sizeof(FrameRecord), 416u);
  EXPECT_EQ(sizeof(FeatureView), 56u);
  EXPECT_EQ(sizeof(SeedView), 200u);
  EXPECT_EQ(sizeof(SeedUpdateView), 120u);
  EXPECT_EQ(sizeof(MapPointView), 48u);
  EXPECT_EQ(sizeof(Event), 40u);
}

}  // namespace
}  // namespace svoscope
