// SPDX-License-Identifier: MIT
// Runs the filter lab beside the window: a small population first, then larger ones, the newest
// options winning. The destructor stops and joins.
#pragma once

#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <thread>

#include "engine/study/lab.h"

namespace svoscope::ui {

class LabWorker {
 public:
  using Run = std::function<LabResult(const LabOptions&)>;

  explicit LabWorker(Run run = runLab) : run_(std::move(run)) {}
  ~LabWorker();
  LabWorker(const LabWorker&) = delete;
  LabWorker& operator=(const LabWorker&) = delete;

  /// Starts over with these options; what still runs for older ones is dropped.
  void start(const LabOptions& options);
  /// Keeps what is there.
  void cancel();

  /// Until nothing is left to simulate; for scripts, which have no time to look at.
  void wait() const;

  struct State {
    bool running = false;
    double progress = 1;                      ///< 0 .. 1, of the seeds to be simulated
    std::shared_ptr<const LabResult> result;  ///< newest; may be of fewer seeds than wanted
    int generation = 0;                       ///< changes with the result
  };
  State state() const;

 private:
  void loop();

  Run run_;
  mutable std::mutex mutex_;
  std::condition_variable wake_;
  mutable std::condition_variable idle_;
  bool stop_ = false;
  LabOptions wanted_;
  int order_ = 0;        ///< counts calls of start()
  int stage_ = kStages;  ///< of the order under way; kStages: nothing left
  int generation_ = 0;
  std::shared_ptr<const LabResult> result_;
  std::thread thread_;

  static constexpr int kStages = 3;
  static int seedsAt(int stage, int wanted);
};

}  // namespace svoscope::ui
