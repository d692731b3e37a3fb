// SPDX-License-Identifier: MIT
// Finding the camera again after a loss: how long it has been lost, descriptors of places, and the
// candidates that are tried on the map.
#pragma once

#include <string>

#include "engine/tracking/place_matching.h"
#include "engine/tracking/registration.h"

namespace svoscope {

class Recovery {
 public:
  struct Result {
    bool found = false;
    std::string text;           ///< by which keyframe and how; or why not
    Registration registration;  ///< accepted if found, else the one judged last, if any; its times
                                ///< are those of all
  };

  /// Tracking was lost just now.
  void begin() { lost_frames_ = 0; }
  /// Tries the keyframes that look like the frame, the first that the map confirms is taken.
  Result find(const Frame& frame, const Map& map, double usual_noise_px,
              const TrackerParameters& parameters);
  /// Lost for so long that another start is looked for, sooner with a fresh map.
  bool impatient(const Map& map, const QualityParameters& quality) const;

  int lostFrames() const { return lost_frames_; }

 private:
  PlaceIndex places_;
  int lost_frames_ = 0;
};

}  // namespace svoscope
