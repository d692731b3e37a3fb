// SPDX-License-Identifier: MIT
// Scripts from files and pipes, and folders that cannot be written: told before the work.
#include <gtest/gtest.h>

#include "tests/support/program.h"

namespace svoscope {
namespace {

using test::Outcome;

struct ShotTest : testing::Test {
  test::TemporaryFolder folder;
  std::string path(const std::string& name) const { return "'" + (folder / name).string() + "'"; }
};

TEST_F(ShotTest, AFolderAsScriptIsAnInputError) {
  const Outcome outcome = test::runProgram("shot synthetic:room --script / --out " + path("out"));
  EXPECT_EQ(outcome.exit_code, 3) << outcome.err;
  EXPECT_NE(outcome.err.find("folder"), std::string::npos) << outcome.err;
}

TEST_F(ShotTest, AScriptFromAPipeIsReadOnce) {
  const Outcome outcome = test::runProgram(
      "shot synthetic:room --script " + path("pipe") + " --out " + path("out"),
      "mkfifo " + path("pipe") + "; printf 'step\\nshot a\\n' > " + path("pipe") + " & timeout 60");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_TRUE(std::filesystem::exists(folder / "out/a.png"));
}

TEST_F(ShotTest, TheOutputFolderIsCheckedBeforeTheSequenceIsOpened) {
  test::writeText(folder / "a.script", "step\nshot a.png\n");
  test::writeText(folder / "file", "in the way");
  for (const std::string& command :
       {"shot absent --script " + path("a.script"), std::string("view absent --headless")}) {
    const Outcome outcome = test::runProgram(command + " --out " + path("file"));
    EXPECT_EQ(outcome.exit_code, 4) << outcome.err;
    EXPECT_NE(outcome.err.find("Not a directory"), std::string::npos) << outcome.err;
  }
}

TEST_F(ShotTest, TheTourOfARunThatNeverStartsHasAllItsPictures) {
  const Outcome outcome = test::runProgram(
      "view 'synthetic:still?size=320x240&frames=8' --headless --out " + path("out"));
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  for (const char* name : {"1-start.png", "2-tracking.png", "3-seeds.png", "4-evaluation.png"})
    EXPECT_TRUE(std::filesystem::exists(folder / "out" / name)) << name;
}

TEST_F(ShotTest, APictureThatCannotBeWrittenHasAReason) {
  test::writeText(folder / "a.script", "step\nshot file/a.png\n");
  std::filesystem::create_directories(folder / "out");
  test::writeText(folder / "out/file", "in the way");
  const Outcome outcome = test::runProgram("shot synthetic:room --script " + path("a.script") +
                                           " --out " + path("out"));
  EXPECT_EQ(outcome.exit_code, 4) << outcome.err;
  EXPECT_NE(outcome.err.find("Not a directory"), std::string::npos) << outcome.err;
  EXPECT_EQ(outcome.err.find("libpng"), std::string::npos) << outcome.err;
}

TEST_F(ShotTest, OtherPicturesThanPngAreRefusedBeforeTheWork) {
  test::writeText(folder / "a.script", "step\nshot a.jpg\n");
  const Outcome outcome =
      test::runProgram("shot absent --script " + path("a.script") + " --out " + path("out"));
  EXPECT_EQ(outcome.exit_code, 3) << outcome.err;
  EXPECT_NE(outcome.err.find("a.script:2"), std::string::npos) << outcome.err;
}

}  // namespace
}  // namespace svoscope
