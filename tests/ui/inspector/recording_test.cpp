// SPDX-License-Identifier: MIT
// Every panel over a recording, without pixels and without an engine.
#include <gtest/gtest.h>

#include "tests/support/recorded_run.h"
#include "ui/host.h"
#include "ui/inspector.h"
#include "ui/model/search_cache.h"
#include "ui/panels/panel.h"
#include "ui/panels/panel_context.h"
#include "ui/widgets/probe.h"

namespace svoscope::ui {
namespace {

using Kind = Command::Kind;
constexpr int kFrames = 40;

const test::RecordedRun& sample() {
  static test::RecordedRun run("synthetic:room?frames=40", test::synchronous("it-svo"));
  static const bool finished = run.finish().ok();
  EXPECT_TRUE(finished);
  return run;
}

class RecordingPanels : public testing::Test {
 protected:
  void SetUp() override {
    HostOptions options;
    options.surface = SurfaceKind::null;
    options.size = {1600, 1000};
    auto host = Host::open(options);
    ASSERT_TRUE(host.ok());
    host_ = std::move(host).value();
    runner_ = sample().open();
    ASSERT_NE(runner_, nullptr);
    inspector_ = std::make_unique<Inspector>(*runner_, host_->graphics());
    frames(2);
  }
  void frames(int count) {
    for (int i = 0; i < count; ++i) {
      runner_->pump();
      host_->frame(*inspector_, false);
    }
  }
  void send(Kind kind, int frame = -1) {
    runner_->send({kind, frame, "", ""});
    frames(2);
  }
  void press(Key key, bool shift = false) {
    host_->scriptInput().shift = shift;
    host_->scriptInput().setKey(key, true);
    frames(1);
    host_->scriptInput().setKey(key, false);
    host_->scriptInput().shift = false;
    frames(2);
  }
  void clickAt(ImVec2 at) {
    host_->scriptInput().mouse = at;
    frames(1);
    host_->scriptInput().setButton(0, true);
    frames(1);
    host_->scriptInput().setButton(0, false);
    frames(2);
    host_->scriptInput().mouse = InputState::nowhere();
    host_->skipTime(1);
    frames(1);
  }
  /// Middle of a frame in the timeline.
  void clickTimeline(int frame) {
    const auto rect = Probe::find("Timeline");
    ASSERT_TRUE(rect);
    const float x =
        rect->min.x + (rect->max.x - rect->min.x) * (static_cast<float>(frame) + 0.5f) / kFrames;
    clickAt({x, (rect->min.y + rect->max.y) / 2});
  }
  void show(const std::string& panel) {
    if (!hasPanel(state().layout.root, panel)) showPanel(state().layout.root, panel);
    raisePanel(state().layout.root, panel);
    state().maximized = panel;
    frames(3);
  }
  int viewed() const {
    return inspector_->state().viewed_frame >= 0 ? inspector_->state().viewed_frame
                                                 : runner_->latest()->record.index;
  }
  UiState& state() { return inspector_->state(); }

  std::unique_ptr<Host> host_;
  std::unique_ptr<Runner> runner_;
  std::unique_ptr<Inspector> inspector_;
};

/// A seed with many measurements in the last frame of the recording.
std::int64_t busySeed(const Runner& runner) {
  const SnapshotPtr s = runner.at(kFrames - 1);
  const SeedView* best = nullptr;
  for (const SeedView& seed : *s->seeds) {
    if (seed.type != FeatureType::segment && (!best || seed.updates > best->updates)) best = &seed;
  }
  return best ? best->id : -1;
}

TEST_F(RecordingPanels, EveryPanelAndLayoutIsDrawn) {
  send(Kind::run_to_frame, 1000);
  state().selection = {Selection::Kind::seed, busySeed(*runner_)};
  for (const std::string& layout : presetNames()) {
    state().layout = presetLayout(layout);
    state().maximized.clear();
    frames(3);
    EXPECT_TRUE(Probe::find("Timeline")) << layout;
  }
  for (const Panel* panel : panels()) {
    show(panel->name);
    EXPECT_TRUE(Probe::find(std::string("panel:") + panel->name)) << panel->name;
  }
}

TEST_F(RecordingPanels, ASeedHasItsWholeHistory) {
  send(Kind::run_to_frame, 1000);
  const std::int64_t id = busySeed(*runner_);
  state().selection = {Selection::Kind::seed, id};
  show("Seed");
  int updates = 0;
  for (const SnapshotPtr& s : sample().kept->snapshots) {
    for (const SeedUpdateView& u : *s->seed_updates) updates += u.seed_id == id;
  }
  EXPECT_GT(updates, 3);
  EXPECT_EQ(state().seed.held_updates, updates);
  EXPECT_EQ(state().seed.shown_update, updates);
}

TEST_F(RecordingPanels, TheEpipolarSearchIsExplained) {
  send(Kind::run_to_frame, 1000);
  SearchCache cache;
  int explained = 0, asked = 0;
  for (int frame = 25; frame < kFrames; ++frame) {
    const SnapshotPtr s = runner_->at(frame);
    for (std::size_t i = 0; i < s->seed_updates->size() && i < 10; ++i) {
      const SeedUpdateView& update = (*s->seed_updates)[i];
      const auto seed = std::find_if(s->seeds->begin(), s->seeds->end(),
                                     [&](const SeedView& v) { return v.id == update.seed_id; });
      if (seed == s->seeds->end() || seed->type == FeatureType::segment) continue;
      ++asked;
      const SearchDetail* detail = cache.find(*runner_, *seed, update, static_cast<int>(i), frame);
      EXPECT_TRUE(detail) << cache.problem();
      explained += detail && !detail->patch_warped.empty();
    }
  }
  EXPECT_GT(asked, 50);
  EXPECT_GT(explained, asked / 2);
}

TEST_F(RecordingPanels, TheTimelineReachesAllThatWasPlayed) {
  send(Kind::run_to_frame, 1000);
  clickTimeline(12);
  EXPECT_EQ(viewed(), 12);
  press(Key::right);
  EXPECT_EQ(viewed(), 13);
  EXPECT_EQ(runner_->latest()->record.index, kFrames - 1);
  // Play goes on from the frame in view, not from the end.
  runner_->send({Kind::set_speed, -1, "", "0.001"});
  press(Key::space);
  EXPECT_TRUE(runner_->status().playing);
  EXPECT_LE(viewed(), 15);
  press(Key::space);
  EXPECT_FALSE(runner_->status().playing);
  // And forward again, beyond the frame played last.
  clickTimeline(33);
  EXPECT_EQ(viewed(), 33);
  EXPECT_EQ(runner_->records(0).size(), static_cast<std::size_t>(kFrames));
  // At the end it plays from the beginning.
  clickTimeline(kFrames - 1);
  EXPECT_EQ(viewed(), kFrames - 1);
  press(Key::space);
  EXPECT_LE(viewed(), 2);
  EXPECT_TRUE(runner_->status().playing);
}

TEST_F(RecordingPanels, RunsToTheNextKeyframeFromTheFrameInView) {
  send(Kind::run_to_frame, 1000);
  int keyframe = -1;
  for (const FrameRecord& r : runner_->records(0)) {
    if (r.is_keyframe && r.index > 0 && keyframe < 0) keyframe = r.index;
  }
  ASSERT_GT(keyframe, 1);
  clickTimeline(keyframe - 1);
  press(Key::right, true);
  EXPECT_EQ(viewed(), keyframe);
}

TEST_F(RecordingPanels, ParametersAreReadOnlyAndSaySo) {
  send(Kind::run_to_frame, 1000);
  show("Parameters");
  EXPECT_TRUE(Probe::find("read only"));
  const auto rect = Probe::find("local_ba");
  const auto before = runner_->parameters();
  if (rect) clickAt(rect->center());
  for (std::size_t i = 0; i < before.size(); ++i)
    EXPECT_EQ(runner_->parameters()[i].value, before[i].value);
}

}  // namespace
}  // namespace svoscope::ui
