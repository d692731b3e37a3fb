// SPDX-License-Identifier: MIT
// Files that are either complete or absent, and files that grow line by line.
#pragma once

#include <filesystem>
#include <fstream>
#include <string>

#include "engine/base/result.h"

namespace svoscope {

/// Writes `content` under a temporary name beside `file` and renames it, so that a reader never
/// sees half a file. Output error naming the file; nothing is left behind then.
Status writeWhole(const std::filesystem::path& file, const std::string& content);

/// Gives a file another name; one of that name is replaced. Output error naming both.
Status renameFile(const std::filesystem::path& from, const std::filesystem::path& to);

/// Makes `folder` with its parents. Output error if that fails or a file is in the way.
Status makeFolder(const std::filesystem::path& folder);

/// A text file that is flushed after every line: what was written survives the end of the program.
class LineFile {
 public:
  /// Creates or empties the file; another that was open is closed. Output error naming it.
  Status open(const std::filesystem::path& file);
  /// Appends `line` and a line end. Output error, for example when the disk is full; the file then
  /// ends with the line before.
  Status write(const std::string& line);

 private:
  std::filesystem::path file_;
  std::ofstream out_;
  std::uintmax_t size_ = 0;  ///< of the lines written
};

}  // namespace svoscope
