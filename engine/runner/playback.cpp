// SPDX-License-Identifier: MIT
#include "engine/runner/playback.h"

#include <algorithm>
#include <cstdlib>

namespace svoscope {

void Playback::handle(const Command& command) {
  switch (command.kind) {
    case Command::Kind::step:
      mode_ = Mode::step;
      break;
    case Command::Kind::play:
      mode_ = Mode::play;
      break;
    case Command::Kind::pause:
    case Command::Kind::reset:
      mode_ = Mode::paused;
      break;
    case Command::Kind::run_to_frame:
      mode_ = Mode::to_frame;
      target_ = command.frame;
      break;
    case Command::Kind::run_to_keyframe:
      mode_ = Mode::to_keyframe;
      break;
    case Command::Kind::run_to_loss:
      mode_ = Mode::to_loss;
      break;
    case Command::Kind::run_to_start:
      mode_ = Mode::to_start;
      break;
    case Command::Kind::set_speed:
      speed_ = std::max(0.0, std::atof(command.value.c_str()));
      break;
    case Command::Kind::set_parameter:
      break;
  }
}

void Playback::processed(const FrameRecord& record, bool started) {
  const bool reached = mode_ == Mode::step ||
                       (mode_ == Mode::to_frame && record.index >= target_) ||
                       (mode_ == Mode::to_keyframe && record.is_keyframe) ||
                       (mode_ == Mode::to_loss && record.state == TrackingState::lost) ||
                       (mode_ == Mode::to_start && started);
  if (reached) mode_ = Mode::paused;
}

}  // namespace svoscope
