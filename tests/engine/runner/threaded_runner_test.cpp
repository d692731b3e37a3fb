// SPDX-License-Identifier: MIT
#include "engine/runner/threaded_runner.h"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "tests/support/memory_sequence.h"

namespace svoscope {
namespace {

using Kind = Command::Kind;
using Clock = std::chrono::steady_clock;

constexpr const char* kRoom = "synthetic:room?size=320x240&frames=50";

std::unique_ptr<Runner> makeThreaded(const std::string& spec = kRoom,
                                     std::set<int> unreadable = {}) {
  auto sequence = std::make_unique<test::ChangedSequence>(test::openBuiltIn(spec), nullptr,
                                                          std::move(unreadable));
  return std::move(makeRunner(std::move(sequence), {}).value());
}

/// Waits, at most a minute, until the condition holds.
template <typename Condition>
bool waitFor(const Condition& condition) {
  const auto end = Clock::now() + std::chrono::seconds(60);
  while (!condition()) {
    if (Clock::now() > end) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return true;
}

bool runAndRest(Runner& runner, const Command& command) {
  runner.send(command);
  return waitFor([&] { return !runner.status().playing; });
}

TEST(ThreadedRunner, PlaysToTheEnd) {
  const auto runner = makeThreaded(kRoom, {45});
  EXPECT_EQ(runner->latest(), nullptr);
  EXPECT_FALSE(runner->pump());
  ASSERT_TRUE(runAndRest(*runner, {Kind::play, -1, "", ""}));
  EXPECT_TRUE(runner->status().finished);
  const auto records = runner->records(0);
  ASSERT_EQ(records.size(), 50u);
  int good = 0;
  for (int i = 0; i < 50; ++i) {
    EXPECT_EQ(records[static_cast<std::size_t>(i)].index, i);
    good += records[static_cast<std::size_t>(i)].pose_good;
  }
  EXPECT_GT(good, 10);
  EXPECT_FALSE(records[45].pose_good);
  EXPECT_TRUE(records[46].pose_good);
  EXPECT_EQ(runner->latest()->record.index, 49);
  EXPECT_EQ(runner->events(0).back().kind, EventKind::finished);
}

TEST(ThreadedRunner, StepsPausesAndResets) {
  const auto runner = makeThreaded();
  ASSERT_TRUE(runAndRest(*runner, {Kind::step, -1, "", ""}));
  EXPECT_EQ(runner->records(0).size(), 1u);
  ASSERT_TRUE(runAndRest(*runner, {Kind::run_to_frame, 5, "", ""}));
  EXPECT_EQ(runner->latest()->record.index, 5);
  runner->send({Kind::play, -1, "", ""});
  ASSERT_TRUE(waitFor([&] { return runner->records(0).size() > 10; }));
  ASSERT_TRUE(runAndRest(*runner, {Kind::pause, -1, "", ""}));
  const std::size_t paused_at = runner->records(0).size();
  std::this_thread::sleep_for(std::chrono::milliseconds(50));
  EXPECT_EQ(runner->records(0).size(), paused_at);
  ASSERT_TRUE(runAndRest(*runner, {Kind::reset, -1, "", ""}));
  EXPECT_EQ(runner->generation(), 1);
  EXPECT_TRUE(runner->records(0).empty());
  EXPECT_EQ(runner->status().next_frame, 0);
  ASSERT_TRUE(runAndRest(*runner, {Kind::run_to_frame, 3, "", ""}));
  EXPECT_EQ(runner->records(0).size(), 4u);
}

TEST(ThreadedRunner, TwoStepsAreTwoFrames) {
  const auto runner = makeThreaded();
  runner->send({Kind::step, -1, "", ""});
  ASSERT_TRUE(runAndRest(*runner, {Kind::step, -1, "", ""}));
  EXPECT_EQ(runner->records(0).size(), 2u);
}

TEST(ThreadedRunner, ParametersTakeEffectOrWarn) {
  const auto runner = makeThreaded();
  ASSERT_TRUE(runAndRest(*runner, {Kind::set_parameter, -1, "reproject.cell_px", "44"}));
  ASSERT_TRUE(runAndRest(*runner, {Kind::set_parameter, -1, "reproject.cell_px", "1"}));
  ASSERT_EQ(runner->events(0).size(), 1u);
  EXPECT_EQ(runner->events(0)[0].kind, EventKind::warning);
  for (const ParameterView& view : runner->parameters()) {
    if (view.key == "reproject.cell_px") {
      EXPECT_EQ(view.value, "44");
    }
  }
}

TEST(ThreadedRunner, EndsWithinASecondInTheMiddleOfARun) {
  for (const char* speed : {"0", "2", "0.01"}) {
    auto runner = makeThreaded("synthetic:room?size=320x240&frames=500");
    runner->send({Kind::set_speed, -1, "", speed});
    runner->send({Kind::play, -1, "", ""});
    ASSERT_TRUE(waitFor([&] { return !runner->records(0).empty(); }));
    const auto start = Clock::now();
    runner.reset();
    EXPECT_LT(Clock::now() - start, std::chrono::seconds(1)) << speed;
  }
}

TEST(ThreadedRunner, EndsWithoutEverHavingRun) {
  for (int i = 0; i < 5; ++i) makeThreaded();
}

TEST(ThreadedRunner, MayBeReadAndResetWhileItRuns) {
  const auto runner = makeThreaded();
  runner->send({Kind::play, -1, "", ""});
  for (int i = 0; i < 4; ++i) {
    const int generation = runner->generation();
    ASSERT_TRUE(waitFor([&] {
      if (const SnapshotPtr s = runner->latest(); s && s->seeds) {
        for (const SeedView& seed : *s->seeds) EXPECT_GE(seed.id, 0);
      }
      runner->parameters();
      runner->events(0);
      runner->at(3);
      return runner->records(0).size() >= 12 || runner->status().finished;
    }));
    runner->send({Kind::reset, -1, "", ""});
    runner->send({Kind::play, -1, "", ""});
    ASSERT_TRUE(waitFor([&] { return runner->generation() > generation; }));
  }
}

}  // namespace
}  // namespace svoscope
