// SPDX-License-Identifier: MIT
// svoscope eval and convert: options, figures, what is refused.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/support/program.h"

namespace svoscope {
namespace {

using test::Outcome;
using test::runProgram;

/// A helix; from row `bent` on the estimate drifts away.
std::string helix(double scale, double shift_s = 0, int bent = 1000) {
  std::ostringstream text;
  for (int i = 0; i < 60; ++i) {
    const double a = 0.1 * i, drift = i < bent ? 0 : 0.05 * (i - bent);
    text << 10 + shift_s + 0.1 * i << ' ' << scale * std::cos(a) + drift << ' '
         << scale * std::sin(a) << ' ' << scale * 0.1 * a << " 0 0 0 1\n";
  }
  return text.str();
}

struct EvalTest : testing::Test {
  test::TemporaryFolder folder;
  void SetUp() override { test::writeText(folder / "gt.txt", helix(1)); }
  std::string path(const std::string& name) const { return (folder / name).string(); }
  Outcome eval(const std::string& estimate, const std::string& options = "") {
    return runProgram("eval " + path("gt.txt") + " " + path(estimate) + " " + options);
  }
  void expectRefused(const std::string& text, const std::string& place, const std::string& what) {
    test::writeText(folder / "bad.txt", text);
    const Outcome outcome = eval("bad.txt");
    EXPECT_EQ(outcome.exit_code, 3) << text;
    EXPECT_NE(outcome.err.find("bad.txt" + place), std::string::npos) << outcome.err;
    EXPECT_NE(outcome.err.find(what), std::string::npos) << outcome.err;
  }
};

TEST_F(EvalTest, AligningOnTheFirstPosesShowsTheDriftOfTheRest) {
  test::writeText(folder / "est.txt", helix(0.5, 0, 30));
  const auto all = nlohmann::json::parse(eval("est.txt", "--json").out);
  const auto first = nlohmann::json::parse(eval("est.txt", "--align-first 30 --json").out);
  EXPECT_EQ(all["aligned_on"], 60);
  EXPECT_EQ(first["aligned_on"], 30);
  EXPECT_NEAR(first["ate"]["scale"].get<double>(), 2, 1e-4);
  EXPECT_GT(first["ate"]["max_m"].get<double>(), 2.5);
  EXPECT_LT(all["ate"]["rmse_m"].get<double>(), first["ate"]["rmse_m"].get<double>());
  EXPECT_NE(eval("est.txt", "--align-first 30").out.find("on up to the first 30 matches"),
            std::string::npos);
}

TEST_F(EvalTest, AnOffsetBetweenClocksIsTakenAway) {
  test::writeText(folder / "est.txt", helix(1, 100));
  const Outcome apart = eval("est.txt");
  EXPECT_EQ(apart.exit_code, 3);
  EXPECT_NE(apart.err.find("the timestamps do not overlap"), std::string::npos) << apart.err;
  EXPECT_NE(apart.err.find("--offset"), std::string::npos) << apart.err;
  const Outcome together = eval("est.txt", "--offset -100 --json");
  ASSERT_EQ(together.exit_code, 0) << together.err;
  const auto json = nlohmann::json::parse(together.out);
  EXPECT_EQ(json["ate"]["matched"], 60);
  EXPECT_EQ(json["association"]["offset_s"], -100);
  EXPECT_LT(json["ate"]["rmse_m"].get<double>(), 1e-6);
}

TEST_F(EvalTest, EstimatesThatCannotBeTrustedAreRefused) {
  const std::string good = "10 0 0 0 0 0 0 1\n10.1 1 0 0 0 0 0 1\n10.2 0 1 0 0 0 0 1\n";
  expectRefused(good + "10.3 nan 0 0 0 0 0 1\n", ":4", "'nan' is not a finite number");
  expectRefused(good + "10.1 0 0 0 0 0 0 1\n", ":4",
                "earlier than the one above (sort the rows by time)");
  expectRefused(good + "10.2 0 0 0 0 0 0 1\n", ":4", "the timestamp is that of the row above");
  expectRefused("500 0 0 0 0 0 0 1\n501 1 0 0 0 0 0 1\n", ", association", "do not overlap");
  expectRefused("10.05 0 0 0 0 0 0 1\n10.15 1 0 0 0 0 0 1\n", ", association",
                "no timestamps match within 0.02 s");
}

TEST_F(EvalTest, PlotsShowEveryEstimate) {
  test::writeText(folder / "one.txt", helix(0.5));
  test::writeText(folder / "two.txt", helix(2, 0, 40));
  const Outcome outcome = runProgram("eval " + path("gt.txt") + " " + path("one.txt") + " " +
                                     path("two.txt") + " --plots " + path("plots"));
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  for (const char* name : {"trajectories.svg", "error.svg"}) {
    const std::string svg = test::readText(folder / "plots" / name);
    EXPECT_EQ(svg.rfind("<svg xmlns=", 0), 0u) << name;
    EXPECT_NE(svg.find("two.txt"), std::string::npos) << name;
    if (std::system("command -v python3 >/dev/null 2>&1") == 0) {
      const std::string parse =
          "python3 -c \"import sys, xml.etree.ElementTree as t; t.parse(sys.argv[1])\" '";
      EXPECT_EQ(std::system((parse + path(std::string("plots/") + name) + "'").c_str()), 0) << name;
    }
  }
  const std::string csv = test::readText(folder / "plots/errors.csv");
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 1 + 120);
  EXPECT_EQ(eval("one.txt", "--plots " + path("gt.txt")).exit_code, 4);
}

TEST_F(EvalTest, WrongOptionsAreUsageErrors) {
  for (const char* options : {"--align-first 2", "--align-first 10 --align none", "--offset x"})
    EXPECT_EQ(eval("gt.txt", options).exit_code, 2) << options;
}

TEST_F(EvalTest, ConvertGoesThereAndBack) {
  const auto convert = [&](const std::string& arguments) {
    return runProgram("convert " + arguments);
  };
  ASSERT_EQ(convert(path("gt.txt") + " --to euroc --out " + path("a.csv")).exit_code, 0);
  ASSERT_EQ(convert(path("a.csv") + " --to tum --out " + path("b.txt")).exit_code, 0);
  ASSERT_EQ(convert(path("b.txt") + " --to kitti --out " + path("c.txt")).exit_code, 0);
  std::string times;
  for (int i = 0; i < 60; ++i) times += std::to_string(10 + 0.1 * i) + "\n";
  test::writeText(folder / "times.txt", times);
  const Outcome last =
      convert(path("c.txt") + " --times " + path("times.txt") + " --to tum --out " + path("d.txt"));
  ASSERT_EQ(last.exit_code, 0) << last.err;
  EXPECT_NE(last.out.find("60 poses"), std::string::npos);
  EXPECT_LT(
      nlohmann::json::parse(eval("d.txt", "--align none --json").out)["ate"]["max_m"].get<double>(),
      1e-5);
}

TEST_F(EvalTest, ConvertRefusesWhatItCannotDo) {
  test::writeText(folder / "k.txt", "1 0 0 0 0 1 0 0 0 0 1 0\n");
  test::writeText(folder / "t.txt", "1\n2\n");
  const auto code = [&](const std::string& arguments) {
    return runProgram("convert " + arguments).exit_code;
  };
  EXPECT_EQ(code(path("k.txt") + " --to tum --out " + path("o")), 3);
  EXPECT_EQ(code(path("k.txt") + " --times " + path("t.txt") + " --to tum --out " + path("o")), 3);
  EXPECT_EQ(code(path("gt.txt") + " --times " + path("t.txt") + " --to tum --out " + path("o")), 2);
  EXPECT_EQ(code(path("gt.txt") + " --to bvh --out " + path("o")), 2);
  EXPECT_EQ(code(path("gt.txt") + " --to tum --out " + path("gt.txt") + "/x"), 4);
}

}  // namespace
}  // namespace svoscope
