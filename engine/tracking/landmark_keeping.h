// SPDX-License-Identifier: MIT
// Landmarks, points and segments, between their making and their end: tried in every frame, refined
// from their views, observed by new keyframes, and made of seeds whose depth is known.
#pragma once

#include "engine/tracking/registration.h"

namespace svoscope {

/// Counts which landmarks the registered frame confirmed; those that fail too often go. Only frames
/// with a pose count: while lost, the map is not to blame for what it does not match.
void countTries(const Registration& registration, const Frame& frame,
                const TrackerParameters& parameters, Map& map);

/// Refines the landmarks that the frame saw; its features and segments follow.
void refinePoints(int iterations, Map& map, Frame& frame);
void refineSegments(double line_noise_px, int iterations, Map& map, Frame& frame);

/// The keyframe made of the frame observes its inliers. Seeds become landmarks: of a point at once,
/// of a segment if its depth is known.
void promotePoints(Map& map, Frame& frame, Keyframe& keyframe);
void promoteSegments(const MappingParameters& parameters, Map& map, Frame& frame,
                     Keyframe& keyframe);

/// What was removed from the map together with a keyframe is no inlier of the frame any more.
void disownGone(const Map& map, int keyframe_id, Frame& frame);

}  // namespace svoscope
