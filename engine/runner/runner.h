// SPDX-License-Identifier: MIT
// Commands in, snapshots out. The same interface with and without threads: the user interface and
// the command line see nothing else of a running engine.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "engine/snapshot/snapshot.h"

namespace svoscope {

struct Command {
  enum class Kind : std::uint8_t {
    step,  ///< process one frame, then pause
    play,
    pause,
    run_to_frame,     ///< pause after frame `frame` was processed
    run_to_keyframe,  ///< pause at the next keyframe
    run_to_loss,      ///< pause when tracking is lost
    run_to_start,     ///< pause when the two-view start succeeded
    reset,            ///< start again at the first frame with an empty map
    set_parameter,    ///< key, value; takes effect at the next frame (or reset: see ParameterView)
    set_speed,        ///< value: frames per second, "0" = as fast as possible
  };
  Kind kind = Kind::step;
  int frame = -1;
  std::string key, value;
};

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

class Runner {
 public:
  virtual ~Runner() = default;

  virtual void send(const Command& command) = 0;
  /// Synchronous runner: does pending work, one frame at most; true if a frame was processed.
  /// Threaded runner: returns false at once, work happens elsewhere.
  virtual bool pump() = 0;

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
