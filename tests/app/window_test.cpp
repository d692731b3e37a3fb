// SPDX-License-Identifier: MIT
// A real window on a virtual display, closed while the engine runs.
#include <gtest/gtest.h>

#include <chrono>

#include "tests/support/program.h"

namespace svoscope {
namespace {

bool hasXvfb() { return std::system("command -v xvfb-run >/dev/null 2>&1") == 0; }

TEST(Window, ClosesCleanlyWhileTheEngineRuns) {
  if (!hasXvfb()) GTEST_SKIP() << "xvfb-run is absent: install the package xvfb";
  const test::TemporaryFolder folder;
  const auto outcome = test::runProgram(
      "view synthetic:room --close-after 12 --out '" + folder.path().string() + "'",
      "timeout 170 xvfb-run -a -s '-screen 0 1280x800x24'");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
}

TEST(Window, WithoutADisplayTheWayOutIsNamed) {
  for (const std::string display : {"", "DISPLAY=:77"}) {
    const auto outcome =
        test::runProgram("view synthetic:room", "env -u DISPLAY -u WAYLAND_DISPLAY " + display);
    EXPECT_EQ(outcome.exit_code, 2) << outcome.err;
    EXPECT_NE(outcome.err.find("--headless"), std::string::npos) << outcome.err;
  }
}

}  // namespace
}  // namespace svoscope
