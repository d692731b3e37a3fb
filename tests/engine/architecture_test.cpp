// SPDX-License-Identifier: MIT
// Who may include whom: the engine knows nothing of the display, folders look downwards only, the
// user interface sees the engine's results and not its stages.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <string>
#include <vector>

namespace svoscope {
namespace {

namespace fs = std::filesystem;

struct Include {
  std::string file;      ///< relative to the project
  std::string included;  ///< as written
};

std::vector<Include> includesOf(const std::string& folder) {
  const fs::path root(SVOSCOPE_SOURCE_DIR);
  const std::regex line(R"(\s*#\s*include\s*["<]([^">]+)[">].*)");
  std::vector<Include> found;
  for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
    const auto extension = entry.path().extension();
    if (extension != ".h" && extension != ".cpp") continue;
    std::ifstream in(entry.path());
    std::string text;
    std::smatch match;
    while (std::getline(in, text))
      if (std::regex_match(text, match, line))
        found.push_back({fs::relative(entry.path(), root).generic_string(), match[1]});
  }
  return found;
}

/// "engine/match/patch.h" -> "match"; empty if the path lies elsewhere.
std::string engineFolder(const std::string& path) {
  std::smatch match;
  static const std::regex folder(R"(engine/([a-z_]+)/.*)");
  return std::regex_match(path, match, folder) ? match[1].str() : "";
}

TEST(Architecture, TheEngineKnowsNoDisplay) {
  const std::regex display(
      R"(^(ui/|app/|.*imgui|GL/|GLES|KHR/|EGL/|GLFW/|glad|epoxy|osmesa|X11/).*)",
      std::regex::icase);
  const auto includes = includesOf("engine");
  EXPECT_GT(includes.size(), 300u);
  for (const Include& i : includes)
    EXPECT_FALSE(std::regex_match(i.included, display)) << i.file << ": " << i.included;
}

TEST(Architecture, TheUserInterfaceSeesResultsOnly) {
  const std::set<std::string> allowed = {"base",   "geometry", "snapshot", "figure",
                                         "runner", "eval",     "study",    "io"};
  for (const Include& i : includesOf("ui")) {
    EXPECT_NE(i.included.rfind("app/", 0), 0u) << i.file << ": " << i.included;
    const std::string folder = engineFolder(i.included);
    if (!folder.empty()) {
      EXPECT_TRUE(allowed.count(folder)) << i.file << ": " << i.included;
    }
  }
}

TEST(Architecture, EngineFoldersLookDownwardsOnly) {
  const std::vector<std::string> order = {"base",     "geometry", "snapshot",  "figure", "eval",
                                          "dataset",  "frame",    "detect",    "match",  "mapping",
                                          "tracking", "runner",   "recording", "study",  "io",
                                          "bench",    "report"};
  const auto rank = [&](const std::string& folder) {
    return std::find(order.begin(), order.end(), folder) - order.begin();
  };
  for (const Include& i : includesOf("engine")) {
    const std::string from = engineFolder(i.file), to = engineFolder(i.included);
    EXPECT_LT(rank(from), static_cast<std::ptrdiff_t>(order.size()))
        << i.file << ": folder without a place in the order";
    if (to.empty()) continue;
    EXPECT_LE(rank(to), rank(from)) << i.file << ": " << i.included;
  }
}

}  // namespace
}  // namespace svoscope
