// SPDX-License-Identifier: MIT
#include "app/progress.h"

#include <unistd.h>

#include <cstdio>

namespace svoscope {

namespace {
constexpr double kTerminalMs = 100, kPlainMs = 5000;
}

Progress::Progress() : terminal_(isatty(STDERR_FILENO) == 1) {}

Progress::~Progress() {
  if (terminal_ && shown_) std::fputs("\r\x1b[K", stderr);
}

void Progress::show(const std::string& text) {
  if (since_.ms() < (terminal_ ? kTerminalMs : kPlainMs)) return;
  since_ = Stopwatch();
  shown_ = true;
  std::fprintf(stderr, terminal_ ? "\r\x1b[K%s" : "%s\n", text.c_str());
  std::fflush(stderr);
}

}  // namespace svoscope
