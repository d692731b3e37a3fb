// SPDX-License-Identifier: MIT
#include "engine/runner/run_log.h"

#include <gtest/gtest.h>

namespace svoscope {
namespace {

SnapshotPtr snapshot(int frame, std::size_t bytes) {
  auto s = std::make_shared<Snapshot>();
  s->record.index = frame;
  s->bytes = bytes;
  return s;
}

RunnerStatus describe(const RunLog& log) {
  RunnerStatus status;
  log.describe(status);
  return status;
}

TEST(RunLog, DropsTheOldestBeyondTheBudget) {
  RunLog log(1000);
  for (int i = 0; i < 10; ++i) log.addSnapshot(snapshot(i, 300));
  EXPECT_EQ(describe(log).history_bytes, 900u);
  EXPECT_EQ(describe(log).history_budget, 1000u);
  EXPECT_EQ(describe(log).history_first, 7);
  EXPECT_EQ(log.at(6), nullptr);
  ASSERT_NE(log.at(7), nullptr);
  EXPECT_EQ(log.latest()->record.index, 9);
}

TEST(RunLog, AlwaysKeepsTheLatest) {
  RunLog log(10);
  log.addSnapshot(snapshot(0, 5000));
  log.addSnapshot(snapshot(1, 6000));
  EXPECT_EQ(log.latest()->record.index, 1);
  EXPECT_EQ(log.at(0), nullptr);
  EXPECT_EQ(describe(log).history_bytes, 6000u);
}

TEST(RunLog, FindsFramesByIndexAlsoWithGaps) {
  RunLog log(1000);
  for (const int i : {5, 7, 20}) log.addSnapshot(snapshot(i, 1));
  EXPECT_EQ(log.at(7)->record.index, 7);
  EXPECT_EQ(log.at(6), nullptr);
  EXPECT_EQ(log.at(-1), nullptr);
  EXPECT_EQ(log.at(100), nullptr);
}

TEST(RunLog, ReadsRowsFromAPosition) {
  RunLog log(1);
  FrameRecord r;
  for (int i = 0; i < 4; ++i) {
    r.index = i;
    log.addRecord(r);
    log.addEvents({{i, EventKind::info, "a"}, {i, EventKind::info, "b"}});
  }
  EXPECT_EQ(log.records(0).size(), 4u);
  EXPECT_EQ(log.records(3).front().index, 3);
  EXPECT_TRUE(log.records(4).empty());
  EXPECT_TRUE(log.records(400).empty());
  EXPECT_EQ(log.records(-2).size(), 4u);
  EXPECT_EQ(log.events(6).size(), 2u);
}

TEST(RunLog, ClearForgetsAllAndCounts) {
  RunLog log(1000);
  log.addSnapshot(snapshot(0, 10));
  log.addRecord({});
  log.addEvents({{0, EventKind::info, "a"}});
  EXPECT_EQ(log.generation(), 0);
  log.clear();
  EXPECT_EQ(log.generation(), 1);
  EXPECT_EQ(log.latest(), nullptr);
  EXPECT_TRUE(log.records(0).empty());
  EXPECT_TRUE(log.events(0).empty());
  EXPECT_EQ(describe(log).history_bytes, 0u);
}

}  // namespace
}  // namespace svoscope
