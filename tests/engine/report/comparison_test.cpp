// SPDX-License-Identifier: MIT
#include "engine/report/comparison.h"

#include <gtest/gtest.h>

#include "engine/report/read_results.h"
#include "tests/support/made_bench.h"

namespace svoscope {
namespace {

std::string yaml(int sequences, int runs = 4) {
  std::string text = "methods: [pl-svo, it-svo]\nruns: " + std::to_string(runs) + "\nsequences:\n";
  for (int i = 0; i < sequences; ++i) text += "  - s" + std::to_string(i) + "\n";
  return text;
}

/// it-svo's error is `factor(sequence)` times that of pl-svo, both with a little spread.
template <typename Factor>
BenchResults made(const std::filesystem::path& dir, int sequences, const Factor& factor,
                  int runs = 4) {
  const BenchConfig config = test::makeBench(dir, yaml(sequences, runs));
  for (const BenchCell& cell : cellsOf(config)) {
    const double level = 0.01 * (1 + cell.sequence) * (1 + 0.01 * cell.run);
    test::makeCell(dir, cell, cell.system == 1 ? level * factor(cell.sequence) : level);
  }
  return readBenchResults(dir).value();
}

Comparison ate(const BenchResults& results) { return compare(results, 1, 0, figure("ate_m")); }

TEST(Comparison, ACleanAdvantageIsFoundWithItsSize) {
  const test::TemporaryFolder folder;
  const BenchResults results = made(folder.path(), 8, [](int) { return 0.8; });
  const Comparison c = ate(results);
  EXPECT_EQ(c.sequences.size(), 8u);
  EXPECT_NEAR(c.ratio, 0.8, 0.01);
  EXPECT_EQ(c.verdict, Verdict::better);
  EXPECT_EQ(c.sequences[0].verdict, Verdict::better);
  const auto sentences = comparisonSentences(results, c);
  EXPECT_NE(sentences[0].find("it-svo is better than pl-svo, 20 % lower"), std::string::npos)
      << sentences[0];
  EXPECT_NE(sentences[1].find("s0, s1"), std::string::npos) << sentences[1];
  EXPECT_EQ(compare(results, 0, 1, figure("ate_m")).verdict, Verdict::worse);
}

TEST(Comparison, OppositeAdvantagesAreUndecided) {
  const test::TemporaryFolder folder;
  const BenchResults results = made(folder.path(), 8, [](int s) { return s % 2 ? 0.7 : 1.4; });
  const Comparison c = ate(results);
  EXPECT_EQ(c.verdict, Verdict::undecided);
  EXPECT_LT(c.ratios.low, 1);
  EXPECT_GT(c.ratios.high, 1);
  EXPECT_EQ(c.sequences[0].verdict, Verdict::worse);
  EXPECT_EQ(c.sequences[1].verdict, Verdict::better);
}

TEST(Comparison, FewSequencesDecideNothing) {
  const test::TemporaryFolder folder;
  const BenchResults results = made(folder.path(), 5, [](int) { return 0.5; });
  EXPECT_EQ(ate(results).verdict, Verdict::undecided);
  EXPECT_NE(comparisonSentences(results, ate(results))[0].find("a verdict takes 6"),
            std::string::npos);
}

TEST(Comparison, SingleRunsDecideNothingOnASequence) {
  const test::TemporaryFolder folder;
  const Comparison c = ate(made(
      folder.path(), 6, [](int) { return 0.5; }, 1));
  EXPECT_EQ(c.sequences[0].verdict, Verdict::undecided);
  EXPECT_EQ(c.verdict, Verdict::better);
}

TEST(Comparison, WhoFailsWhereTheOtherDoesNotIsNotBetter) {
  const test::TemporaryFolder folder;
  made(folder.path(), 8, [](int) { return 0.5; });
  const BenchConfig config = loadBenchConfig(folder / "bench.yaml", BenchConfigUse::report).value();
  for (const BenchCell& cell : cellsOf(config)) {  // one run of it-svo, on one sequence
    if (cell.sequence == 2 && cell.system == 1 && cell.run == 1)
      test::makeCell(folder.path(), cell, 0.01, 0.85);
  }
  const BenchResults results = readBenchResults(folder.path()).value();
  EXPECT_NE(results.typical(2, 1), nullptr);
  EXPECT_FALSE(results.completes(2, 1));
  const Comparison c = ate(results);
  EXPECT_EQ(c.only_b, std::vector<std::size_t>{2});
  EXPECT_EQ(c.sequences.size(), 7u);
  EXPECT_LT(c.ratios.high, 1);
  EXPECT_EQ(c.verdict, Verdict::undecided);
}

TEST(Comparison, ADamagedMetricsFileIsSaidToBe) {
  const test::TemporaryFolder folder;
  made(folder.path(), 2, [](int) { return 0.9; });
  const BenchConfig config = loadBenchConfig(folder / "bench.yaml", BenchConfigUse::report).value();
  for (const BenchCell& cell : cellsOf(config)) {
    if (cell.sequence == 1)
      test::writeText(folder.path() / cell.folder / "metrics.json", "garbage");
  }
  EXPECT_EQ(readBenchResults(folder.path()).value().failure(1, 0),
            "metrics.json is missing or damaged");
}

TEST(Comparison, FailuresAreNamedNotAveraged) {
  const test::TemporaryFolder folder;
  made(folder.path(), 7, [](int) { return 0.9; });
  const BenchConfig config = loadBenchConfig(folder / "bench.yaml", BenchConfigUse::report).value();
  for (const BenchCell& cell : cellsOf(config)) {
    if (cell.sequence == 2 && cell.system == 0)
      test::makeFailedCell(folder.path(), cell, 5, "never initialised");
    if (cell.sequence == 3) test::makeCell(folder.path(), cell, 0.01, 0.2);
  }
  const BenchResults results = readBenchResults(folder.path()).value();
  const Comparison c = ate(results);
  EXPECT_EQ(c.sequences.size(), 5u);
  EXPECT_EQ(c.only_a, std::vector<std::size_t>{2});
  EXPECT_EQ(c.neither, std::vector<std::size_t>{3});
  EXPECT_EQ(results.failure(2, 0), "never initialised");
  EXPECT_EQ(results.failure(3, 0), "only 20 % tracked");
  const auto sentences = comparisonSentences(results, c);
  EXPECT_NE(std::find(sentences.begin(), sentences.end(), "Only it-svo completes every run: s2."),
            sentences.end());
  EXPECT_NE(std::find(sentences.begin(), sentences.end(), "Neither completes every run: s3."),
            sentences.end());
}

}  // namespace
}  // namespace svoscope
