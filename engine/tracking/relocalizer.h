// SPDX-License-Identifier: MIT
// Finds the camera again after a loss: keyframes ranked by the look of a small blurred image, then
// aligned to and verified on the map by the caller.
#pragma once

#include <vector>

#include "engine/mapping/map.h"
#include "engine/tracking/sparse_alignment.h"

namespace svoscope {

struct RelocalizerParameters {
  int candidates = 4;  ///< keyframes tried per frame, each by alignment and by descriptors
  int places = 12;     ///< keyframes whose landmarks are matched by descriptors
  double min_similarity = 0.35;  ///< correlation of the small images, -1 .. 1
  int min_patches = 25;          ///< visible after alignment
};

/// Small image for ranking: about 40 px wide, blurred, zero mean and unit norm; CV_32F.
cv::Mat makeThumbnail(const Pyramid& pyramid);

struct RelocalizationCandidate {
  int keyframe_id = -1;
  double similarity = 0;
  SE3 T_cam_world;  ///< after alignment to the keyframe
};

/// Keyframes by similarity of their thumbnails to the image's, best first, at most `most`; poses
/// turned from the keyframe's as the thumbnails shift.
std::vector<RelocalizationCandidate> similarKeyframes(const Map& map, const Pyramid& pyramid,
                                                      int most, double min_similarity);

/// Keyframes similar to the image, each with an aligned pose, best first.
std::vector<RelocalizationCandidate> relocalizationCandidates(
    const Map& map, const Pyramid& pyramid, const SparseAlignmentParameters& alignment,
    const RelocalizerParameters& parameters);

/// T_cur_ref of the rotation that best turns one image into the other, found on their thumbnails:
/// coarse (half a thumbnail pixel, a degree), but from far away (ten degrees).
SE3 registeredRotation(const Pyramid& ref, const Pyramid& cur, const Pinhole& camera);

/// Patches of a keyframe's landmarks, segments and converged seeds, for aligning a frame to it.
std::vector<AlignmentPatch> keyframePatches(const Map& map, const Keyframe& keyframe);

}  // namespace svoscope
