// SPDX-License-Identifier: MIT
// Recognising a place by descriptors: where the view is too far from every keyframe for image
// alignment to converge, ORB descriptors (Rublee et al., ICCV 2011) of the keyframes' landmarks are
// matched in the image and give the pose by PnP. Only for relocalisation: nothing is computed while
// tracking goes well.
#pragma once

#include <cstdint>
#include <map>
#include <opencv2/core/mat.hpp>
#include <vector>

#include "engine/mapping/map.h"
#include "engine/tracking/relocalizer.h"

namespace svoscope {

/// Descriptors of the corner landmarks seen in one keyframe.
struct PlaceDescriptors {
  cv::Mat descriptors;                  ///< CV_8U, a row each
  std::vector<std::int64_t> landmarks;  ///< of the rows
};

/// Made when first asked for, kept by keyframe.
class PlaceIndex {
 public:
  const PlaceDescriptors& of(const Map& map, const Keyframe& keyframe);
  /// Forgets those of keyframes that are gone.
  void keepOnly(const Map& map);

 private:
  std::map<int, PlaceDescriptors> places_;
};

/// Poses at which landmarks of the keyframes most alike appear where they are matched, best
/// supported first. `similarity` is that of the thumbnails.
std::vector<RelocalizationCandidate> matchPlaces(const Map& map, const Pyramid& pyramid,
                                                 PlaceIndex& index,
                                                 const RelocalizerParameters& parameters);

}  // namespace svoscope
