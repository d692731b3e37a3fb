// SPDX-License-Identifier: MIT
#include "engine/io/text_output.h"

#include <unistd.h>

#include <cerrno>
#include <cstring>

namespace svoscope {

namespace fs = std::filesystem;

namespace {

Error cannotWrite(const fs::path& file, int reason) {
  std::string what = "cannot be written";
  if (reason != 0) what += std::string(": ") + std::strerror(reason);
  return outputError(what, file.string(), "choose a folder with write permission and free space");
}

}  // namespace

Status writeWhole(const fs::path& file, const std::string& content) {
  fs::path temporary = file;
  temporary += "." + std::to_string(getpid()) + ".tmp";  // two programs may write the same file
  std::error_code ec;
  errno = 0;
  std::ofstream out(temporary, std::ios::binary | std::ios::trunc);
  out << content;
  out.close();
  if (!out) {
    const int reason = errno;
    fs::remove(temporary, ec);
    return cannotWrite(file, reason);
  }
  fs::rename(temporary, file, ec);
  if (ec) {
    const int reason = ec.value();
    fs::remove(temporary, ec);
    return cannotWrite(file, reason);
  }
  return Done{};
}

Status renameFile(const fs::path& from, const fs::path& to) {
  std::error_code ec;
  fs::rename(from, to, ec);
  if (!ec) return Done{};
  return outputError("cannot be renamed to " + to.filename().string() + ": " + ec.message(),
                     from.string(), "choose a folder with write permission and free space");
}

Status makeFolder(const fs::path& folder) {
  std::error_code ec;
  fs::create_directories(folder, ec);
  std::error_code ignored;
  if (fs::is_directory(folder, ignored)) return Done{};
  return outputError("cannot be made: " + (ec ? ec.message() : std::string("a file is in the way")),
                     folder.string(), "choose another output folder");
}

Status LineFile::open(const fs::path& file) {
  file_ = file;
  size_ = 0;
  if (out_.is_open()) out_.close();
  out_.clear();
  errno = 0;
  out_.open(file, std::ios::binary | std::ios::trunc);
  if (!out_) return cannotWrite(file_, errno);
  return Done{};
}

Status LineFile::write(const std::string& line) {
  errno = 0;
  out_ << line << '\n' << std::flush;
  if (out_) {
    size_ += line.size() + 1;
    return Done{};
  }
  const int reason = errno;
  // A part of the line may have been written: readers refuse files that end in half a row.
  out_.close();
  std::error_code ec;
  fs::resize_file(file_, size_, ec);
  return cannotWrite(file_, reason);
}

}  // namespace svoscope
