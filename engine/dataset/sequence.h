// SPDX-License-Identifier: MIT
// An image sequence with calibration and, where known, ground truth.
#pragma once

#include <memory>
#include <opencv2/core/mat.hpp>
#include <string>

#include "engine/base/result.h"
#include "engine/geometry/camera.h"
#include "engine/geometry/trajectory.h"

namespace svoscope {

struct SequenceImage {
  int index = 0;         ///< position in the sequence, from 0
  double timestamp = 0;  ///< s
  cv::Mat gray;          ///< CV_8UC1, as on disk (distorted)
};

class Sequence {
 public:
  virtual ~Sequence() = default;

  virtual const std::string& name() const = 0;  ///< short: "kitti_00", "synthetic:room"
  virtual int size() const = 0;                 ///< frames
  virtual const Camera& camera() const = 0;
  virtual double timestamp(int index) const = 0;  ///< s
  /// Reads frame `index`. Safe to call from one thread at a time. An unreadable, truncated or
  /// wrongly sized image is an input error that names the file; the caller may go on with
  /// the next frame.
  virtual Result<SequenceImage> read(int index) = 0;
  /// Camera poses in the world frame of the ground truth; empty if there is none.
  virtual const Trajectory& groundTruth() const = 0;
  /// True depth along the z axis, CV_32FC1, metres, 0 where unknown, at the (distorted) pixels of
  /// the image; an empty matrix where the frame has none. Used for display and evaluation only.
  virtual Result<cv::Mat> readDepth(int index) = 0;
};

/// Opens "synthetic:PRESET", a folder (TUM RGB-D, EuRoC/ASL, KITTI odometry, images with
/// camera.yaml) or a video file with camera.yaml beside it. The layout is recognised; the error
/// names the file that is missing and the layout expected.
Result<std::unique_ptr<Sequence>> openSequence(const std::string& spec);

}  // namespace svoscope
