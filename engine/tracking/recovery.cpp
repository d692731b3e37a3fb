// SPDX-License-Identifier: MIT
#include "engine/tracking/recovery.h"

#include <fmt/format.h>

namespace svoscope {

namespace {

/// Where candidates are tried, and the result so far.
struct Trial {
  const Frame& frame;
  const Map& map;
  double usual_noise_px;
  const TrackerParameters& parameters;
  Recovery::Result result;

  /// Takes the first candidate that the map confirms.
  bool tryAll(const std::vector<RelocalizationCandidate>& candidates, const char* by) {
    for (const RelocalizationCandidate& c : candidates) {
      Registration r = relocalizeFrame(frame, map, c.T_cam_world, usual_noise_px, parameters);
      result.found = r.good();
      result.text = result.found
                        ? fmt::format("keyframe {} by {}", c.keyframe_id, by)
                        : fmt::format("keyframe {} by {}: {}", c.keyframe_id, by, r.failure);
      StageTimes times = result.registration.time_ms;
      addTimes(r.time_ms, times);
      if (r.judged) result.registration = std::move(r);
      result.registration.time_ms = times;
      if (result.found) return true;
    }
    return false;
  }
};

}  // namespace

Recovery::Result Recovery::find(const Frame& frame, const Map& map, double usual_noise_px,
                                const TrackerParameters& p) {
  ++lost_frames_;
  places_.keepOnly(map);
  Trial trial{frame, map, usual_noise_px, p, {}};
  trial.result.text = "no keyframe looks like this frame";
  // Alignment first: it is exact where it converges. Descriptors reach further.
  trial.tryAll(relocalizationCandidates(map, *frame.pyramid, p.alignment, p.relocalize),
               "alignment") ||
      trial.tryAll(matchPlaces(map, *frame.pyramid, places_, p.relocalize), "descriptors");
  return std::move(trial.result);
}

bool Recovery::impatient(const Map& map, const QualityParameters& q) const {
  const bool fresh = static_cast<int>(map.keyframes.size()) <= q.fresh_map_keyframes;
  return lost_frames_ > (fresh ? q.fresh_lost_frames : q.lost_frames);
}

}  // namespace svoscope
