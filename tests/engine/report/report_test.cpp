// SPDX-License-Identifier: MIT
#include "engine/report/report.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <sstream>

#include "engine/bench/bench_runner.h"
#include "engine/report/paper_figures.h"
#include "engine/report/read_results.h"
#include "engine/report/report_tables.h"
#include "tests/support/made_bench.h"

namespace svoscope {
namespace {

namespace fs = std::filesystem;

const char* const kYaml =
    "title: Trial <1> & more\nmethods: [svo, pl-svo, it-svo]\nruns: 2\n"
    "sequences:\n  - {path: a/freiburg1_xyz, group: TUM}\n  - {path: a/room, group: Built in}\n"
    "peers: [{label: ORB, files: 'p/{sequence}.txt'}]\n";

/// svo fails on the first sequence, one run of it-svo is missing on the second.
void makeTrial(const fs::path& dir) {
  const BenchConfig config = test::makeBench(dir, kYaml);
  for (const BenchCell& cell : cellsOf(config)) {
    if (cell.sequence == 0 && cell.system == 0) {
      test::makeFailedCell(dir, cell, 5, "never initialised");
    } else if (!(cell.sequence == 1 && cell.system == 2 && cell.run == 2)) {
      test::makeCell(dir, cell, 0.01 * (1 + cell.system) * cell.run);
    }
  }
  fs::create_directories(dir / "peers/ORB");
  (void)writeTumTrajectory(dir / "peers/ORB/room.txt", test::disturbedPath(0.005, 30)).ok();
}

int lines(const std::string& text) {
  return static_cast<int>(std::count(text.begin(), text.end(), '\n'));
}

struct ReportTest : testing::Test {
  test::TemporaryFolder folder;
  void SetUp() override {
    makeTrial(folder.path());
    const Status written = writeReport(folder.path());
    ASSERT_TRUE(written.ok()) << written.error().message();
  }
};

TEST_F(ReportTest, ErrorsAreComputedFromTheTrajectories) {
  const BenchResults results = readBenchResults(folder.path()).value();
  EXPECT_EQ(results.missing, 1);
  const auto ate = results.spread(1, 0, figure("ate_m"));
  ASSERT_TRUE(ate.has_value());
  EXPECT_EQ(ate->count, 2);
  EXPECT_NEAR(ate->low, 0.01, 5e-4);
  EXPECT_NEAR(ate->high, 0.02, 1e-3);
  EXPECT_NEAR(ate->stddev, 0.0071, 5e-4);
  EXPECT_FALSE(results.spread(0, 0, figure("ate_m")).has_value());
  EXPECT_EQ(results.typical(1, 0)->run, 1);
  EXPECT_EQ(results.typical(1, 0)->lost, std::vector<double>{0.4});
  EXPECT_NEAR(*results.runs[1][3][0].figures.tracked, 0.5, 1e-9);  // 30 of 60 frames
}

TEST_F(ReportTest, CsvHasOneRowPerCell) {
  const std::string csv = test::readText(folder / "results.csv");
  EXPECT_EQ(lines(csv), 1 + 12);
  EXPECT_NE(csv.find("freiburg1_xyz,svo,svo,,1,1,0,never initialised,5,"), std::string::npos);
  EXPECT_NE(csv.find("room,it-svo,it-svo,,2,0,0,not run,"), std::string::npos);
  EXPECT_EQ(lines(test::readText(folder / "peers.csv")), 1 + 2);
  std::istringstream rows(csv);
  std::string header, row;
  std::getline(rows, header);
  while (std::getline(rows, row)) {
    EXPECT_EQ(std::count(row.begin(), row.end(), ','),
              std::count(header.begin(), header.end(), ','))
        << row;
  }
}

TEST_F(ReportTest, MarkdownStatesFailuresSpreadAndThePaper) {
  const std::string md = test::readText(folder / "report.md");
  EXPECT_NE(md.find("1 of them not done"), std::string::npos);
  EXPECT_NE(md.find("Only it-svo completes every run: freiburg1_xyz."), std::string::npos) << md;
  EXPECT_NE(md.find("Completed in some runs only: it-svo 1 of 2 on room."), std::string::npos)
      << md;
  EXPECT_NE(md.find(" ± "), std::string::npos);
  EXPECT_NE(md.find("(1/2)"), std::string::npos);
  EXPECT_NE(md.find("| fr1\\_xyz | paper | - | - | - | 0.2249 | 0.0043 | 1.31 |"),
            std::string::npos);
  EXPECT_NE(md.find("| fr2\\_desk | paper |"), std::string::npos);
  EXPECT_NE(md.find("not run"), std::string::npos);
}

TEST_F(ReportTest, LatexIsEscapedAndBalanced) {
  const std::string tex = test::readText(folder / "tables.tex");
  EXPECT_NE(tex.find("freiburg1\\_xyz"), std::string::npos);
  EXPECT_NE(tex.find("$\\pm$"), std::string::npos);
  const auto count = [&](const std::string& what) {
    int n = 0;
    for (std::size_t at = 0; (at = tex.find(what, at)) != std::string::npos; at += what.size()) ++n;
    return n;
  };
  EXPECT_GT(count("\\begin{tabular}"), 14);
  EXPECT_EQ(count("\\begin{tabular}"), count("\\end{tabular}"));
  EXPECT_EQ(count("\\begin{table}"), count("\\end{table}"));
}

TEST_F(ReportTest, HtmlIsOneWellFormedPage) {
  const std::string html = test::readText(folder / "report.html");
  EXPECT_NE(html.find("Trial &lt;1&gt; &amp; more"), std::string::npos);
  for (const char* outside : {"http://", "https://", "src=", "<link", "<script", "url("})
    EXPECT_EQ(html.find(outside), std::string::npos) << outside;
  for (const char* color : {"#e69f00", "#cc79a7", "#56b4e9"})
    EXPECT_NE(html.find(color), std::string::npos) << color;
  if (std::system("command -v python3 >/dev/null 2>&1") != 0) GTEST_SKIP() << "python3 is absent";
  test::writeText(folder / "page.xml", html.substr(html.find('\n') + 1));
  const std::string parse =
      "python3 -c \"import sys, xml.etree.ElementTree as t; t.parse(sys.argv[1])\" '";
  EXPECT_EQ(std::system((parse + (folder / "page.xml").string() + "'").c_str()), 0);
}

TEST_F(ReportTest, AFolderWithoutABenchmarkIsAnError) {
  const Status status = writeReport(folder / "absent");
  ASSERT_FALSE(status.ok());
  EXPECT_EQ(status.error().kind, ErrorKind::input);
  EXPECT_NE(status.error().message().find("bench.yaml"), std::string::npos);
}

TEST(MergeBench, TakesCellsTogetherAndKeepsWhatIsThere) {
  const test::TemporaryFolder folder;
  const BenchConfig config = test::makeBench(folder / "one", kYaml);
  test::makeBench(folder / "two", kYaml);
  const auto cells = cellsOf(config);
  test::makeCell(folder / "one", cells[0], 0.01);
  test::makeCell(folder / "one", cells[1], 0.01);
  test::makeCell(folder / "two", cells[1], 0.5);
  test::makeCell(folder / "two", cells[2], 0.02);
  ASSERT_TRUE(mergeBench({folder / "one", folder / "two"}, folder / "all").ok());
  const BenchResults results = readBenchResults(folder / "all").value();
  EXPECT_EQ(results.missing, 9);
  EXPECT_NEAR(*results.runs[0][1][0].figures.ate_m, 0.01, 1e-3);
  EXPECT_NEAR(*results.runs[0][2][0].figures.ate_m, 0.02, 1e-3);
}

TEST(MergeBench, OtherConfigurationsAreRefused) {
  const test::TemporaryFolder folder;
  test::makeBench(folder / "one", kYaml);
  test::makeBench(folder / "two", "sequences: [other]\n");
  const Status merged = mergeBench({folder / "one", folder / "two"}, folder / "all");
  ASSERT_FALSE(merged.ok());
  EXPECT_NE(merged.error().message().find("another configuration"), std::string::npos);
  EXPECT_FALSE(mergeBench({folder / "absent"}, folder / "all").ok());
}

TEST(PaperFigures, SequencesAreRecognisedByName) {
  EXPECT_TRUE(samePaperSequence("fr1_xyz", "rgbd_dataset_freiburg1_xyz"));
  EXPECT_TRUE(samePaperSequence("fr2_desk", "freiburg2_desk"));
  EXPECT_TRUE(samePaperSequence("MH01", "MH_01_easy"));
  EXPECT_TRUE(samePaperSequence("V1_01_easy", "V1_01"));
  EXPECT_FALSE(samePaperSequence("V1_01_easy", "euroc_v101_still"));
  EXPECT_FALSE(samePaperSequence("fr1_desk", "freiburg1_desk2"));
}

TEST(PaperFigures, EveryTableHasItsRows) {
  int rows[8] = {};
  for (const PaperRow& row : paperRows()) ++rows[row.table];
  const int expected[8] = {0, 2, 2, 2, 2, 4, 8, 4};
  for (int t = 1; t < 8; ++t) EXPECT_EQ(rows[t], expected[t]) << t;
}

TEST(SpreadText, StatesWhatIsKnown) {
  EXPECT_EQ(spreadText(std::nullopt, 4, 3), "-");
  EXPECT_EQ(spreadText(spreadOf({1.5}), 2, 1), "1.50");
  EXPECT_EQ(spreadText(spreadOf({1, 3}), 2, 3), "2.00 ± 1.41 (2/3)");
  EXPECT_EQ(spreadText(spreadOf({0.001, 0.002}), 4, 2), "0.00150 ± 0.00071");
  EXPECT_EQ(spreadText(spreadOf({0, 0}), 1, 2), "0");
}

}  // namespace
}  // namespace svoscope
