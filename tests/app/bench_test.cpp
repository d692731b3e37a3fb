// SPDX-License-Identifier: MIT
// svoscope bench as its users meet it: interruptions, shards, failures. Small rendered sequences in
// one thread, so that two benches of one configuration give the same figures.
#include <gtest/gtest.h>

#include <filesystem>
#include <sstream>

#include "tests/support/program.h"

namespace svoscope {
namespace {

namespace fs = std::filesystem;
using test::Outcome;

const char* const kConfig =
    "sequences:\n"
    "  - {path: 'synthetic:room?frames=30&size=320x240', name: room}\n"
    "  - {path: 'synthetic:desk?frames=30&size=320x240', name: desk}\n"
    "  - {path: 'synthetic:still?frames=20&size=320x240', name: still, still: true}\n"
    "methods: [svo, it-svo]\nmode: sync\n";

/// results.csv without what a clock decides.
std::string figures(const fs::path& dir) {
  std::istringstream rows(test::readText(dir / "results.csv"));
  std::string row, header, text;
  std::vector<bool> timed;
  while (std::getline(rows, row)) {
    std::istringstream fields(row + ",");
    std::string field;
    for (std::size_t i = 0; std::getline(fields, field, ','); ++i) {
      if (header.empty())
        timed.push_back(field == "wall_s" || field == "fps" || field == "memory_mb" ||
                        field.find("_ms") != std::string::npos);
      if (i < timed.size() && !timed[i]) text += field + ",";
    }
    header = "read";
    text += "\n";
  }
  return text;
}

struct BenchTest : testing::Test {
  test::TemporaryFolder folder;
  void SetUp() override { test::writeText(folder / "bench.yaml", kConfig); }
  std::string path(const std::string& name) const { return (folder / name).string(); }
  Outcome bench(const std::string& out, const std::string& options = "",
                const std::string& prefix = "") {
    return test::runProgram("bench " + path("bench.yaml") + " --out " + path(out) + " " + options,
                            prefix);
  }
  int cells(const std::string& out) const {
    int count = 0;
    std::error_code ec;
    for (fs::recursive_directory_iterator it(folder / out / "cells", ec), end; !ec && it != end;
         it.increment(ec))
      count +=
          it->path().filename() == "cell.json" && it->path().parent_path().filename() == "run-1";
    return count;
  }
  /// Starts a bench, sends `signal` once a run is finished, and waits for its end.
  Outcome interrupted(const std::string& out, const std::string& signal) {
    const std::string wait =
        "for i in $(seq 1200); do ls " + path(out) +
        "/cells/*/*/run-1/cell.json >/dev/null 2>&1 && break; sleep 0.05; done";
    // The redirection of runProgram goes to the last command of the line, not to the bench.
    Outcome outcome = bench(out, "2>" + path("err") + " & pid=$!; " + wait + "; kill -" + signal +
                                     " $pid; wait $pid; exit $?; true");
    outcome.err = test::readText(folder / "err");
    return outcome;
  }
};

TEST_F(BenchTest, RunsReportsAndKeepsWhatIsFinished) {
  const Outcome first = bench("a");
  ASSERT_EQ(first.exit_code, 0) << first.err;
  EXPECT_NE(first.err.find("6 cells, 0 finished before, 6 to run"), std::string::npos) << first.err;
  EXPECT_NE(first.err.find("[6/6]"), std::string::npos);
  EXPECT_NE(first.err.find("still svo run 1: never initialised"), std::string::npos) << first.err;
  for (const char* name : {"report.html", "report.md", "results.csv", "tables.tex", "bench.yaml"})
    EXPECT_TRUE(fs::exists(folder / "a" / name)) << name;
  for (const char* name : {"trajectory.txt", "metrics.json", "cell.json", "log.txt"})
    EXPECT_TRUE(fs::exists(folder / "a/cells/room/it-svo/run-1" / name)) << name;
  const std::string before = test::readText(folder / "a/results.csv");
  const Outcome second = bench("a");
  EXPECT_NE(second.err.find("6 finished before, 0 to run"), std::string::npos) << second.err;
  EXPECT_EQ(test::readText(folder / "a/results.csv"), before);
}

TEST_F(BenchTest, KilledAndResumedItGivesTheSameTable) {
  ASSERT_EQ(bench("whole").exit_code, 0);
  interrupted("killed", "KILL");
  const int kept = cells("killed");
  EXPECT_GE(kept, 1);
  EXPECT_LT(kept, 6);
  const Outcome resumed = bench("killed");
  ASSERT_EQ(resumed.exit_code, 0) << resumed.err;
  EXPECT_EQ(resumed.err.find(" 0 finished before"), std::string::npos) << resumed.err;
  EXPECT_EQ(figures(folder / "killed"), figures(folder / "whole"));
  for (const auto& entry : fs::recursive_directory_iterator(folder / "killed"))
    EXPECT_NE(entry.path().extension(), ".tmp") << entry.path();
}

TEST_F(BenchTest, CtrlCKeepsWhatIsDone) {
  const Outcome outcome = interrupted("c", "INT");
  EXPECT_EQ(outcome.exit_code, 130) << outcome.err;
  EXPECT_NE(outcome.err.find("interrupted"), std::string::npos);
  EXPECT_GE(cells("c"), 1);
  for (const auto& entry : fs::recursive_directory_iterator(folder / "c"))
    EXPECT_NE(entry.path().extension(), ".tmp") << entry.path();
}

TEST_F(BenchTest, AKilledRunCostsOnlyItself) {
  if (!fs::exists("/proc/self/task")) GTEST_SKIP() << "no /proc";
  // The children of the bench once the first run writes: that run.
  const std::string kill =
      "for i in $(seq 1200); do ls " + path("k") +
      "/cells/*/*/.run-1*/frames.csv >/dev/null 2>&1 && break; sleep 0.02; done; "
      "kill -KILL $(cat /proc/$pid/task/$pid/children)";
  bench("k", "2>" + path("err") + " & pid=$!; " + kill + "; wait $pid; exit $?; true");
  EXPECT_NE(test::readText(folder / "err").find("ended by signal 9"), std::string::npos)
      << test::readText(folder / "err");
  EXPECT_NE(test::readText(folder / "k/results.csv").find("ended by signal 9"), std::string::npos);
  const Outcome again = bench("k");
  EXPECT_NE(again.err.find("6 cells, 5 finished before, 1 to run"), std::string::npos) << again.err;
  EXPECT_EQ(test::readText(folder / "k/results.csv").find("ended by signal 9"), std::string::npos);
}

TEST_F(BenchTest, ShardsTogetherAreTheWhole) {
  ASSERT_EQ(bench("whole").exit_code, 0);
  ASSERT_EQ(bench("one", "--shard 1/2").exit_code, 0);
  ASSERT_EQ(bench("two", "--shard 2/2 --jobs 2").exit_code, 0);
  EXPECT_FALSE(fs::exists(folder / "one/report.html"));
  EXPECT_EQ(cells("one") + cells("two"), 6);
  const Outcome merged = test::runProgram("bench --merge " + path("one") + " " + path("two") +
                                          " --out " + path("all"));
  ASSERT_EQ(merged.exit_code, 0) << merged.err;
  EXPECT_EQ(figures(folder / "all"), figures(folder / "whole"));
}

TEST_F(BenchTest, AChangedConfigurationRunsWhatItConcerns) {
  test::writeText(folder / "bench.yaml",
                  "sequences: [{path: 'synthetic:room?frames=20&size=320x240', name: "
                  "room}]\nmethods: [svo]\nmode: sync\n"
                  "variants: {a: {}, b: {reproject.cell_px: 30}}\n");
  ASSERT_EQ(bench("a").exit_code, 0);
  test::writeText(folder / "bench.yaml",
                  "sequences: [{path: 'synthetic:room?frames=20&size=320x240', name: "
                  "room}]\nmethods: [svo]\nmode: sync\n"
                  "variants: {a: {}, b: {reproject.cell_px: 35}}\n");
  const Outcome outcome = bench("a");
  EXPECT_NE(outcome.err.find("2 cells, 1 finished before, 1 to run"), std::string::npos)
      << outcome.err;
}

TEST_F(BenchTest, FailuresAreResultsWithAReason) {
  test::writeText(folder / "bench.yaml",
                  "peers: [{label: A, files: 'p/a-{sequence}.txt'}]\n"
                  "sequences: [{path: 'synthetic:room?frames=20&size=320x240', name: room}, gone]\n"
                  "methods: [svo]\nmode: sync\n");
  const Outcome outcome = bench("a");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.err.find("warning: gone: "), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.err.find("warning: peer A: no sequence has a file"), std::string::npos);
  EXPECT_NE(test::readText(folder / "a/results.csv")
                .find("gone,svo,svo,,1,1,0,the sequence cannot be opened,3,"),
            std::string::npos);
  EXPECT_NE(bench("a").err.find("2 finished before"), std::string::npos);
  EXPECT_NE(bench("a", "--retry-failed").err.find("1 finished before, 1 to run"),
            std::string::npos);
}

TEST_F(BenchTest, ErrorsHaveTheirExitCodes) {
  test::writeText(folder / "wrong.yaml", "sequences: [synthetic:room]\nmethod: svo\n");
  test::writeText(folder / "gone.yaml", "sequences: [gone]\n");
  test::writeText(folder / "file", "");
  const auto run = [&](const std::string& arguments) {
    return test::runProgram("bench " + arguments);
  };
  const Outcome wrong = run(path("wrong.yaml") + " --out " + path("o"));
  EXPECT_EQ(wrong.exit_code, 3);
  EXPECT_NE(wrong.err.find("wrong.yaml:2: unknown key 'method'"), std::string::npos) << wrong.err;
  EXPECT_EQ(run(path("gone.yaml") + " --out " + path("o")).exit_code, 3);
  EXPECT_EQ(run(path("absent.yaml") + " --out " + path("o")).exit_code, 3);
  EXPECT_EQ(run(path("bench.yaml") + " --out " + path("file")).exit_code, 4);
  EXPECT_EQ(run("--report --out " + path("absent")).exit_code, 3);
  for (const std::string& arguments :
       {std::string(), "--out " + path("o"), path("bench.yaml"),
        path("bench.yaml") + " --out o --shard 3/2", path("bench.yaml") + " --out o --shard x",
        path("bench.yaml") + " --out o --jobs 0", "--merge " + path("o")})
    EXPECT_EQ(run(arguments).exit_code, 2) << arguments;
}

TEST_F(BenchTest, ListPrintsTheRuns) {
  const Outcome outcome = test::runProgram("bench " + path("bench.yaml") + " --list");
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(std::count(outcome.out.begin(), outcome.out.end(), '\n'), 6);
  EXPECT_NE(outcome.out.find("desk it-svo run 1"), std::string::npos);
}

}  // namespace
}  // namespace svoscope
