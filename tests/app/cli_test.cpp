// SPDX-License-Identifier: MIT
// The program as users and their scripts see it: exit codes, messages, output.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/support/program.h"

namespace svoscope {
namespace {

using test::Outcome;

Outcome run(const std::string& arguments) { return test::runProgram(arguments); }

std::string spiralTum(double scale, int count = 60) {
  std::ostringstream text;
  for (int i = 0; i < count; ++i) {
    const double a = 0.1 * i;
    text << 10 + 0.1 * i << ' ' << scale * std::cos(a) << ' ' << scale * std::sin(a) << ' '
         << scale * 0.1 * a << " 0 0 0 1\n";
  }
  return text.str();
}

struct CliTest : testing::Test {
  test::TemporaryFolder folder;
  std::string path(const std::string& name) const { return (folder / name).string(); }
};

TEST_F(CliTest, HelpAndVersion) {
  EXPECT_EQ(run("--version").out, "svoscope 0.1.0\n");
  const Outcome help = run("--help");
  EXPECT_EQ(help.exit_code, 0);
  for (const char* command :
       {"view", "run", "shot", "eval", "convert", "bench", "synth", "stress"}) {
    EXPECT_NE(help.out.find(std::string("\n  ") + command), std::string::npos) << command;
    const Outcome own = run(std::string(command) + " --help");
    EXPECT_EQ(own.exit_code, 0) << command;
    EXPECT_NE(own.out.find("Example"), std::string::npos) << command;
    EXPECT_TRUE(own.err.empty());
  }
  EXPECT_NE(help.out.find("Exit codes"), std::string::npos);
}

TEST_F(CliTest, WrongUseExitsWithTwoAndSaysWhatHelps) {
  for (const char* arguments : {"",
                                "--bogus",
                                "evl",
                                "run",
                                "run x",
                                "run x --out",
                                "run x --out y --method dso",
                                "run x --out y --max-frames 0",
                                "run x --out y --start -1",
                                "eval",
                                "eval one",
                                "eval a b --align affine",
                                "eval a b --delta 5",
                                "eval a b --delta nope",
                                "eval a b --max-dt x",
                                "eval a b --max-dt -1",
                                "synth",
                                "synth room",
                                "shot a --script b",
                                "shot a --script b --out c --size 12"}) {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.exit_code, 2) << arguments << "\n" << outcome.err;
    EXPECT_NE(outcome.err.find("svoscope: error: "), std::string::npos) << arguments;
    EXPECT_TRUE(outcome.out.empty()) << arguments;
  }
  EXPECT_NE(run("run x").err.find("see svoscope run --help"), std::string::npos);
}

TEST_F(CliTest, EvalPrintsModeScaleMatchesAndLimit) {
  test::writeText(folder / "gt.txt", spiralTum(1));
  test::writeText(folder / "est.txt", spiralTum(0.5));
  const Outcome outcome = run("eval " + path("gt.txt") + " " + path("est.txt"));
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  for (const char* text : {"sim3", "2.0000", "60/60", "within 0.02 s", "RPE rmse over 1s"}) {
    EXPECT_NE(outcome.out.find(text), std::string::npos) << text << "\n" << outcome.out;
  }
}

TEST_F(CliTest, EvalPrintsOneJsonObjectPerEstimate) {
  test::writeText(folder / "gt.txt", spiralTum(1));
  test::writeText(folder / "est.txt", spiralTum(0.5));
  const Outcome outcome = run("eval " + path("gt.txt") + " " + path("est.txt") + " " +
                              path("gt.txt") + " --align none --delta 5f --all-pairs --json");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  std::istringstream lines(outcome.out);
  std::string first, second, rest;
  std::getline(lines, first);
  std::getline(lines, second);
  EXPECT_FALSE(std::getline(lines, rest));
  const auto est = nlohmann::json::parse(first);
  EXPECT_EQ(est["ate"]["alignment"], "none");
  EXPECT_EQ(est["ate"]["matched"], 60);
  EXPECT_GT(est["ate"]["rmse_m"].get<double>(), 0.5);
  for (const char* key : {"mean_m", "median_m", "max_m", "scale"}) {
    EXPECT_TRUE(est["ate"].contains(key)) << key;
  }
  EXPECT_EQ(est["rpe"]["delta"], "5f");
  EXPECT_GT(est["rpe"]["trans_rmse_m"].get<double>(), 0);
  EXPECT_EQ(nlohmann::json::parse(second)["ate"]["rmse_m"], 0.0);
}

TEST_F(CliTest, EvalRpeIsNullWhenTheIntervalDoesNotOccur) {
  test::writeText(folder / "gt.txt", spiralTum(1));
  const Outcome outcome =
      run("eval " + path("gt.txt") + " " + path("gt.txt") + " --delta 500s --json");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_TRUE(nlohmann::json::parse(outcome.out)["rpe"].is_null());
}

TEST_F(CliTest, EvalInputErrorsExitWithThree) {
  test::writeText(folder / "gt.txt", spiralTum(1));
  test::writeText(folder / "nan.txt", "1 nan 0 0 0 0 0 1\n");
  test::writeText(folder / "kitti.txt", "1 0 0 0 0 1 0 0 0 0 1 0\n");
  test::writeText(folder / "still.txt",
                  "10 0 0 0 0 0 0 1\n10.1 0 0 0 0 0 0 1\n10.2 0 0 0 0 0 0 1\n");
  test::writeText(folder / "empty.txt", "");
  for (const char* name : {"absent.txt", "nan.txt", "kitti.txt", "still.txt", "empty.txt"}) {
    const Outcome outcome = run("eval " + path("gt.txt") + " " + path(name));
    EXPECT_EQ(outcome.exit_code, 3) << name;
    EXPECT_NE(outcome.err.find(name), std::string::npos) << outcome.err;
  }
  // The estimates that are good are still printed.
  const Outcome both = run("eval " + path("gt.txt") + " " + path("nan.txt") + " " + path("gt.txt"));
  EXPECT_EQ(both.exit_code, 3);
  EXPECT_NE(both.out.find("60/60"), std::string::npos);
  EXPECT_NE(both.err.find("nan.txt:1"), std::string::npos);
}

TEST_F(CliTest, KittiRowsWithSecondsAreAUsageError) {
  test::writeText(folder / "kitti.txt", "1 0 0 0 0 1 0 0 0 0 1 0\n");
  const Outcome outcome =
      run("eval " + path("kitti.txt") + " " + path("kitti.txt") + " --delta 1s --align none");
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_NE(outcome.err.find("frames (10f) or metres (10m)"), std::string::npos);
}

}  // namespace
}  // namespace svoscope
