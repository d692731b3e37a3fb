// SPDX-License-Identifier: MIT
// A sequence of image files: what TUM, ASL, KITTI and plain folders have in common.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "engine/dataset/sequence.h"

namespace svoscope {

struct ImageEntry {
  double timestamp = 0;         ///< s
  std::filesystem::path image;  ///< colour images are converted to grey on reading
  std::filesystem::path depth;  ///< 16-bit PNG; empty if the frame has none
};

/// Everything a loader finds out about its folder.
struct ImageList {
  std::string name;
  Camera camera;
  std::string camera_source;  ///< file or preset the resolution comes from, for messages
  std::vector<ImageEntry> entries;
  double depth_scale = 5000;  ///< grey levels of the depth images per metre
  Trajectory truth;
  TimeSource times = TimeSource::listed;
  std::vector<std::string> notes;  ///< Sequence::notes()
};

class ListSequence : public Sequence {
 public:
  /// Checks that there are entries and reads the first readable image of the first few; its size
  /// must be the camera's. Input error naming the file otherwise.
  static Result<std::unique_ptr<Sequence>> open(ImageList list);

  const std::string& name() const override { return list_.name; }
  int size() const override { return static_cast<int>(list_.entries.size()); }
  const Camera& camera() const override { return list_.camera; }
  double timestamp(int index) const override { return list_.entries.at(index).timestamp; }
  TimeSource timeSource() const override { return list_.times; }
  std::vector<std::string> notes() const override { return list_.notes; }
  Result<SequenceImage> read(int index) override;
  const Trajectory& groundTruth() const override { return list_.truth; }
  Result<cv::Mat> readDepth(int index) override;

 private:
  explicit ListSequence(ImageList list) : list_(std::move(list)) {}
  /// Sixteen-bit images with the one scale of the sequence, chosen by its first image.
  cv::Mat toEightBits(const cv::Mat& image);

  ImageList list_;
  /// Whether the images' EXIF orientation is applied: if the calibration is for turned images.
  void judgeOrientation(const std::filesystem::path& file);

  bool stored_orientation_ = false;  ///< pixels as stored, whatever the EXIF tag says
  double sixteen_bit_scale_ = 0;     ///< 0: no such image yet
};

/// Decodes an image file; `flags` as for cv::imread. The error tells a missing from an empty, a
/// truncated and an undecodable file. (cv::imread returns truncated JPEGs as if they were whole.)
Result<cv::Mat> readImageFile(const std::filesystem::path& file, int flags);

/// The bytes of an image file; the error tells a missing from an empty and a truncated file.
Result<std::string> readImageBytes(const std::filesystem::path& file);

/// The image files of a folder, "img2.png" before "img10.png". Empty if there are none.
std::vector<std::filesystem::path> sortedImages(const std::filesystem::path& folder);

/// Last part of a path, also for "data/room/" and ".".
std::string folderName(const std::filesystem::path& folder);

/// Frame rate of increasing time stamps: one over their median step, Hz; 0 if there are fewer
/// than two.
double medianRate(const std::vector<ImageEntry>& entries);

}  // namespace svoscope
