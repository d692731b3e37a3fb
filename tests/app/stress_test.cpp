// SPDX-License-Identifier: MIT
// svoscope stress on a tiny grid.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/program.h"

namespace svoscope::test {
namespace {

TEST(StressCommand, WritesTheTables) {
  const TemporaryFolder folder;
  const std::string out = (folder / "out").string();
  const Outcome outcome = runProgram(
      "stress --stresses noise --methods svo,it-svo --frames 25 --width 160 --height 120 --out '" +
      out + "'");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("noise"), std::string::npos) << outcome.out;
  const std::string csv = readText(folder / "out/stress.csv");
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 1 + 5 * 2) << csv;
  EXPECT_NE(readText(folder / "out/stress.md").find("| strength | svo | it-svo |"),
            std::string::npos);
}

TEST(StressCommand, ListNamesTheSequences) {
  const Outcome outcome = runProgram("stress --list --frames 40");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("blackout=20:5"), std::string::npos) << outcome.out;
}

TEST(StressCommand, ErrorsHaveTheirExitCodes) {
  const TemporaryFolder folder;
  writeText(folder / "file", "");
  const Outcome unknown =
      runProgram("stress --stresses fog --out '" + (folder / "o").string() + "'");
  EXPECT_EQ(unknown.exit_code, 2);
  EXPECT_NE(unknown.err.find("blackout"), std::string::npos) << unknown.err;
  EXPECT_EQ(runProgram("stress").exit_code, 2);
  EXPECT_EQ(runProgram("stress --methods dso --out '" + (folder / "o").string() + "'").exit_code,
            2);
  EXPECT_EQ(runProgram("stress --set no.such=1 --out '" + (folder / "o").string() + "'").exit_code,
            2);
  EXPECT_EQ(runProgram("stress --out '" + (folder / "file/below").string() + "'").exit_code, 4);
  EXPECT_FALSE(std::filesystem::exists(folder / "o"));
}

}  // namespace
}  // namespace svoscope::test
