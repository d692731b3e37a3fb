// SPDX-License-Identifier: MIT
// Child processes, so many at a time, each into a folder of its own.
#pragma once

#include <atomic>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "engine/bench/child_process.h"

namespace svoscope {

struct QueuedRun {
  std::vector<std::string> argv;    ///< without the output folder
  std::filesystem::path folder;     ///< where the result belongs
  std::filesystem::path temporary;  ///< where it is written to, removed unless `done` moves it away
};

struct RunEnd {
  ChildEnd end;
  bool timed_out = false;
  double wall_s = 0;
};

struct QueueOptions {
  int jobs = 1;
  double timeout_s = 0;
  const std::atomic<bool>* stop = nullptr;
};

/// Runs `runs` in their order with "--out TEMPORARY" added, output and errors into
/// TEMPORARY/log.txt, and calls `done` with the index of each that ended. False if stopped: the
/// running ones were ended and their folders removed. The first error of `done` or of a start ends
/// all.
Result<bool> runQueue(const std::vector<QueuedRun>& runs, const QueueOptions& options,
                      const std::function<Status(std::size_t, const RunEnd&)>& done);

/// A folder beside `folder`, hidden, that names machine and process.
std::filesystem::path temporaryBeside(const std::filesystem::path& folder);
/// Removes such folders below `root` whose process is gone.
void removeAbandoned(const std::filesystem::path& root);

}  // namespace svoscope
