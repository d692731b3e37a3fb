// SPDX-License-Identifier: MIT
#include "engine/runner/threaded_runner.h"

#include "engine/base/stopwatch.h"

namespace svoscope {

namespace {
/// Jobs waiting beyond this: at a set speed those that only measure old seeds are dropped, as a
/// camera would not wait; as fast as possible, tracking waits, so that no measurement is lost.
constexpr std::size_t kMostWaiting = 3;
}  // namespace

ThreadedRunner::ThreadedRunner(std::unique_ptr<Sequence> sequence, const RunnerOptions& o)
    : engine_(std::move(sequence), o.parameters, o.start, o.max_frames, o.method),
      info_(engine_.info()),
      log_(o.history_budget, o.observer),
      publish_(o.publish_snapshots) {
  engine_.setTimed(true);
  engine_.setInspected(publish_);
  engine_.setPlaced(o.place_seeds);
  parameter_views_ = listParameters(engine_.parameters());
  log_.begin(engine_.info());
  log_.parameters(parameter_views_, engine_.nextFrame());
  publishStatus();
  tracking_ = std::thread([this] { trackingLoop(); });
  mapping_ = std::thread([this] { mappingLoop(); });
}

ThreadedRunner::~ThreadedRunner() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    stop_ = true;
  }
  wake_.notify_all();
  tracking_.join();
  tasks_.clear();
  tasks_.close();
  mapping_.join();
}

void ThreadedRunner::send(const Command& command) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    commands_.push_back(command);
  }
  wake_.notify_all();
}

RunnerStatus ThreadedRunner::status() const {
  RunnerStatus status;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    status = status_;
    // A command not yet looked at counts as playing: who waits for the end must not miss it.
    status.playing = status.playing || !commands_.empty();
  }
  status.mapping_queue = static_cast<int>(tasks_.size());
  log_.describe(status);
  return status;
}

std::vector<ParameterView> ThreadedRunner::parameters() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return parameter_views_;
}

void ThreadedRunner::publishStatus() {
  const std::lock_guard<std::mutex> lock(mutex_);
  status_.playing = playback_.playing();
  status_.finished = engine_.finished();
  status_.next_frame = engine_.nextFrame();
  status_.fps = rate_.fps();
}

bool ThreadedRunner::takeCommands() {
  std::unique_lock<std::mutex> lock(mutex_);
  wake_.wait(lock, [this] { return stop_ || !commands_.empty() || playback_.wantsFrame(); });
  while (!stop_ && !commands_.empty()) {
    const Command command = commands_.front();
    commands_.pop_front();
    // Until the command took effect, whoever looks must see the runner as busy.
    status_.playing = true;
    lock.unlock();
    handle(command);
    lock.lock();
    if (command.kind == Command::Kind::step) break;
  }
  return !stop_;
}

void ThreadedRunner::handle(const Command& command) {
  next_frame_time_ = {};
  if (command.kind == Command::Kind::reset) {
    ++map_generation_;
    tasks_.clear();
  }
  applyCommand(parts(), command);
  if (command.kind != Command::Kind::set_parameter) return;
  const std::lock_guard<std::mutex> lock(mutex_);
  parameter_views_ = listParameters(engine_.parameters());
}

void ThreadedRunner::applyAnswers() {
  while (auto answer = answers_.tryPop()) {
    if (answer->generation == map_generation_) engine_.applyMapping(answer->result);
  }
}

void ThreadedRunner::processFrame() {
  Stopwatch watch;
  engine_.step();
  if (auto job = engine_.takeMappingJob()) {
    if (playback_.speed() <= 0) {
      tasks_.waitBelow(kMostWaiting);
    } else if (tasks_.size() >= kMostWaiting) {
      tasks_.filter(
          [](const Task& t) { return t.job.new_seeds.wanted || !t.job.adjustment.empty(); });
    }
    tasks_.push({std::move(*job), engine_.mappingParameters(), map_generation_});
  }
  applyAnswers();
  publishFrame(parts());
  rate_.add(watch.ms());
}

/// Waits for the frame's turn when a speed is set; commands cut the wait short.
void ThreadedRunner::pace() {
  if (playback_.speed() <= 0) return;
  const auto now = std::chrono::steady_clock::now();
  if (next_frame_time_ < now) next_frame_time_ = now;
  std::unique_lock<std::mutex> lock(mutex_);
  wake_.wait_until(lock, next_frame_time_, [this] { return stop_ || !commands_.empty(); });
  next_frame_time_ += std::chrono::microseconds(static_cast<std::int64_t>(1e6 / playback_.speed()));
}

void ThreadedRunner::trackingLoop() {
  while (takeCommands()) {
    if (playback_.wantsFrame() && engine_.finished()) playback_.finish();
    if (playback_.wantsFrame()) {
      pace();
      processFrame();
    }
    publishStatus();
  }
}

void ThreadedRunner::mappingLoop() {
  while (auto task = tasks_.pop()) {
    answers_.push({runMappingJob(task->job, task->parameters), task->generation});
  }
}

}  // namespace svoscope
