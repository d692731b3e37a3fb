// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <csignal>

namespace svoscope {

/// While it lives, Ctrl-C sets a flag so that a command can end in order; pressed again it ends the
/// program at once. One at a time.
class InterruptGuard {
 public:
  InterruptGuard();
  ~InterruptGuard();
  InterruptGuard(const InterruptGuard&) = delete;
  InterruptGuard& operator=(const InterruptGuard&) = delete;

  const std::atomic<bool>& flag() const;

 private:
  struct sigaction before_ = {};
};

}  // namespace svoscope
