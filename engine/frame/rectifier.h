// SPDX-License-Identifier: MIT
// Takes the lens distortion out of the images: behind it, everything works on a Pinhole.
#pragma once

#include <opencv2/core/mat.hpp>

#include "engine/geometry/camera.h"

namespace svoscope {

/// Rectified images have the size of the originals. The new focal length and centre are chosen so
/// that every rectified pixel lies inside the original image (no black borders), with the aspect
/// of the pixels kept; the focal length is never below half the original, which bounds the loss of
/// resolution of wide lenses. The camera frame does not turn: depths along z stay as they are.
class Rectifier {
 public:
  /// The camera must have passed Camera::check().
  explicit Rectifier(const Camera& camera);

  /// Camera of the rectified images; the input pinhole if there is no distortion.
  const Pinhole& pinhole() const { return pinhole_; }
  /// True if images are passed through unchanged.
  bool identity() const { return identity_; }
  /// CV_8UC1 of the camera's size, bilinear. Without distortion: the same matrix, not a copy.
  cv::Mat rectify(const cv::Mat& gray) const;
  /// CV_32FC1, nearest neighbour: depths of two surfaces are never mixed.
  cv::Mat rectifyDepth(const cv::Mat& depth) const;

 private:
  void buildMaps(const Camera& camera);

  Pinhole pinhole_;
  bool identity_ = true;
  cv::Mat map_xy_, map_fraction_;  ///< fixed-point maps of cv::remap
};

/// The pinhole that Rectifier chooses for a distorted camera.
Pinhole rectifiedPinhole(const Camera& camera);

}  // namespace svoscope
