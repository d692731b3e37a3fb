// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <csignal>

namespace svoscope {

/// While it lives, Ctrl-C (SIGINT) and SIGTERM set a flag so that a command can end in order;
/// pressed again a while later they end the program at once. One at a time.
class InterruptGuard {
 public:
  InterruptGuard();
  ~InterruptGuard();
  InterruptGuard(const InterruptGuard&) = delete;
  InterruptGuard& operator=(const InterruptGuard&) = delete;

  const std::atomic<bool>& flag() const;

 private:
  struct sigaction before_interrupt_ = {}, before_terminate_ = {};
};

}  // namespace svoscope
