// SPDX-License-Identifier: MIT
// Helpers shared by the tests.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace svoscope::test {

/// Folder of the real sequences: environment variable SVOSCOPE_DATA, else ../shared/data beside
/// the sources. Empty if absent: the test should GTEST_SKIP() with a message.
std::optional<std::filesystem::path> dataFolder();

/// A fresh, empty folder that is removed at the end of the test's scope.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  const std::filesystem::path& path() const { return path_; }
  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }

 private:
  std::filesystem::path path_;
};

void writeText(const std::filesystem::path& file, const std::string& text);
std::string readText(const std::filesystem::path& file);

}  // namespace svoscope::test

#define SVOSCOPE_SKIP_WITHOUT_DATA(folder)            \
  const auto folder = ::svoscope::test::dataFolder(); \
  if (!folder) GTEST_SKIP() << "real sequences absent: set SVOSCOPE_DATA to their folder"
