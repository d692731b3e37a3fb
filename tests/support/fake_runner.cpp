// SPDX-License-Identifier: MIT
#include "tests/support/fake_runner.h"

#include <algorithm>

namespace svoscope {

FakeRunner::FakeRunner(const FakeOptions& options) : options_(options), world_(options) {
  makeParameters();
}

void FakeRunner::makeParameters() {
  const auto add = [this](ParameterView p) { parameters_.push_back(std::move(p)); };
  add({"tracking.min_inliers",
       "40",
       "40",
       "",
       "inliers below this: lost",
       "int",
       5,
       500,
       {},
       false});
  add({"tracking.max_iterations",
       "10",
       "10",
       "",
       "Gauss-Newton iterations per level",
       "int",
       1,
       50,
       {},
       false});
  add({"reproject.cell_px",
       "28",
       "25",
       "px",
       "one feature is tried per cell",
       "int",
       8,
       100,
       {},
       false});
  add({"reproject.max_features",
       "180",
       "180",
       "",
       "features matched per frame",
       "int",
       20,
       1000,
       {},
       false});
  add({"seeds.rule",
       "js",
       "js",
       "",
       "divergence that weights a measurement",
       "choice",
       0,
       0,
       {"kl", "js"},
       true});
  add({"seeds.convergence",
       "0.005",
       "0.005",
       "",
       "sigma over range at which a seed has converged",
       "float",
       0,
       1,
       {},
       false});
  add({"seeds.edgelets", "true", "true", "", "make seeds on edges, too", "bool", 0, 0, {}, false});
  add({"pyramid.levels", "4", "4", "", "image pyramid levels", "int", 1, 8, {}, true});
}

void FakeRunner::process() {
  const auto held = [this](int frame) {
    const SnapshotPtr snapshot = at(frame);
    return snapshot ? snapshot->pyramid : nullptr;
  };
  const auto s = world_.snapshot(static_cast<int>(records_.size()), held);
  s->sequence_number = ++sequence_;
  records_.push_back(s->record);
  events_.insert(events_.end(), s->events.begin(), s->events.end());
  history_.push_back(s);
  while (static_cast<int>(history_.size()) > options_.history) history_.pop_front();
}

void FakeRunner::send(const Command& command) {
  sent_.push_back(command);
  switch (command.kind) {
    case Command::Kind::step:
      ++pending_steps_;
      break;
    case Command::Kind::play:
      playing_ = true;
      run_to_ = Command::Kind::pause;
      break;
    case Command::Kind::pause:
      playing_ = false;
      break;
    case Command::Kind::reset:
      history_.clear();
      records_.clear();
      events_.clear();
      playing_ = false;
      ++generation_;
      break;
    case Command::Kind::set_parameter:
      for (ParameterView& p : parameters_) {
        if (p.key == command.key) p.value = command.value;
      }
      break;
    case Command::Kind::set_speed:
      break;
    default:
      playing_ = true;
      run_to_ = command.kind;
      stop_after_ = command.frame;
  }
}

bool FakeRunner::pump() {
  if (static_cast<int>(records_.size()) >= options_.frames) playing_ = false;
  if (static_cast<int>(records_.size()) >= options_.frames || (!playing_ && pending_steps_ == 0))
    return false;
  if (pending_steps_ > 0) --pending_steps_;
  process();
  const FrameRecord& r = records_.back();
  const bool reached = (run_to_ == Command::Kind::run_to_keyframe && r.is_keyframe) ||
                       (run_to_ == Command::Kind::run_to_loss && r.state == TrackingState::lost) ||
                       (run_to_ == Command::Kind::run_to_start && r.index == options_.start) ||
                       (run_to_ == Command::Kind::run_to_frame && r.index >= stop_after_);
  if (reached) playing_ = false;
  return true;
}

void FakeRunner::runTo(int frames) {
  while (static_cast<int>(records_.size()) < std::min(frames, options_.frames)) process();
}

RunnerStatus FakeRunner::status() const {
  RunnerStatus s;
  s.playing = playing_;
  s.finished = static_cast<int>(records_.size()) >= options_.frames;
  s.next_frame = static_cast<int>(records_.size());
  s.history_bytes = history_.size() * 600000;
  s.history_budget = 512u << 20;
  s.history_first = history_.empty() ? 0 : history_.front()->record.index;
  s.fps = 41.3;
  return s;
}

SnapshotPtr FakeRunner::at(int frame_index) const {
  if (history_.empty()) return nullptr;
  const int i = frame_index - history_.front()->record.index;
  return i >= 0 && i < static_cast<int>(history_.size()) ? history_[static_cast<std::size_t>(i)]
                                                         : nullptr;
}

std::vector<FrameRecord> FakeRunner::records(int first) const {
  if (first >= static_cast<int>(records_.size())) return {};
  return {records_.begin() + first, records_.end()};
}

std::vector<Event> FakeRunner::events(int first) const {
  if (first >= static_cast<int>(events_.size())) return {};
  return {events_.begin() + first, events_.end()};
}

}  // namespace svoscope
