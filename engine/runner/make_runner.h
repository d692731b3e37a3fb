// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>

#include "engine/dataset/sequence.h"
#include "engine/runner/parameters.h"
#include "engine/runner/run_observer.h"

namespace svoscope {

struct RunnerOptions {
  std::string method = "svo";  ///< id of engine/base/methods.h
  bool threaded = true;
  int start = 0;        ///< first frame
  int max_frames = -1;  ///< -1: to the end
  Parameters parameters;
  std::size_t history_budget = 512u << 20;  ///< bytes of snapshots kept
  /// Off: rows and events only, and a snapshot whenever the run pauses or ends; for runs without
  /// a viewer.
  bool publish_snapshots = true;
  /// Off: seeds of snapshots lack what follows from belief and poses (snapshot/seed_placement.h);
  /// enough for a recorder.
  bool place_seeds = true;
  std::shared_ptr<RunObserver>
      observer;  ///< sees every frame; wants publish_snapshots. May be null
};

/// Sets what a method decides: rule of the depth filter, segments. Usage error if it is unknown.
Status applyMethod(Parameters& parameters, const std::string& method);

/// Usage error for an unknown method, input error for an empty sequence.
Result<std::unique_ptr<Runner>> makeRunner(std::unique_ptr<Sequence> sequence,
                                           const RunnerOptions& options);

}  // namespace svoscope
