// SPDX-License-Identifier: MIT
#include <cmath>
#include <opencv2/core/utils/logger.hpp>
#include <opencv2/imgproc.hpp>
#include <opencv2/videoio.hpp>

#include "engine/dataset/camera_file.h"
#include "engine/dataset/loader.h"

namespace svoscope {
namespace {

namespace fs = std::filesystem;

const char* const kLayout = "a video needs its calibration beside it: NAME.yaml or camera.yaml";

/// OpenCV tries one decoder after the other and complains about each that fails.
bool openQuietly(cv::VideoCapture& capture, const fs::path& file) {
  const auto level = cv::utils::logging::setLogLevel(cv::utils::logging::LOG_LEVEL_SILENT);
  const bool opened = capture.open(file.string());
  cv::utils::logging::setLogLevel(level);
  return opened;
}

class VideoSequence : public Sequence {
 public:
  VideoSequence(fs::path file, Camera camera)
      : file_(std::move(file)), name_(file_.filename().string()), camera_(std::move(camera)) {}

  /// Opens the video and finds out its length and rate.
  Status open();

  const std::string& name() const override { return name_; }
  int size() const override { return frames_; }
  const Camera& camera() const override { return camera_; }
  double timestamp(int index) const override { return index / rate_; }
  Result<SequenceImage> read(int index) override;
  const Trajectory& groundTruth() const override { return truth_; }
  Result<cv::Mat> readDepth(int) override { return cv::Mat(); }

 private:
  Status seek(int index);
  int countFrames();

  fs::path file_;
  std::string name_;
  Camera camera_;
  cv::VideoCapture capture_;
  cv::Mat last_;  ///< grey image of frame next_ - 1, empty if not decoded
  int next_ = 0;  ///< frame that the next grab() yields
  int frames_ = 0;
  double rate_ = 30;  ///< Hz
  Trajectory truth_;
};

Status VideoSequence::open() {
  if (!openQuietly(capture_, file_))
    return inputError("the video cannot be opened", file_.string(),
                      "sequences are folders or videos that OpenCV can decode");
  const double container_rate = capture_.get(cv::CAP_PROP_FPS);
  const bool usable = std::isfinite(container_rate) && container_rate > 0;
  if (camera_.rate_hz > 0)
    rate_ = camera_.rate_hz;
  else if (usable)
    rate_ = container_rate;
  camera_.rate_hz = rate_;
  frames_ = static_cast<int>(capture_.get(cv::CAP_PROP_FRAME_COUNT));
  if (frames_ <= 0) frames_ = countFrames();  // streams without an index
  if (frames_ <= 0)
    return inputError("the video has no frames", file_.string(), "record or convert it again");
  const auto first = read(0);
  if (!first) return first.error();
  return Done{};
}

int VideoSequence::countFrames() {
  int n = 0;
  while (capture_.grab()) ++n;
  next_ = n;
  return n;
}

Status VideoSequence::seek(int index) {
  // Positioning by frame number is inexact in many containers: decode up to the frame instead.
  if (index < next_) {
    capture_.release();
    next_ = 0;
    if (!openQuietly(capture_, file_))
      return inputError("the video cannot be opened again", file_.string(),
                        "check that the file is still there");
  }
  for (; next_ < index; ++next_)
    if (!capture_.grab())
      return inputError("the video ends at frame " + std::to_string(next_), file_.string(),
                        "convert the video again: its header promises more");
  return Done{};
}

Result<SequenceImage> VideoSequence::read(int index) {
  if (index + 1 == next_ && !last_.empty()) return SequenceImage{index, timestamp(index), last_};
  last_.release();
  const Status found = seek(index);
  if (!found) return found.error();
  cv::Mat frame;
  if (!capture_.read(frame) || frame.empty())
    return inputError("frame " + std::to_string(index) + " cannot be decoded", file_.string(),
                      "convert the video again");
  ++next_;
  cv::Mat gray;
  if (frame.channels() == 1)
    gray = frame.clone();
  else
    cv::cvtColor(frame, gray, cv::COLOR_BGR2GRAY);
  const Pinhole& p = camera_.pinhole;
  if (gray.cols != p.width || gray.rows != p.height)
    return inputError("the video is " + std::to_string(gray.cols) + " x " +
                          std::to_string(gray.rows) + " pixels, but its calibration says " +
                          std::to_string(p.width) + " x " + std::to_string(p.height),
                      file_.string(), "use the calibration that belongs to this video");
  last_ = gray;
  return SequenceImage{index, timestamp(index), gray};
}

bool isFile(const fs::path&) { return true; }  // what it is, opening finds out

OpenedSequence openFile(const fs::path& file) {
  fs::path calibration = file;
  calibration.replace_extension(".yaml");
  if (!fs::exists(calibration)) calibration = file.parent_path() / "camera.yaml";
  const auto camera = readCameraFile(calibration);
  if (!camera) {
    Error error = camera.error();
    if (!fs::exists(calibration)) error.remedy = kLayout;
    return error;
  }
  auto sequence = std::make_unique<VideoSequence>(file, camera.value());
  const Status opened = sequence->open();
  if (!opened) return opened.error();
  return std::unique_ptr<Sequence>(std::move(sequence));
}

}  // namespace

/// A video with NAME.yaml or camera.yaml beside it. Reading forward is fast, backward reopens.
Loader videoLoader() {
  return {Loader::Takes::file, "a video with its calibration beside", isFile, openFile};
}

}  // namespace svoscope
