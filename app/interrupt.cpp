// SPDX-License-Identifier: MIT
#include "app/interrupt.h"

#include <ctime>

namespace svoscope {

namespace {
std::atomic<bool> g_interrupted{false};  // the one thing a signal handler can reach
std::atomic<long> g_first_second{0};
static_assert(std::atomic<bool>::is_always_lock_free && std::atomic<long>::is_always_lock_free,
              "must be safe in a signal handler");

/// Shells and timeout(1) signal both the process and its group: only an interrupt that comes later
/// than the first by a second is a person's second Ctrl-C.
void onInterrupt(int signal_number) {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  if (!g_interrupted) {
    g_first_second = static_cast<long>(now.tv_sec);
    g_interrupted = true;
  } else if (now.tv_sec > g_first_second + 1) {
    signal(signal_number, SIG_DFL);
    raise(signal_number);
  }
}
}  // namespace

InterruptGuard::InterruptGuard() {
  g_interrupted = false;
  struct sigaction action = {};
  action.sa_handler = onInterrupt;
  sigaction(SIGINT, &action, &before_interrupt_);
  sigaction(SIGTERM, &action, &before_terminate_);
}

InterruptGuard::~InterruptGuard() {
  sigaction(SIGINT, &before_interrupt_, nullptr);
  sigaction(SIGTERM, &before_terminate_, nullptr);
}

const std::atomic<bool>& InterruptGuard::flag() const { return g_interrupted; }

}  // namespace svoscope
