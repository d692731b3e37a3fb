// SPDX-License-Identifier: MIT
#include "engine/bench/bench_config.h"

#include <gtest/gtest.h>

#include <cstdlib>

#include "engine/bench/bench_plan.h"
#include "engine/bench/cell_record.h"
#include "tests/support/support.h"

namespace svoscope {
namespace {

Result<BenchConfig> load(const std::string& text, BenchConfigUse use = BenchConfigUse::run) {
  const test::TemporaryFolder folder;
  test::writeText(folder / "b.yaml", text);
  return loadBenchConfig(folder / "b.yaml", use);
}

void expectError(const std::string& text, const std::string& place, const std::string& what,
                 const std::string& remedy = "") {
  const auto config = load(text);
  ASSERT_FALSE(config.ok()) << text;
  EXPECT_EQ(config.error().kind, ErrorKind::input);
  const std::string message = config.error().message();
  EXPECT_NE(message.find("b.yaml" + place), std::string::npos) << message;
  EXPECT_NE(message.find(what), std::string::npos) << message;
  EXPECT_NE(message.find(remedy), std::string::npos) << message;
}

TEST(BenchConfig, DefaultsAndFullForm) {
  const auto small = load("sequences: [synthetic:room]\n");
  ASSERT_TRUE(small.ok()) << small.error().message();
  EXPECT_EQ(small.value().title, "b");
  EXPECT_EQ(small.value().methods.size(), 3u);
  EXPECT_EQ(small.value().runs, 4);
  EXPECT_EQ(cellsOf(small.value()).size(), 12u);
  EXPECT_EQ(small.value().sequences[0].name, "room");

  const auto full = load(
      "title: T\nsequences:\n  - {path: 'synthetic:room?frames=40', name: short, group: G, start: "
      "2, still: true}\n"
      "  - some/folder\nmethods: [svo, it-svo]\nvariants: {a: {}, b: {reproject.cell_px: 40}}\n"
      "parameters: {reproject: {cell_px: 20}}\nruns: 2\nmode: threaded\nmax_frames: 50\ntimeout_s: "
      "9\n"
      "least_tracked: 0.7\neval: {align: se3, align_first: 20, max_dt: 0.05, delta: 10f, "
      "all_pairs: true}\n"
      "peers: [{label: ORB, files: 'p/orb-{sequence}.txt'}]\n");
  ASSERT_TRUE(full.ok()) << full.error().message();
  const BenchConfig& c = full.value();
  EXPECT_EQ(c.sequences[0].name, "short");
  EXPECT_TRUE(c.sequences[0].still);
  EXPECT_EQ(c.sequences[1].name, "folder");
  EXPECT_EQ(c.sequences[1].max_frames, 50);
  EXPECT_EQ(c.evaluation.align_first, 20);
  EXPECT_EQ(c.evaluation.delta.text(), "10f");
  ASSERT_EQ(c.systems().size(), 4u);
  EXPECT_EQ(c.systems()[3].label, "it-svo b");
  EXPECT_EQ(cellsOf(c).size(), 16u);
  EXPECT_EQ(cellsOf(c)[3].folder, "cells/short/it-svo+b/run-1");
  const auto arguments = cellArguments(c, cellsOf(c)[3], "P");
  const std::vector<std::string> expected = {"run",          "P",
                                             "--method",     "it-svo",
                                             "--start",      "2",
                                             "--max-frames", "50",
                                             "--set",        "reproject.cell_px=20",
                                             "--set",        "reproject.cell_px=40"};
  EXPECT_EQ(arguments, expected);
}

TEST(BenchConfig, ErrorsNameLineAndWhatIsAllowed) {
  expectError("sequences: [synthetic:room]\nmethod: svo\n", ":2", "unknown key 'method'",
              "methods");
  expectError("sequences:\n  - {pth: synthetic:room}\n", ":2", "unknown key 'pth' of a sequence",
              "path, name");
  expectError("methods: [svo]\n", "", "'sequences' is missing");
  expectError("sequences: []\n", ":1", "'sequences' is missing or not a list");
  expectError("sequences:\n  - synthetic:room\n  - synthetic:nowhere\n", ":3",
              "unknown synthetic sequence 'nowhere'", "room");
  expectError("sequences: ['synthetic:room?speeed=2']\n", ":1", "unknown option 'speeed'");
  expectError("sequences: [synthetic:room]\nmethods: [svo, dso]\n", ":2", "unknown method 'dso'",
              "it-svo");
  expectError("sequences: [synthetic:room]\nmethods: [svo, svo]\n", ":2", "occurs twice");
  expectError("sequences: [synthetic:room, synthetic:room]\n", ":1", "sequence 'room' occurs twice",
              "name:");
  expectError("sequences: ['synthetic:room?frames=4']\n", ":1", "cannot be the name", "name:");
  expectError("sequences: [synthetic:room]\nruns: 0\n", ":2", "runs '0'");
  expectError("sequences: [synthetic:room]\nruns: 2.5\n", ":2", "whole number");
  expectError("sequences: [synthetic:room]\nmode: fast\n", ":2", "unknown mode 'fast'",
              "threaded, sync");
  expectError("sequences: [synthetic:room]\nvariants: {a: {reproject.cell: 3}}\n", ":2",
              "unknown parameter", "reproject.cell_px");
  expectError("sequences: [synthetic:room]\nparameters: {reproject.cell_px: many}\n", ":2",
              "'many'");
  expectError("sequences: [synthetic:room]\neval: {delta: 5}\n", ":2", "'5'");
  expectError("sequences: [synthetic:room]\npeers: [{label: A, files: a.txt}]\n", ":2",
              "{sequence}");
  expectError("sequences: [\n", "", "b.yaml");
}

TEST(BenchConfig, VariablesComeFromTheEnvironment) {
  unsetenv("SVOSCOPE_BENCH_TEST");
  const std::string text = "sequences:\n  - ${SVOSCOPE_BENCH_TEST}/one\n";
  expectError(text, ":2", "the environment variable SVOSCOPE_BENCH_TEST is not set");
  EXPECT_TRUE(load(text, BenchConfigUse::report).ok());  // only the name is needed
  setenv("SVOSCOPE_BENCH_TEST", "/data", 1);
  EXPECT_EQ(load(text).value().sequences[0].path, "/data/one");
  unsetenv("SVOSCOPE_BENCH_TEST");
}

TEST(BenchConfig, RelativePathsCountFromTheFile) {
  const test::TemporaryFolder folder;
  test::writeText(folder / "b.yaml", "sequences: [one]\n");
  EXPECT_EQ(loadBenchConfig(folder / "b.yaml").value().sequences[0].path,
            (folder / "one").string());
  EXPECT_FALSE(loadBenchConfig(folder / "absent.yaml").ok());
  EXPECT_FALSE(loadBenchConfig(folder.path()).ok());
}

TEST(BenchConfig, TheOnesThatComeWithTheProgramAreValid) {
  for (const char* name : {"synthetic.yaml", "data.yaml"}) {
    const auto config = loadBenchConfig(
        std::filesystem::path(SVOSCOPE_SOURCE_DIR) / "assets/bench" / name, BenchConfigUse::report);
    EXPECT_TRUE(config.ok()) << config.error().message();
  }
}

TEST(BenchPlan, TheFingerprintKnowsWhatChangesAResult) {
  const auto fingerprint = [](const std::string& text, const SequenceFacts& facts) {
    const BenchConfig config = load(text).value();
    return cellFingerprint(config, cellsOf(config)[0], facts);
  };
  SequenceFacts facts;
  facts.times = {0, 0.1};
  const std::string base = fingerprint("sequences: [a]\n", facts);
  EXPECT_EQ(base, fingerprint("title: x\nruns: 7\nsequences: [elsewhere/a]\n", facts));
  EXPECT_NE(base, fingerprint("sequences: [a]\nmethods: [pl-svo]\n", facts));
  EXPECT_NE(base, fingerprint("sequences: [a]\nmode: sync\n", facts));
  EXPECT_NE(base, fingerprint("sequences: [a]\nparameters: {reproject.cell_px: 21}\n", facts));
  facts.times.push_back(0.2);
  EXPECT_NE(base, fingerprint("sequences: [a]\n", facts));
}

TEST(BenchPlan, SynchronousRunsAreRunOnce) {
  EXPECT_EQ(cellsOf(load("sequences: [a]\nmode: sync\nruns: 5\n").value()).size(), 3u);
}

TEST(BenchPlan, CellRecordsAreReadBack) {
  const test::TemporaryFolder folder;
  EXPECT_FALSE(readCellRecord(folder.path()).has_value());
  CellRecord record;
  record.configuration = "abc";
  record.reason = "ended by \"signal\" 9 \xff";
  record.signal = 9;
  record.wall_s = 1.5;
  ASSERT_TRUE(writeCellRecord(folder.path(), record).ok());
  const auto read = readCellRecord(folder.path());
  ASSERT_TRUE(read.has_value());
  EXPECT_EQ(read->configuration, "abc");
  EXPECT_FALSE(read->finished());
  test::writeText(folder / "cell.json", "{\"configuration\": 3");
  EXPECT_FALSE(readCellRecord(folder.path()).has_value());
}

}  // namespace
}  // namespace svoscope
