// SPDX-License-Identifier: MIT
// Who wants every frame of a run, whatever the history keeps: a recorder. Called by the thread that
// tracks; what is handed over is immutable. A call may wait, and then slows the run.
#pragma once

#include <vector>

#include "engine/runner/runner.h"

namespace svoscope {

class RunObserver {
 public:
  virtual ~RunObserver() = default;

  /// Once, before anything else.
  virtual void begin(const RunInfo& info) = 0;
  /// Before the first frame, and whenever a parameter was set: values from the frame `from` on.
  virtual void parameters(const std::vector<ParameterView>& parameters, int from) = 0;
  /// A processed frame with its record and events.
  virtual void frame(const SnapshotPtr& snapshot) = 0;
  /// An event that belongs to no snapshot: the end of the sequence, a parameter that was refused.
  virtual void note(const Event& event) = 0;
  /// The run starts again at the first frame; all that came before is void.
  virtual void reset() = 0;
};

}  // namespace svoscope
