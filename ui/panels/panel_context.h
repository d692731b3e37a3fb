// SPDX-License-Identifier: MIT
// What a panel sees: one snapshot for the whole UI frame, the run so far, and the user's state.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "engine/runner/runner.h"
#include "ui/model/run_cache.h"
#include "ui/model/runs.h"
#include "ui/model/selection_history.h"
#include "ui/model/truth.h"
#include "ui/model/ui_state.h"
#include "ui/render/graphics.h"

namespace svoscope::ui {

class CompareData;

/// Data derived from a run that lives longer than one UI frame.
struct PanelCaches {
  RunCache run;
  Truth truth;
  SelectionHistory selection;
  TypedStore own;  ///< of single panels
};

/// First and last frame that any run has; lo > hi if none has one.
Range framesOf(const std::vector<std::unique_ptr<PanelCaches>>& runs);

/// Sends a command that moves the run, and follows it. A recording goes on from the frame in view,
/// and plays from its first frame if that is the last.
void moveOn(Runner& runner, UiState& state, const Command& command);

/// With several runs open, all but `runs`, `all_caches` and `compare` is of the current one.
struct PanelContext {
  Runner& runner;      ///< for commands
  const RunView& run;  ///< to be read
  Graphics& graphics;
  UiState& state;
  PanelCaches& caches;
  const Runs& runs;
  std::vector<std::unique_ptr<PanelCaches>>& all_caches;
  CompareData& compare;
  const RunInfo& info;
  RunnerStatus status;
  SnapshotPtr latest;                   ///< null before the first frame
  SnapshotPtr snapshot;                 ///< of the viewed frame; null if none or no longer held
  const FrameRecord* record = nullptr;  ///< of the viewed frame; null before the first
  int newest = -1;                      ///< last frame that all runs have; -1 before the first
  std::string size_text;                ///< for the status bar: what renders

  /// Last frame that can be viewed: of a recording also what was played before and gone back from.
  int lastFrame() const {
    const auto& records = caches.run.records();
    return status.recorded && !records.empty() ? records.back().index : engineFrame();
  }

  /// What the user chose in a panel: a struct of the panel's own, made when first asked for.
  template <typename Options>
  Options& options() const {
    return state.options.get<Options>();
  }
  /// The same for a choice that makes sense for this run only; each run has its own.
  template <typename Options>
  Options& runOptions() const {
    return state.run_options.get<Options>();
  }
  /// What a panel derived from the current run and keeps from one UI frame to the next.
  template <typename Cache>
  Cache& cache() const {
    return caches.own.get<Cache>();
  }

  bool live() const { return state.viewed_frame < 0; }
  int engineFrame() const { return newest; }
  int viewedFrame() const { return live() ? engineFrame() : state.viewed_frame; }
  /// Shows a frame; the newest one means live.
  void view(int frame) const {
    if (status.recorded && frame > engineFrame()) return jump(frame);
    state.viewed_frame = frame < 0 || frame >= engineFrame() ? -1 : frame;
  }
  void send(Command::Kind kind, int frame = -1) const {
    Command command;
    command.kind = kind;
    command.frame = frame;
    moveOn(runner, state, command);
  }

 private:
  void jump(int frame) const {
    Command command;
    command.kind = Command::Kind::run_to_frame;
    command.frame = frame;
    runner.send(command);
    state.viewed_frame = -1;
  }
};

/// What a panel without a snapshot says; false if there is one.
bool saysWhyEmpty(const PanelContext& context);
/// Writes text into the output folder and says so.
void exportText(PanelContext& context, const std::string& name, const std::string& text);
/// "kitti_00_it-svo": first part of the names of exported files.
std::string runName(const RunInfo& info);

}  // namespace svoscope::ui
