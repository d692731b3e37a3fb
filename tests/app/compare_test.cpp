// SPDX-License-Identifier: MIT
// Several methods and trajectories of other systems from the command line.
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "app/open_runs.h"
#include "tests/support/program.h"

namespace svoscope {
namespace {

namespace fs = std::filesystem;
using test::Outcome;
using test::runProgram;

struct CompareCommand : testing::Test {
  test::TemporaryFolder folder;
  std::string path(const std::string& name) const { return (folder / name).string(); }
  Outcome shot(const std::string& script, const std::string& options) {
    test::writeText(folder / "a.script", script);
    return runProgram("shot synthetic:room --max-frames 40 --size 640x400 --script " +
                      path("a.script") + " --out " + path("shots") + " " + options);
  }
};

TEST(SplitLabel, TakesWhatFollowsTheLastEqualsSign) {
  using Pair = std::pair<std::string, std::string>;
  EXPECT_EQ(splitLabel("runs/orb.txt=ORB-SLAM2"), Pair("runs/orb.txt", "ORB-SLAM2"));
  EXPECT_EQ(splitLabel("runs/orb.txt"), Pair("runs/orb.txt", "orb"));
  EXPECT_EQ(splitLabel("a=b/orb.txt"), Pair("a=b/orb.txt", "orb")) << "part of a folder's name";
  EXPECT_EQ(splitLabel("orb.txt="), Pair("orb.txt=", "orb"));
}

TEST_F(CompareCommand, RunsAllMethodsIntoFoldersAndPrintsOneTable) {
  const Outcome outcome =
      runProgram("run synthetic:room --method all --sync --max-frames 30 --out " + path("out"));
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  for (const char* method : {"svo", "pl-svo", "it-svo"}) {
    for (const char* name : {"trajectory.txt", "keyframes.txt", "frames.csv", "map.ply",
                             "metrics.json", "config.yaml"}) {
      EXPECT_TRUE(fs::exists(folder / "out" / method / name)) << method << " " << name;
    }
    EXPECT_NE(outcome.out.find(std::string("\n") + method + " "), std::string::npos) << outcome.out;
    const std::string config = test::readText(folder / "out" / method / "config.yaml");
    EXPECT_NE(config.find(method), std::string::npos);
  }
  EXPECT_NE(outcome.out.find("ATE m"), std::string::npos);
}

TEST_F(CompareCommand, NeverInitialisedOnlyIfNoMethodDid) {
  const Outcome outcome = runProgram(
      "run synthetic:room --method svo --method it-svo --sync --max-frames 2 --out " + path("out"));
  EXPECT_EQ(outcome.exit_code, 5) << outcome.err;
  EXPECT_TRUE(fs::exists(folder / "out/it-svo/metrics.json"));
  EXPECT_FALSE(fs::exists(folder / "out/pl-svo"));
}

TEST_F(CompareCommand, ARunInLockstepIsTheRunAlone) {
  ASSERT_EQ(
      runProgram("run synthetic:room --method all --sync --max-frames 40 --out " + path("out"))
          .exit_code,
      0);
  const Outcome outcome = shot(
      "run-to 39\npanel \"Compare metrics\"\nexport \"Compare metrics\" m.csv\n", "--method all");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const std::string table = test::readText(folder / "shots/m.csv");
  std::string expected = "\"ATE RMSE, m\"";
  for (const char* method : {"svo", "pl-svo", "it-svo"}) {
    const auto metrics =
        nlohmann::json::parse(test::readText(folder / "out" / method / "metrics.json"));
    char text[32];
    std::snprintf(text, sizeof text, ",%.4f", metrics["ate"]["rmse_m"].get<double>());
    expected += text;
  }
  EXPECT_NE(table.find(expected), std::string::npos) << expected << "\n" << table;
}

TEST_F(CompareCommand, ATrajectoryIsOneMoreRun) {
  ASSERT_EQ(runProgram("run synthetic:room --sync --max-frames 40 --out " + path("out")).exit_code,
            0);
  const Outcome outcome = shot(
      "run-to 39\nexpect runs has svo\nexpect runs has earlier\nexpect frame@earlier == 39\n"
      "expect start_frame@earlier == 5\nlayout Compare\nshot compare.png\n",
      "--method svo --trajectory " + path("out/trajectory.txt") + "=earlier");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_TRUE(fs::exists(folder / "shots/compare.png"));
}

TEST_F(CompareCommand, ARecordingIsOneMoreRun) {
  ASSERT_EQ(runProgram("run synthetic:room --method it-svo --sync --max-frames 25 --record --out " +
                       path("out"))
                .exit_code,
            0);
  const std::string recording = path("out/run.svoscope");
  Outcome outcome = shot(
      "run-to 20\nexpect frame@before == 20\nexpect inliers@before > 50\nrun before\nexpect method "
      "== it-svo\n"
      "expect inliers > 50\nback 5\nexpect frame@svo == 15\nselect seed any\nlayout Compare\nshot "
      "a.png\n"
      "goto live\nrun-to 39\nexpect frame@svo == 39\nexpect tracked@before == 20\n",
      "--method svo --with " + recording + "=before");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  // A recording may also be what is opened first.
  test::writeText(
      folder / "b.script",
      "run-to 24\nexpect runs has it-svo\nexpect runs has again\nexpect ate@again == 0\n");
  outcome = runProgram("shot " + recording + " --with " + recording + "=again --trajectory " +
                       path("out/trajectory.txt") + " --size 640x400 --script " + path("b.script") +
                       " --out " + path("shots"));
  EXPECT_EQ(outcome.exit_code, 1) << outcome.err;
  EXPECT_NE(outcome.err.find("expected ate@again == 0, but it is 0.00"), std::string::npos)
      << outcome.err;
  outcome = shot("step\n", "--with " + path("out/metrics.json"));
  EXPECT_EQ(outcome.exit_code, 3);
  EXPECT_NE(outcome.err.find("is not a recording"), std::string::npos) << outcome.err;
  outcome = runProgram("shot synthetic:desk --script " + path("b.script") + " --out " +
                       path("shots") + " --with " + recording);
  EXPECT_EQ(outcome.exit_code, 3);
  EXPECT_NE(outcome.err.find("not of synthetic:desk"), std::string::npos) << outcome.err;
}

TEST_F(CompareCommand, WhatCannotBeOpenedIsSaid) {
  Outcome outcome = shot("step\n", "--trajectory " + path("absent.txt"));
  EXPECT_EQ(outcome.exit_code, 3);
  EXPECT_NE(outcome.err.find("absent.txt"), std::string::npos) << outcome.err;
  test::writeText(folder / "other.txt", "5000.0 0 0 0 0 0 0 1\n5000.1 1 0 0 0 0 0 1\n");
  outcome = shot("step\n", "--trajectory " + path("other.txt"));
  EXPECT_EQ(outcome.exit_code, 3);
  EXPECT_NE(outcome.err.find("no pose belongs to a frame"), std::string::npos) << outcome.err;
  EXPECT_EQ(shot("step\n", "--method dso").exit_code, 2);
}

TEST_F(CompareCommand, AWindowOfThreadedRunsClosesInTheMiddle) {
  if (std::system("command -v xvfb-run >/dev/null 2>&1") != 0)
    GTEST_SKIP() << "xvfb-run is absent: install xvfb";
  const Outcome outcome =
      runProgram("view synthetic:room --method all --close-after 12 --out " + path("w"),
                 "timeout 170 xvfb-run -a -s '-screen 0 1280x800x24'");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
}

}  // namespace
}  // namespace svoscope
