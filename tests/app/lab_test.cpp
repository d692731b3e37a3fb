// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "tests/support/program.h"

namespace svoscope::test {
namespace {

TEST(LabCommand, WritesTablesAndPicture) {
  const TemporaryFolder folder;
  const Outcome outcome = runProgram("lab --seeds 200 --updates 30 --outliers 0.3 --out '" +
                                     (folder / "lab").string() + "'");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("JS both"), std::string::npos);
  const std::string csv = readText(folder / "lab/lab.csv");
  EXPECT_NE(csv.find("\nKL,"), std::string::npos);
  for (const char* file : {"lab/curves.csv", "lab/lab.png"})
    EXPECT_TRUE(std::filesystem::exists(folder / file)) << file;
}

TEST(LabCommand, OutOfBoundsIsAUsageError) {
  const TemporaryFolder folder;
  EXPECT_EQ(runProgram("lab --outliers 2 --out '" + (folder / "lab").string() + "'").exit_code, 2);
  EXPECT_EQ(runProgram("lab").exit_code, 2);
}

TEST(DepthStudyCommand, WritesTablesAndPicture) {
  const TemporaryFolder folder;
  const Outcome outcome = runProgram(
      "run synthetic:room --sync --max-frames 40 --depth-study --poses groundtruth --out '" +
      (folder / "study").string() + "'");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  for (const char* file :
       {"study/depth_study.csv", "study/depth_study.json", "study/depth_study.png"})
    EXPECT_TRUE(std::filesystem::exists(folder / file)) << file;
}

}  // namespace
}  // namespace svoscope::test
