// SPDX-License-Identifier: MIT
// svoscope run and synth on a built-in sequence: files, exit codes, determinism.
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "tests/support/program.h"

namespace svoscope {
namespace {

namespace fs = std::filesystem;
using test::Outcome;
using test::runProgram;

struct RunTest : testing::Test {
  test::TemporaryFolder folder;
  std::string path(const std::string& name) const { return (folder / name).string(); }
  Outcome run(const std::string& out, const std::string& options, const std::string& prefix = "") {
    return runProgram("run synthetic:room --out " + path(out) + " " + options, prefix);
  }
};

TEST_F(RunTest, WritesItsFilesAndASummary) {
  const Outcome outcome = run("out", "--sync --max-frames 40");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  for (const char* name : {"trajectory.txt", "keyframes.txt", "frames.csv", "map.ply",
                           "metrics.json", "config.yaml"}) {
    EXPECT_TRUE(fs::file_size(folder / "out" / name) > 0) << name;
  }
  const auto metrics = nlohmann::json::parse(test::readText(folder / "out" / "metrics.json"));
  EXPECT_EQ(metrics["frames"], 40);
  EXPECT_GT(metrics["tracked"].get<int>(), 10);
  EXPECT_TRUE(metrics["ate"]["rmse_m"].is_number());
  for (const char* text : {"tracked", "align sim3", "matched within 0.02 s", "median"}) {
    EXPECT_NE(outcome.out.find(text), std::string::npos) << outcome.out;
  }
}

TEST_F(RunTest, SynchronousRunsGiveTheSameBytes) {
  ASSERT_EQ(run("a", "--sync --max-frames 40").exit_code, 0);
  ASSERT_EQ(run("b", "--sync --max-frames 40").exit_code, 0);
  for (const char* name : {"trajectory.txt", "keyframes.txt", "map.ply", "config.yaml"}) {
    EXPECT_EQ(test::readText(folder / "a" / name), test::readText(folder / "b" / name)) << name;
  }
}

TEST_F(RunTest, WhereTheHeapPutsThingsDoesNotMatter) {
  // Longer paths shift every later allocation. Sums that begin at the first aligned address would
  // then end in other digits.
  const std::string common = "--sync --method it-svo --max-frames 40";
  ASSERT_EQ(run("a", common).exit_code, 0);
  for (const std::size_t length : {17, 35, 56, 90}) {
    const std::string name(length, 'b');
    ASSERT_EQ(run(name, common).exit_code, 0);
    EXPECT_EQ(test::readText(folder / "a" / "trajectory.txt"),
              test::readText(folder / name / "trajectory.txt"))
        << length;
  }
}

TEST_F(RunTest, TooFewFramesNeverInitialiseButFilesAreWritten) {
  const Outcome outcome = run("out", "--sync --max-frames 2");
  EXPECT_EQ(outcome.exit_code, 5) << outcome.err;
  const auto metrics = nlohmann::json::parse(test::readText(folder / "out" / "metrics.json"));
  EXPECT_TRUE(metrics["init_frame"].is_null());
  EXPECT_TRUE(metrics["ate"].is_null());
}

TEST_F(RunTest, AnInterruptWritesWhatIsDone) {
  // Ctrl-C once the first rows are on disk, however slow the machine.
  const std::string csv = path("out") + "/frames.csv";
  const Outcome outcome = run(
      "out", "& pid=$!; for i in $(seq 600); do test -s " + csv +
                 " && break; sleep 0.1; done; sleep 0.3; kill -INT $pid; wait $pid; exit $?; true");
  EXPECT_EQ(outcome.exit_code, 130) << outcome.err;
  EXPECT_TRUE(fs::exists(folder / "out" / "metrics.json"));
}

TEST_F(RunTest, ErrorsHaveTheirExitCodes) {
  test::writeText(folder / "file", "");
  test::writeText(folder / "bad.yaml", "no: {such: 1}\n");
  EXPECT_EQ(runProgram("run " + path("absent") + " --out " + path("o")).exit_code, 3);
  EXPECT_EQ(run("o", "--config " + path("bad.yaml")).exit_code, 3);
  EXPECT_EQ(run("o", "--config " + path("absent.yaml")).exit_code, 3);
  EXPECT_EQ(run("o", "--set no.such=1").exit_code, 2);
  EXPECT_EQ(run("o", "--set nonsense").exit_code, 2);
  EXPECT_EQ(run("o", "--start 100000000").exit_code, 2);
  EXPECT_EQ(run("file/below", "").exit_code, 4);
  EXPECT_FALSE(fs::exists(folder / "o"));  // nothing is made for a run that cannot start
}

TEST_F(RunTest, SynthReportsUnknownPresetsAndUnwritableFolders) {
  test::writeText(folder / "file", "");
  const Outcome unknown = runProgram("synth nope --out " + path("o"));
  EXPECT_NE(unknown.exit_code, 0);
  EXPECT_NE(unknown.err.find("room"), std::string::npos) << unknown.err;
  EXPECT_EQ(runProgram("synth room --out " + path("file") + "/x").exit_code, 4);
}

}  // namespace
}  // namespace svoscope
