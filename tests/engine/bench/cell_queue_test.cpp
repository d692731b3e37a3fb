// SPDX-License-Identifier: MIT
#include "engine/bench/cell_queue.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <csignal>

#include "tests/support/support.h"

namespace svoscope {
namespace {

namespace fs = std::filesystem;

struct CellQueue : testing::Test {
  test::TemporaryFolder folder;
  std::vector<RunEnd> ends;
  std::vector<std::string> logs;

  /// Each script gets "--out FOLDER" as $0 and $1.
  Result<bool> run(const std::vector<std::string>& scripts, const QueueOptions& options) {
    std::vector<QueuedRun> runs;
    for (const std::string& script : scripts) {
      const fs::path place = folder / ("r" + std::to_string(runs.size()));
      runs.push_back({{"/bin/sh", "-c", script}, place, temporaryBeside(place)});
    }
    ends.resize(scripts.size());
    logs.resize(scripts.size());
    const auto done = [&](std::size_t i, const RunEnd& end) -> Status {
      ends[i] = end;
      logs[i] = test::readText(runs[i].temporary / "log.txt");
      return Done{};
    };
    return runQueue(runs, options, done);
  }
  bool empty() const { return fs::is_empty(folder.path()); }
};

TEST_F(CellQueue, EndsAndOutputsAreHandedOn) {
  const auto finished =
      run({"echo one; echo $0 >&2", "exit 3", "kill -9 $$", "sleep 0.1"}, {2, 0, nullptr});
  ASSERT_TRUE(finished.ok());
  EXPECT_TRUE(finished.value());
  EXPECT_EQ(ends[0].end.exit_code, 0);
  EXPECT_EQ(logs[0], "one\n--out\n");
  EXPECT_EQ(ends[1].end.exit_code, 3);
  EXPECT_EQ(ends[2].end.signal, SIGKILL);
  EXPECT_EQ(ends[3].end.signal, 0);
  EXPECT_TRUE(empty());  // what was not moved away is removed
}

TEST_F(CellQueue, WhatTakesTooLongIsEnded) {
  ASSERT_TRUE(run({"sleep 600", "true"}, {1, 0.2, nullptr}).ok());
  EXPECT_TRUE(ends[0].timed_out);
  EXPECT_FALSE(ends[1].timed_out);
}

TEST_F(CellQueue, StoppingEndsWhatRuns) {
  std::atomic<bool> stop{false};
  std::vector<QueuedRun> runs;
  for (const char* script : {"true", "sleep 600", "sleep 600"}) {
    const fs::path place = folder / std::to_string(runs.size());
    runs.push_back({{"/bin/sh", "-c", script}, place, temporaryBeside(place)});
  }
  int ended = 0;
  const auto finished = runQueue(runs, {3, 0, &stop}, [&](std::size_t, const RunEnd&) -> Status {
    ++ended;
    stop = true;
    return Done{};
  });
  ASSERT_TRUE(finished.ok());
  EXPECT_FALSE(finished.value());
  EXPECT_EQ(ended, 1);
  EXPECT_TRUE(empty());
}

TEST_F(CellQueue, AProgramThatCannotBeStartedHasAnExitCode) {
  const std::vector<QueuedRun> runs = {
      {{"/no/such/program"}, folder / "a", temporaryBeside(folder / "a")}};
  int code = 0;
  ASSERT_TRUE(runQueue(runs, {}, [&](std::size_t, const RunEnd& end) -> Status {
                code = end.end.exit_code;
                return Done{};
              }).ok());
  EXPECT_EQ(code, 127);
}

TEST_F(CellQueue, OnlyFoldersOfEndedProcessesAreRemoved) {
  const fs::path mine = temporaryBeside(folder / "cells/a/run-1");
  std::string name = mine.filename().string();
  const std::string pid = "." + std::to_string(getpid()) + ".";
  ASSERT_NE(name.find(pid), std::string::npos);
  const fs::path gone =
      mine.parent_path() / name.replace(name.find(pid), pid.size(), ".2147483646.");
  fs::create_directories(mine);
  fs::create_directories(gone);
  fs::create_directories(folder / "cells/a/run-1");
  removeAbandoned(folder.path());
  EXPECT_TRUE(fs::exists(mine));
  EXPECT_FALSE(fs::exists(gone));
  EXPECT_TRUE(fs::exists(folder / "cells/a/run-1"));
}

}  // namespace
}  // namespace svoscope
