// SPDX-License-Identifier: MIT
// A loader for one layout of sequences: a file of its own that defines a function such as
// `Loader tumLoader()`, and a row in the list of open_sequence.cpp.
#pragma once

#include <filesystem>
#include <memory>

#include "engine/dataset/sequence.h"

namespace svoscope {

using OpenedSequence = Result<std::unique_ptr<Sequence>>;

/// The path exists. Asking may throw filesystem_error; opening reports input errors that name the
/// file that is missing or damaged and the layout expected.
struct Loader {
  enum class Takes { folder, file };

  Takes takes;
  const char* layout;  ///< for the error that lists what is known: "mav0/ (EuRoC/ASL)"
  bool (*recognises)(const std::filesystem::path& path);
  OpenedSequence (*open)(const std::filesystem::path& path, const OpenOptions& options);
  /// Null, or: a part of the layout is there. Opened if nobody recognises the path, as its error
  /// says what is missing.
  bool (*resembles)(const std::filesystem::path& path) = nullptr;
};

}  // namespace svoscope
