// SPDX-License-Identifier: MIT
#include "ui/host_pacing.h"

#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>

namespace svoscope::ui {
namespace {

constexpr double kFastest = 1.0 / 60;
constexpr int kSettlingFrames = 3;

}  // namespace

double FramePacer::interval(const Situation& s) const {
  const bool active = s.input || settling_ > 0;
  if (software_) {
    if (s.playing) return std::max(active ? 0.05 : 0.1, 4 * cost_);
    if (active || s.new_snapshot) return kFastest;
    return 1.0;  // toasts and the like still fade
  }
  return active || s.new_snapshot || s.playing ? kFastest : 0.5;
}

bool FramePacer::due(const Situation& s, double now) const {
  // While playing in software, nothing new means nothing to draw, however long ago the last was.
  if (software_ && s.playing && !s.input && !s.new_snapshot && settling_ == 0 && now - last_ < 1) {
    return false;
  }
  // A hair early rather than a whole poll late.
  return now - last_ >= interval(s) - 1e-3;
}

void FramePacer::drawn(const Situation& s, double now, double cost) {
  last_ = now;
  cost_ = cost;
  settling_ = s.input ? kSettlingFrames : std::max(0, settling_ - 1);
}

double FramePacer::patience(const Situation& s, double now) const {
  const double longest = s.playing ? kFastest : 0.1;
  return std::clamp(last_ + interval(s) - now, 0.001, longest);
}

void yieldToEngine() {
  // Linux: the priority is the thread's own, not the process's. A refusal does no harm.
  (void)setpriority(PRIO_PROCESS, static_cast<id_t>(syscall(SYS_gettid)), 15);
}

}  // namespace svoscope::ui
