// SPDX-License-Identifier: MIT
// Finding a first map: the start of a run, and a start beside relocalisation while the camera may
// be where the map has never been.
#pragma once

#include <memory>
#include <optional>

#include "engine/tracking/frame.h"
#include "engine/tracking/initializer.h"

namespace svoscope {

class Start {
 public:
  Start(const Pinhole& camera, const InitializerParameters& parameters);

  /// The next frame of a run that has no map yet.
  const InitializerOutput& process(const Frame& frame);
  /// The next frame while lost: a second start runs in the background. A value once it succeeds.
  std::optional<InitializerOutput> processBeside(const Frame& frame,
                                                 const InitializerParameters& parameters);
  /// Gives up the start beside: the camera has come back, or was lost anew.
  void stopBeside() { beside_.reset(); }
  /// The start that became the map, for display.
  void keep(InitializerOutput output) { output_ = std::move(output); }
  const InitializerOutput& output() const { return output_; }

 private:
  Pinhole camera_;
  Initializer initializer_;
  std::unique_ptr<Initializer> beside_;
  InitializerOutput output_;  ///< of the last frame without a map, then of the start that led to it
};

/// T_cur_last of the start's last two frames; no motion if they do not follow each other.
SE3 startVelocity(const InitializerOutput& start);

}  // namespace svoscope
