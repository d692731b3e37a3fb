// SPDX-License-Identifier: MIT
#include "app/interrupt.h"

namespace svoscope {

namespace {
std::atomic<bool> g_interrupted{false};  // the one thing a signal handler can reach
static_assert(std::atomic<bool>::is_always_lock_free, "must be safe in a signal handler");
}  // namespace

InterruptGuard::InterruptGuard() {
  g_interrupted = false;
  struct sigaction action = {};
  action.sa_handler = [](int) { g_interrupted = true; };
  action.sa_flags = static_cast<int>(SA_RESETHAND);
  sigaction(SIGINT, &action, &before_);
}

InterruptGuard::~InterruptGuard() { sigaction(SIGINT, &before_, nullptr); }

const std::atomic<bool>& InterruptGuard::flag() const { return g_interrupted; }

}  // namespace svoscope
