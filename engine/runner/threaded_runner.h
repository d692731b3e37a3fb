// SPDX-License-Identifier: MIT
// Tracking and mapping in a thread each. They exchange jobs and results by value through queues;
// the outside sees only the run log. The destructor stops and joins both.
#pragma once

#include <condition_variable>
#include <deque>
#include <mutex>
#include <thread>

#include "engine/runner/blocking_queue.h"
#include "engine/runner/make_runner.h"
#include "engine/runner/publish.h"

namespace svoscope {

class ThreadedRunner : public Runner {
 public:
  ThreadedRunner(std::unique_ptr<Sequence> sequence, const RunnerOptions& options);
  ~ThreadedRunner() override;

  void send(const Command& command) override;
  bool pump() override { return false; }
  const RunInfo& info() const override { return info_; }
  RunnerStatus status() const override;
  SnapshotPtr latest() const override { return log_.latest(); }
  SnapshotPtr at(int frame_index) const override { return log_.at(frame_index); }
  std::vector<FrameRecord> records(int first) const override { return log_.records(first); }
  std::vector<Event> events(int first) const override { return log_.events(first); }
  std::vector<ParameterView> parameters() const override;
  int generation() const override { return log_.generation(); }

 private:
  /// A job with the parameters of its time and the generation of the map it belongs to.
  struct Task {
    MappingJob job;
    MappingParameters parameters;
    int generation = 0;
  };
  struct Answer {
    MappingResult result;
    int generation = 0;
  };

  void trackingLoop();
  void mappingLoop();
  bool takeCommands();  ///< waits while there is nothing to do; false: stop
  void handle(const Command& command);
  void processFrame();
  void applyAnswers();
  void pace();
  void publishStatus();
  RunParts parts() { return {engine_, playback_, log_, publish_}; }  ///< tracking thread only

  Engine engine_;      ///< tracking thread only
  Playback playback_;  ///< tracking thread only
  const RunInfo info_;
  RunLog log_;
  const bool publish_;
  int map_generation_ = 0;  ///< tracking thread only

  BlockingQueue<Task> tasks_;
  BlockingQueue<Answer> answers_;

  mutable std::mutex mutex_;  ///< guards the members below
  std::condition_variable wake_;
  std::deque<Command> commands_;
  bool stop_ = false;
  RunnerStatus status_;
  std::vector<ParameterView> parameter_views_;

  FrameRate rate_;  ///< tracking thread only
  std::chrono::steady_clock::time_point next_frame_time_{};
  std::thread tracking_, mapping_;
};

}  // namespace svoscope
