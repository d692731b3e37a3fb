// SPDX-License-Identifier: MIT
#include "app/drive.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "tests/support/scripted_runner.h"
#include "tests/support/support.h"

namespace svoscope {
namespace {

struct DriveTest : testing::Test {
  test::TemporaryFolder folder;
  RunWriter writer;
  DriveOptions options;

  Result<DriveOutcome> run(Runner& runner) {
    EXPECT_TRUE(writer.begin(folder / "out", runner.info(), "").ok());
    return drive(runner, writer, options);
  }
};

TEST_F(DriveTest, EveryFrameIsWritten) {
  test::ScriptedRunner runner(test::fakeRecords(40));
  int shown = 0;
  options.progress = [&](const FrameRecord&, const RunnerStatus&) { ++shown; };
  const auto outcome = run(runner);
  ASSERT_TRUE(outcome.ok());
  EXPECT_EQ(outcome.value().frames, 40);
  EXPECT_FALSE(outcome.value().interrupted);
  EXPECT_EQ(writer.records().size(), 40u);
  EXPECT_EQ(shown, 40);
}

TEST_F(DriveTest, UnreadableFramesAreCountedAndWarned) {
  test::ScriptedRunner runner(test::fakeRecords(40));
  runner.unreadable = 2;
  runner.events_ = {{7, EventKind::warning, "cannot be decoded"}, {8, EventKind::info, "x"}};
  const auto outcome = run(runner);
  ASSERT_TRUE(outcome.ok());
  EXPECT_EQ(outcome.value().frames, 42);
  ASSERT_EQ(outcome.value().warnings.size(), 1u);
  EXPECT_EQ(outcome.value().warnings[0], "frame 7: cannot be decoded");
}

TEST_F(DriveTest, AnInterruptEndsTheRunWithWhatIsDone) {
  test::ScriptedRunner runner(test::fakeRecords(40));
  std::atomic<bool> stop{false};
  options.stop = &stop;
  runner.after_frame = [&](int done) { stop = done >= 5; };
  const auto outcome = run(runner);
  ASSERT_TRUE(outcome.ok());
  EXPECT_TRUE(outcome.value().interrupted);
  EXPECT_EQ(outcome.value().frames, 5);
  EXPECT_EQ(writer.records().size(), 5u);
  EXPECT_TRUE(writer.finish(runner.latest(), 5).ok());
}

TEST_F(DriveTest, AnEngineThatStopsByItselfIsReported) {
  test::ScriptedRunner runner(test::fakeRecords(40));
  runner.stop_after = 10;
  const auto outcome = run(runner);
  ASSERT_TRUE(outcome.ok());
  ASSERT_EQ(outcome.value().errors.size(), 1u);
  EXPECT_EQ(writer.records().size(), 10u);
}

TEST_F(DriveTest, AnEmptySequenceEndsAtOnce) {
  test::ScriptedRunner runner({});
  const auto outcome = run(runner);
  ASSERT_TRUE(outcome.ok());
  EXPECT_EQ(outcome.value().frames, 0);
}

TEST_F(DriveTest, AFullDiskStopsTheRun) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "no /dev/full";
  std::filesystem::create_directories(folder / "out");
  test::ScriptedRunner runner(test::fakeRecords(40));
  ASSERT_TRUE(writer.begin(folder / "out", runner.info(), "").ok());
  RunWriter full;
  std::filesystem::remove(folder / "out" / "frames.csv");
  std::filesystem::create_symlink("/dev/full", folder / "out" / "frames.csv");
  const Status begun = full.begin(folder / "out", runner.info(), "");
  ASSERT_FALSE(begun.ok());  // the header already does not fit
  EXPECT_EQ(begun.error().exitCode(), 4);
}

}  // namespace
}  // namespace svoscope
