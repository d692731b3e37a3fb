// SPDX-License-Identifier: MIT
// A program started and watched without threads.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "engine/base/result.h"

namespace svoscope {

struct ChildEnd {
  int exit_code = 0;
  int signal = 0;  ///< that ended it, 0: none
};

class ChildProcess {
 public:
  /// Starts argv[0] in a process group of its own, without input, output and errors into `log`. It
  /// dies with this process, however that ends. Internal error if it cannot be started.
  static Result<ChildProcess> start(const std::vector<std::string>& argv,
                                    const std::filesystem::path& log);

  /// Empty while it runs; once only with a value.
  std::optional<ChildEnd> poll();
  void signal(int number) const;  ///< to the whole group
  double seconds() const;         ///< since the start

 private:
  explicit ChildProcess(pid_t pid);
  pid_t pid_;
  double started_s_;
};

}  // namespace svoscope
