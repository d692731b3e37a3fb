// SPDX-License-Identifier: MIT
#include "ui/panels/filter/lab_worker.h"

#include <algorithm>

namespace svoscope::ui {

LabWorker::~LabWorker() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    stop_ = true;
  }
  wake_.notify_all();
  if (thread_.joinable()) thread_.join();
}

int LabWorker::seedsAt(int stage, int wanted) {
  constexpr int divisors[kStages] = {16, 4, 1};
  return std::max(std::min(wanted, 60), wanted / divisors[stage]);
}

void LabWorker::start(const LabOptions& options) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    wanted_ = options;
    stage_ = 0;
    ++order_;
    if (!thread_.joinable())
      thread_ = std::thread([this] { loop(); });  // no thread before it is needed
  }
  wake_.notify_all();
}

void LabWorker::cancel() {
  const std::lock_guard<std::mutex> lock(mutex_);
  stage_ = kStages;
  ++order_;
  idle_.notify_all();
}

void LabWorker::wait() const {
  std::unique_lock<std::mutex> lock(mutex_);
  idle_.wait(lock, [this] { return stage_ == kStages; });
}

LabWorker::State LabWorker::state() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  State s;
  s.running = stage_ < kStages;
  if (s.running) {
    double done = 0, all = 0;
    for (int i = 0; i < kStages; ++i) {
      all += seedsAt(i, wanted_.seeds);
      if (i < stage_) done += seedsAt(i, wanted_.seeds);
    }
    s.progress = done / all;
  }
  s.result = result_;
  s.generation = generation_;
  return s;
}

void LabWorker::loop() {
  std::unique_lock<std::mutex> lock(mutex_);
  for (;;) {
    wake_.wait(lock, [this] { return stop_ || stage_ < kStages; });
    if (stop_) return;
    const int order = order_;
    LabOptions options = wanted_;
    options.seeds = seedsAt(stage_, wanted_.seeds);
    lock.unlock();
    auto result = std::make_shared<const LabResult>(run_(options));
    lock.lock();
    if (order != order_) continue;  // something else is wanted by now
    result_ = std::move(result);
    ++generation_;
    if (++stage_ == kStages) idle_.notify_all();
  }
}

}  // namespace svoscope::ui
