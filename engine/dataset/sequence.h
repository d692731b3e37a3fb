// SPDX-License-Identifier: MIT
// An image sequence with calibration and, where known, ground truth.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <opencv2/core/mat.hpp>
#include <string>
#include <vector>

#include "engine/base/result.h"
#include "engine/geometry/camera.h"
#include "engine/geometry/trajectory.h"

namespace svoscope {

struct SequenceImage {
  int index = 0;         ///< position in the sequence, from 0
  double timestamp = 0;  ///< s
  cv::Mat gray;          ///< CV_8UC1, as on disk (distorted)
};

/// Where the times of the images come from.
enum class TimeSource : std::uint8_t {
  listed,      ///< a list of times, or rendered
  file_names,  ///< the names of the images are time stamps
  container,   ///< a video's time of each frame
  rate,        ///< counted with a frame rate that the user or the calibration gives
  assumed,     ///< counted with 30 Hz, as nothing is known: no error over time can be trusted
};
const char* timeSourceName(TimeSource source);
constexpr double kAssumedRate = 30;  ///< Hz

class Sequence {
 public:
  virtual ~Sequence() = default;

  virtual const std::string& name() const = 0;  ///< short: "kitti_00", "synthetic:room"
  virtual int size() const = 0;                 ///< frames
  virtual const Camera& camera() const = 0;
  virtual double timestamp(int index) const = 0;  ///< s
  virtual TimeSource timeSource() const { return TimeSource::listed; }
  /// What was assumed, converted or passed over when it was opened, one line each: to be said once.
  virtual std::vector<std::string> notes() const { return {}; }
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

/// What the user says of a sequence, in place of what its files say.
struct OpenOptions {
  std::filesystem::path camera;  ///< calibration file; empty: the sequence's own
  double rate_hz = 0;            ///< of images without times; 0: unknown
};

/// Opens "synthetic:PRESET", a folder (TUM RGB-D, EuRoC/ASL, KITTI odometry, TUM-mono / DSO, images
/// with a calibration) or a video file with its calibration beside it. The layout is recognised;
/// the error names the file that is missing and the layout expected.
Result<std::unique_ptr<Sequence>> openSequence(const std::string& spec,
                                               const OpenOptions& options = {});

}  // namespace svoscope
