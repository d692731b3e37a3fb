// SPDX-License-Identifier: MIT
#include "engine/dataset/video_sequence.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <opencv2/core/utils/logger.hpp>
#include <opencv2/imgproc.hpp>
#include <opencv2/videoio.hpp>

#include "engine/dataset/find_calibration.h"

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
  VideoSequence(fs::path file, Calibration calibration, double user_rate_hz)
      : file_(std::move(file)),
        name_(file_.filename().string()),
        camera_(std::move(calibration.camera)),
        user_rate_hz_(user_rate_hz),
        notes_(std::move(calibration.notes)) {}

  /// Opens the video and finds out its length and rate.
  Status open();

  const std::string& name() const override { return name_; }
  int size() const override { return frames_; }
  const Camera& camera() const override { return camera_; }
  double timestamp(int index) const override;
  TimeSource timeSource() const override { return times_from_; }
  std::vector<std::string> notes() const override { return notes_; }
  Result<SequenceImage> read(int index) override;
  const Trajectory& groundTruth() const override { return truth_; }
  Result<cv::Mat> readDepth(int) override { return cv::Mat(); }

 private:
  Status seek(int index);
  int countFrames();
  void chooseTimes();
  /// After each grab: notes the container's time of the frame.
  void noteTime(int index);

  fs::path file_;
  std::string name_;
  Camera camera_;
  cv::VideoCapture capture_;
  cv::Mat last_;  ///< grey image of frame next_ - 1, empty if not decoded
  int next_ = 0;  ///< frame that the next grab() yields
  int frames_ = 0;
  double rate_ = kAssumedRate;  ///< Hz
  double user_rate_hz_ = 0;
  TimeSource times_from_ = TimeSource::assumed;
  std::vector<double> times_;  ///< s, the container's, of the frames decoded so far
  std::vector<std::string> notes_;
  Trajectory truth_;
};

Status VideoSequence::open() {
  if (!openQuietly(capture_, file_))
    return inputError("the video cannot be opened", file_.string(),
                      "sequences are folders or videos that OpenCV can decode");
  const double turned = capture_.get(cv::CAP_PROP_ORIENTATION_META);
  if (turned != 0)
    notes_.push_back(fmt::format("the video's rotation tag ({:.0f} degrees) is applied", turned));
  frames_ = static_cast<int>(capture_.get(cv::CAP_PROP_FRAME_COUNT));
  if (frames_ <= 0) frames_ = countFrames();  // streams without an index
  if (frames_ <= 0)
    return inputError("the video has no frames", file_.string(), "record or convert it again");
  for (int i = std::min(2, frames_ - 1); i >= 0; --i) {
    const auto frame = read(i);
    if (i == 0 && !frame) return frame.error();
  }
  chooseTimes();
  return Done{};
}

/// The user's rate counts most, then the container's time of each frame, then its rate. A phone's
/// frames are not evenly spaced, and what a calibration says of the rate is of another recording.
void VideoSequence::chooseTimes() {
  const double container_rate = capture_.get(cv::CAP_PROP_FPS);
  const bool usable = std::isfinite(container_rate) && container_rate > 0 && container_rate < 1e4;
  const bool timed = times_.size() >= 2 && times_[1] > times_[0];
  if (user_rate_hz_ > 0) {
    times_from_ = TimeSource::rate;
    rate_ = user_rate_hz_;
  } else if (timed || usable) {
    times_from_ = timed ? TimeSource::container : TimeSource::rate;
    rate_ = usable ? container_rate : 1 / (times_[1] - times_[0]);
    if (camera_.rate_hz > 0 && std::abs(camera_.rate_hz / rate_ - 1) > 0.1)
      notes_.push_back(
          fmt::format("the calibration says {:.4g} Hz, the video {:.4g} Hz: the times "
                      "of the video are used",
                      camera_.rate_hz, rate_));
  } else {
    times_from_ = camera_.rate_hz > 0 ? TimeSource::rate : TimeSource::assumed;
    rate_ = camera_.rate_hz > 0 ? camera_.rate_hz : kAssumedRate;
  }
  if (times_from_ == TimeSource::assumed)
    notes_.push_back(
        "the times of the frames are unknown: 30 Hz is assumed, and no error over time "
        "is computed; give the rate with --rate HZ");
  camera_.rate_hz = rate_;
}

/// Of frames that were not decoded yet, what follows from the last one that was.
double VideoSequence::timestamp(int index) const {
  if (times_from_ != TimeSource::container || times_.empty()) return index / rate_;
  const int known = static_cast<int>(times_.size());
  if (index < known) return times_[static_cast<std::size_t>(index)];
  return times_.back() + (index - known + 1) / rate_;
}

void VideoSequence::noteTime(int index) {
  if (index != static_cast<int>(times_.size())) return;
  const double seconds = 1e-3 * capture_.get(cv::CAP_PROP_POS_MSEC);
  const bool later = times_.empty() || seconds > times_.back();
  // A container that repeats or forgets a time must not make time stand still.
  times_.push_back(later || times_.size() < 2
                       ? seconds
                       : times_.back() + (times_.back() - times_[times_.size() - 2]));
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
  for (; next_ < index; ++next_) {
    if (!capture_.grab())
      return inputError("the video ends at frame " + std::to_string(next_), file_.string(),
                        "convert the video again: its header promises more");
    noteTime(next_);
  }
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
  noteTime(index);
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

/// NAME.yaml or NAME.txt beside the video, what the user names, or a calibration of the folder.
Result<FoundCalibration> findBeside(const fs::path& file, const OpenOptions& options) {
  OpenOptions chosen = options;
  for (const char* extension : {".yaml", ".yml", ".txt"}) {
    fs::path own = file;
    own.replace_extension(extension);
    if (chosen.camera.empty() && fs::exists(own)) chosen.camera = own;
  }
  auto found = findCalibration(file.parent_path(), chosen);
  if (found || !chosen.camera.empty()) return found;
  Error error = found.error();
  if (!fs::exists(file.parent_path() / "camera.yaml")) error.remedy = kLayout;
  return error;
}

bool isFile(const fs::path&) { return true; }  // what it is, opening finds out

OpenedSequence openFile(const fs::path& file, const OpenOptions& options) {
  const std::string extension = file.extension().string();
  if (extension == ".txt" || extension == ".csv" || extension == ".yaml")
    return inputError("a text file is no sequence", file.string(),
                      "give the folder that holds it and the images");
  if (extension == ".bag" || extension == ".db3" || extension == ".mcap")
    return inputError(
        "bags are not read", file.string(),
        "write the images of the camera's topic into a folder, named by their time in "
        "nanoseconds, with camera.yaml beside");
  return openVideo(file, options);
}

}  // namespace

bool hasVideoName(const fs::path& file) {
  std::string extension = file.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  for (const char* known : {".mp4", ".avi", ".mov", ".mkv", ".webm", ".m4v", ".mpg", ".mpeg"}) {
    if (extension == known) return true;
  }
  return false;
}

OpenedSequence openVideo(const fs::path& file, const OpenOptions& options) {
  auto found = findBeside(file, options);
  if (!found) return found.error();
  auto sequence =
      std::make_unique<VideoSequence>(file, std::move(found.value().calibration), options.rate_hz);
  const Status opened = sequence->open();
  if (!opened) return opened.error();
  return std::unique_ptr<Sequence>(std::move(sequence));
}

/// A video with NAME.yaml or camera.yaml beside it. Reading forward is fast, backward reopens.
Loader videoLoader() {
  return {Loader::Takes::file, "a video with its calibration beside", isFile, openFile};
}

}  // namespace svoscope
