// SPDX-License-Identifier: MIT
#include "engine/runner/lockstep_runner.h"

#include <algorithm>
#include <limits>

#include "engine/runner/lockstep_view.h"

namespace svoscope {

namespace {

constexpr auto kPoll = std::chrono::microseconds(300);  // for a frame of a run with threads
constexpr double kGivenUpMs = 2000;                     // at rest, though a frame was asked for

Command commandOf(Command::Kind kind, int frame = -1, const std::string& value = "") {
  Command command;
  command.kind = kind;
  command.frame = frame;
  command.value = value;
  return command;
}

}  // namespace

LockstepRunner::LockstepRunner(std::vector<LockstepMember> members, Drive drive) {
  for (LockstepMember& given : members) {
    Member member;
    static_cast<LockstepMember&>(member) = std::move(given);
    member.view = std::make_unique<LockstepView>(*member.runner, frame_);
    // Paced here. As fast as possible means to a run with threads that no measurement is dropped.
    member.runner->send(commandOf(Command::Kind::set_speed, -1, "0"));
    members_.push_back(std::move(member));
  }
  while (current_ + 1 < size() && posesOnly(current_)) ++current_;
  publish();
  if (drive == Drive::by_thread) thread_ = std::thread([this] { loop(); });
}

LockstepRunner::~LockstepRunner() {
  if (!thread_.joinable()) return;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    stop_ = true;
  }
  wake_.notify_all();
  thread_.join();
}

const RunView& LockstepRunner::run(int i) const { return *member(i).view; }

Status LockstepRunner::setCurrent(int i) {
  if (i < 0 || i >= size()) {
    return usageError("there is no run " + std::to_string(i), "",
                      "there are " + std::to_string(size()) + ", counted from 0");
  }
  if (posesOnly(i)) {
    return usageError(label(i) + " has poses only", "", "it is shown in the Compare panels");
  }
  current_ = i;
  return Done{};
}

void LockstepRunner::send(const Command& command) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    commands_.push_back(command);
  }
  wake_.notify_all();
}

bool LockstepRunner::pump() { return thread_.joinable() ? false : advance(); }

RunnerStatus LockstepRunner::status() const {
  RunnerStatus status = member(current_).runner->status();
  status.recorded = false;  // the set moves forwards only, though a recording could jump
  status.history_bytes = status.history_budget = 0;
  double frame_s = 0;
  for (const Member& m : members_) {
    const RunnerStatus one = m.runner->status();
    status.history_bytes += one.history_bytes;
    status.history_budget += one.history_budget;
    if (one.fps > 0) frame_s += 1 / one.fps;
  }
  status.fps = frame_s > 0 ? 1 / frame_s : 0;
  const std::lock_guard<std::mutex> lock(mutex_);
  // A command not yet looked at counts as playing: who waits for the end must not miss it.
  status.playing = playing_ || !commands_.empty();
  status.finished = finished_;
  status.next_frame = next_frame_;
  return status;
}

/// False if there was none.
bool LockstepRunner::takeCommands() {
  bool any = false;
  for (;;) {
    Command command;
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      if (commands_.empty() || resetting_) return any;
      command = commands_.front();
      // A step asked for by one command must not be swallowed by the next.
      if (playback_.wantsFrame() && command.kind == Command::Kind::step && turn_ >= 0) return any;
      commands_.pop_front();
      playing_ = true;  // until it took effect
    }
    handle(command);
    any = true;
    if (command.kind == Command::Kind::step) return any;
  }
}

void LockstepRunner::handle(const Command& command) {
  next_time_ = {};
  playback_.handle(command);
  if (command.kind == Command::Kind::set_parameter) {
    members_[static_cast<std::size_t>(current_)].runner->send(command);
  } else if (command.kind == Command::Kind::reset) {
    resetting_ = true;
    turn_ = -1;
    for (Member& m : members_) {
      m.generation_before = m.runner->generation();
      m.runner->send(command);
    }
  }
}

/// True once every run has an empty map and no frame.
bool LockstepRunner::finishReset() {
  for (Member& m : members_) {
    if (m.runner->generation() == m.generation_before) m.runner->pump();
    if (m.runner->generation() == m.generation_before) return false;
  }
  for (Member& m : members_) {
    m.rows_seen = 0;
    m.ended = false;
    m.state = TrackingState::initializing;
  }
  resetting_ = false;
  frame_ = -1;
  ++generation_;
  publish();
  return true;
}

bool LockstepRunner::behind(const Member& m) const {
  const RunnerStatus status = m.runner->status();
  return !m.ended && !status.finished && status.next_frame <= target_;
}

/// A run that stays at rest though a frame was asked for must not hold up the others.
bool LockstepRunner::gaveUp(Member& m, bool worked) {
  if (worked || m.runner->status().playing) {
    idle_since_ms_ = clock_.ms();
    return false;
  }
  m.ended = clock_.ms() - idle_since_ms_ > kGivenUpMs;
  return m.ended;
}

bool LockstepRunner::due() {
  if (playback_.speed() <= 0) return true;
  const auto now = std::chrono::steady_clock::now();
  if (now < next_time_) return false;
  const auto interval =
      std::chrono::microseconds(static_cast<std::int64_t>(1e6 / playback_.speed()));
  next_time_ = std::max(next_time_, now - interval) + interval;
  return true;
}

/// Chooses the next frame; false if none is wanted now.
bool LockstepRunner::beginFrame() {
  if (!playback_.wantsFrame()) return false;
  int next = std::numeric_limits<int>::max();
  for (const Member& m : members_) {
    const RunnerStatus status = m.runner->status();
    if (!m.ended && !status.finished) next = std::min(next, status.next_frame);
  }
  if (next == std::numeric_limits<int>::max()) {
    playback_.finish();
    publish();
    return false;
  }
  if (!due()) return false;
  target_ = next;
  turn_ = 0;
  asked_ = false;
  return true;
}

void LockstepRunner::endFrame() {
  FrameRecord goal;  // a run that sat it out has no row
  goal.index = target_;
  bool started = false;
  for (int i = 0; i < size(); ++i) {
    Member& m = members_[static_cast<std::size_t>(i)];
    for (const FrameRecord& row : m.runner->records(m.rows_seen)) {
      ++m.rows_seen;
      if (i == current_) {
        started =
            m.state == TrackingState::initializing && row.state != TrackingState::initializing;
        if (row.index == target_) goal = row;
      }
      m.state = row.state;
    }
  }
  turn_ = -1;
  frame_ = target_;
  playback_.processed(goal, started);
  publish();
}

/// One run's frame at most; true if something was done.
bool LockstepRunner::advance() {
  takeCommands();
  if (resetting_) return finishReset();
  if (turn_ < 0 && !beginFrame()) {
    for (Member& m : members_) m.runner->pump();  // parameters that were set
    publish();
    return false;
  }
  for (; turn_ < size(); ++turn_, asked_ = false) {
    Member& m = members_[static_cast<std::size_t>(turn_)];
    bool worked = false;
    if (behind(m)) {
      if (!asked_) {
        m.runner->send(commandOf(Command::Kind::run_to_frame, target_));
        asked_ = true;
        idle_since_ms_ = clock_.ms();
      }
      worked = m.runner->pump();
      if (behind(m) && !gaveUp(m, worked)) return worked;
    }
    if (!worked || turn_ + 1 == size()) continue;
    ++turn_;
    asked_ = false;
    return true;
  }
  endFrame();
  return true;
}

bool LockstepRunner::atRest() const { return turn_ < 0 && !resetting_ && !playback_.wantsFrame(); }

void LockstepRunner::publish() {
  int next = std::numeric_limits<int>::max(), last = 0;
  bool finished = turn_ < 0;
  for (const Member& m : members_) {
    const RunnerStatus status = m.runner->status();
    last = std::max(last, status.next_frame);
    if (m.ended || status.finished) continue;
    finished = false;
    next = std::min(next, status.next_frame);
  }
  if (finished) playback_.finish();
  const std::lock_guard<std::mutex> lock(mutex_);
  playing_ = !atRest();
  finished_ = finished;
  next_frame_ = finished ? last : frame_ >= 0 ? frame_ + 1 : next;
}

void LockstepRunner::loop() {
  for (;;) {
    const bool worked = advance();
    std::unique_lock<std::mutex> lock(mutex_);
    if (stop_) return;
    if (worked || !commands_.empty()) continue;
    if (atRest())
      wake_.wait(lock, [this] { return stop_ || !commands_.empty(); });
    else
      wake_.wait_until(lock, std::max(next_time_, std::chrono::steady_clock::now() + kPoll));
  }
}

}  // namespace svoscope
