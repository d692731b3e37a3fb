// SPDX-License-Identifier: MIT
// Records a run while it goes on: a thread of its own writes what the runner hands over. The queue
// between them is bounded; a disk that cannot follow slows the run and loses nothing.
#pragma once

#include <atomic>
#include <mutex>
#include <thread>
#include <variant>

#include "engine/recording/recording_writer.h"
#include "engine/runner/blocking_queue.h"
#include "engine/runner/run_observer.h"

namespace svoscope {

constexpr const char* kRecordingName = "run.svoscope";  ///< in the folder of a run's results

class Recorder : public RunObserver {
 public:
  Recorder() = default;
  ~Recorder() override;  ///< closes

  /// Makes the file anew and writes from now on. Output error if it cannot be written. Call it when
  /// the runner was made and before its first frame: what the runner said of itself is waiting.
  Status start(const std::filesystem::path& file, const RecordingOptions& options);

  void begin(const RunInfo& info) override;
  void parameters(const std::vector<ParameterView>& parameters, int from) override;
  void frame(const SnapshotPtr& snapshot) override;
  void note(const Event& event) override;
  void reset() override;

  /// Writes what is waiting and completes the file. Output error if something could not be written;
  /// what was committed before stays readable. Further calls give the same answer.
  Status close();

 private:
  struct ParameterSet {
    std::vector<ParameterView> values;
    int from = 0;
  };
  struct Reset {};
  using Item = std::variant<SnapshotPtr, Event, RunInfo, ParameterSet, Reset>;

  void push(Item item);
  void loop();
  Status write(const Item& item);
  void check(const Status& status);

  std::unique_ptr<RecordingWriter> writer_;  ///< writing thread only, until it was joined
  BlockingQueue<Item> queue_;
  std::atomic<bool> failed_{false};
  std::mutex mutex_;  ///< guards outcome_
  Status outcome_ = Done{};
  std::thread thread_;
};

}  // namespace svoscope
