// SPDX-License-Identifier: MIT
// A run as one can look at it, whether an engine computes it, a file holds it, or both.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "engine/snapshot/snapshot.h"

namespace svoscope {

struct ParameterView {
  std::string key;  ///< "reproject.cell_px"
  std::string value, default_value;
  std::string unit;     ///< "px", "" if none
  std::string meaning;  ///< one short phrase
  std::string type;     ///< "bool", "int", "float", "choice"
  double minimum = 0, maximum = 0;
  std::vector<std::string> choices;
  bool needs_reset = false;
};

struct RunnerStatus {
  bool playing = false;
  bool finished = false;  ///< the last frame was processed
  int next_frame = 0;
  int mapping_queue = 0;  ///< mapping jobs waiting (threaded)
  std::size_t history_bytes = 0, history_budget = 0;
  int history_first = 0;  ///< oldest frame still held
  double fps = 0;         ///< engine frames per second, recent
  /// A recording is played back: nothing is computed, parameters cannot be changed, run_to_frame
  /// goes to any frame at once, backwards too, and no frame is ever evicted.
  bool recorded = false;
};

/// Everything that can be read of a run. Code that does not command the run takes this.
class RunView {
 public:
  virtual ~RunView() = default;

  virtual const RunInfo& info() const = 0;
  virtual RunnerStatus status() const = 0;
  virtual SnapshotPtr latest() const = 0;             ///< null before the first frame
  virtual SnapshotPtr at(int frame_index) const = 0;  ///< null if evicted or not yet processed
  /// The same without need of the image, which may be missing: for walks over many frames.
  virtual SnapshotPtr valuesAt(int frame_index) const { return at(frame_index); }
  /// Rows of all processed frames from position `first` on (position == frames processed before).
  virtual std::vector<FrameRecord> records(int first) const = 0;
  /// Events of the run from position `first` on.
  virtual std::vector<Event> events(int first) const = 0;
  virtual std::vector<ParameterView> parameters() const = 0;
  /// Increases at every reset: caches built from records() or events() start again.
  virtual int generation() const = 0;
};

}  // namespace svoscope
