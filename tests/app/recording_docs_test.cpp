// SPDX-License-Identifier: MIT
// The examples of docs/recording.md are run against a small recording; its tables are those of the
// file.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <regex>
#include <sstream>

#include "engine/base/rules.h"
#include "engine/recording/sqlite.h"
#include "tests/support/program.h"

namespace svoscope {
namespace {

using test::readText;
using test::writeText;

std::string documentation() {
  return readText(std::filesystem::path(SVOSCOPE_SOURCE_DIR) / "docs" / "recording.md");
}

/// Contents of the code blocks of a language.
std::vector<std::string> blocks(const std::string& language) {
  std::vector<std::string> found;
  std::istringstream in(documentation());
  bool inside = false;
  for (std::string line; std::getline(in, line);) {
    if (line == "```" + language) {
      inside = true;
      found.emplace_back();
    } else if (line == "```") {
      inside = false;
    } else if (inside) {
      found.back() += line + "\n";
    }
  }
  return found;
}

struct Shell {
  int exit_code = -1;
  std::string out;
};

/// Runs a command in the folder; errors are part of its output.
Shell shell(const std::filesystem::path& folder, const std::string& command) {
  Shell result;
  FILE* pipe = popen(("cd '" + folder.string() + "' && ( " + command + " ) 2>&1").c_str(), "r");
  if (!pipe) return result;
  for (char c = 0; fread(&c, 1, 1, pipe) == 1;) result.out += c;
  const int status = pclose(pipe);
  result.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  return result;
}

/// One small recording for all examples.
const std::filesystem::path& folder() {
  static const test::TemporaryFolder temporary;
  static const std::filesystem::path path = temporary.path();
  static const int exit_code = test::runProgram(
                                   "run 'synthetic:room?size=320x240' --method it-svo --sync "
                                   "--record --max-frames 40 --out " +
                                   path.string())
                                   .exit_code;
  EXPECT_EQ(exit_code, 0);
  return path;
}

bool available(const std::string& command) { return shell("/", command).exit_code == 0; }

TEST(RecordingDocs, SqlExamplesGiveRows) {
  if (!available("sqlite3 --version"))
    GTEST_SKIP() << "sqlite3 is absent: install the package sqlite3";
  const auto examples = blocks("sql");
  EXPECT_GE(examples.size(), 6u);
  for (const std::string& example : examples) {
    writeText(folder() / "example.sql", example);
    const Shell done = shell(folder(), "sqlite3 -bail run.svoscope < example.sql");
    EXPECT_EQ(done.exit_code, 0) << example << done.out;
    EXPECT_FALSE(done.out.empty()) << "no row: " << example;
  }
}

TEST(RecordingDocs, CommandLinesWork) {
  if (!available("sqlite3 --version"))
    GTEST_SKIP() << "sqlite3 is absent: install the package sqlite3";
  const auto examples = blocks("sh");
  ASSERT_EQ(examples.size(), 1u);
  writeText(folder() / "example.sh", "set -e\n" + examples[0]);
  const Shell done = shell(folder(), "sh example.sh");
  EXPECT_EQ(done.exit_code, 0) << done.out;
  EXPECT_THAT(done.out, testing::HasSubstr("initialized"));
  EXPECT_GT(std::filesystem::file_size(folder() / "times.csv"), 500u);
  EXPECT_GT(std::filesystem::file_size(folder() / "frame20.jpg"), 2000u);
}

TEST(RecordingDocs, PandasExampleWorks) {
  std::string python;  // the first in the path may be another than Debian's
  for (const char* name : {"python3", "/usr/bin/python3"}) {
    if (python.empty() && available(std::string(name) + " -c 'import pandas'")) python = name;
  }
  if (python.empty()) GTEST_SKIP() << "pandas is absent: install the package python3-pandas";
  const auto examples = blocks("python");
  ASSERT_EQ(examples.size(), 1u);
  writeText(folder() / "example.py", examples[0]);
  const Shell done = shell(folder(), python + " example.py");
  EXPECT_EQ(done.exit_code, 0) << done.out;
  EXPECT_THAT(done.out, testing::HasSubstr("js_after_sigma"));
}

TEST(RecordingDocs, EveryTableAndColumnIsDescribed) {
  const std::string text = documentation() + readText(std::filesystem::path(SVOSCOPE_SOURCE_DIR) /
                                                      "docs" / "commands.md");
  std::string problem;
  const auto database = Database::open(folder() / "run.svoscope", Database::Mode::read, problem);
  ASSERT_NE(database, nullptr) << problem;
  Query columns(*database,
                "SELECT m.name, c.name FROM sqlite_master AS m JOIN pragma_table_info(m.name) AS c "
                "WHERE m.type = 'table'");
  std::string rules;
  for (const RuleInfo& rule : kRuleTable)
    rules += (rules.empty() ? "(" : "|") + std::string(rule.id);
  rules += ")";
  int checked = 0;
  while (columns.next()) {
    const std::string table = columns.text(), column = columns.text();
    EXPECT_NE(text.find("`" + table + "`"), std::string::npos) << table;
    // "kl_before_mu", `_sigma`, ... and `original_width` ... are described by their pattern.
    if (std::regex_match(column, std::regex(rules + "_(before|after)_.*|original_.*"))) continue;
    EXPECT_TRUE(std::regex_search(text, std::regex("[` ]" + column + "[` ]")))
        << table << "." << column;
    ++checked;
  }
  EXPECT_GT(checked, 100);
}

}  // namespace
}  // namespace svoscope
