// SPDX-License-Identifier: MIT
#include "engine/dataset/write_tum.h"

#include <fmt/format.h>

#include <cstdio>
#include <fstream>
#include <opencv2/imgcodecs.hpp>

#include "engine/dataset/camera_file.h"

namespace svoscope {
namespace {

namespace fs = std::filesystem;

const double kDepthScale = 5000;  ///< grey levels per metre; 65535 is 13.1 m

Error cannotWrite(const fs::path& file) {
  return outputError("the file cannot be written", file.string(),
                     "check that the folder is writable and has space left");
}

Status writeImage(const fs::path& file, const cv::Mat& image) {
  // Light compression: rendered noise does not compress anyway.
  const std::vector<int> parameters = {cv::IMWRITE_PNG_COMPRESSION, 1};
  try {
    if (cv::imwrite(file.string(), image, parameters)) return Done{};
  } catch (const cv::Exception&) {
  }
  return cannotWrite(file);
}

/// Metres to 16 bit; what is too far for the format becomes 0, unknown.
cv::Mat encodeDepth(const cv::Mat& depth) {
  cv::Mat encoded(depth.size(), CV_16UC1);
  for (int y = 0; y < depth.rows; ++y) {
    const float* in = depth.ptr<float>(y);
    auto* out = encoded.ptr<std::uint16_t>(y);
    for (int x = 0; x < depth.cols; ++x) {
      const double value = kDepthScale * in[x] + 0.5;
      out[x] = value > 0 && value < 65536 ? static_cast<std::uint16_t>(value) : 0;
    }
  }
  return encoded;
}

Status writeTruth(const Trajectory& truth, const fs::path& file) {
  std::ofstream out(file);
  out << "# timestamp tx ty tz qx qy qz qw, camera to world (x right, y down, z forward)\n";
  for (const StampedPose& pose : truth) {
    const Vec3& t = pose.T_world_cam.translation();
    const auto& q = pose.T_world_cam.quaternion();
    out << fmt::format("{:.6f}", pose.timestamp);
    for (double v : {t.x(), t.y(), t.z(), q.x(), q.y(), q.z(), q.w()})
      out << fmt::format(" {:.9g}", v);
    out << '\n';
  }
  if (!out.flush()) return cannotWrite(file);
  return Done{};
}

/// The two lists of files, written line by line.
struct Lists {
  explicit Lists(const fs::path& folder)
      : images(folder / "rgb.txt"), depths(folder / "depth.txt") {
    images << "# timestamp filename\n";
    depths << "# timestamp filename\n";
  }
  std::ofstream images, depths;
  bool any_depth = false;
};

Status writeFrame(Sequence& sequence, int index, const fs::path& folder, Lists& lists) {
  const auto frame = sequence.read(index);
  if (!frame) return frame.error();
  const std::string stamp = fmt::format("{:.6f}", frame.value().timestamp);
  const std::string image = "rgb/" + stamp + ".png", depth_image = "depth/" + stamp + ".png";
  const Status written = writeImage(folder / image, frame.value().gray);
  if (!written) return written;
  lists.images << stamp << ' ' << image << '\n';
  const auto depth = sequence.readDepth(index);
  if (!depth) return depth.error();
  if (depth.value().empty()) return Done{};
  lists.any_depth = true;
  lists.depths << stamp << ' ' << depth_image << '\n';
  return writeImage(folder / depth_image, encodeDepth(depth.value()));
}

Status closeLists(Lists& lists, const fs::path& folder) {
  if (!lists.images.flush()) return cannotWrite(folder / "rgb.txt");
  if (!lists.depths.flush()) return cannotWrite(folder / "depth.txt");
  if (lists.any_depth) return Done{};
  lists.depths.close();
  std::error_code ec;
  fs::remove(folder / "depth.txt", ec);
  fs::remove(folder / "depth", ec);
  return Done{};
}

}  // namespace

Status writeTumSequence(Sequence& sequence, const fs::path& out, const WriteProgress& progress) {
  std::error_code ec;
  fs::create_directories(out / "rgb", ec);
  if (!ec) fs::create_directories(out / "depth", ec);
  if (ec) return cannotWrite(out);
  const Status calibrated = writeCameraFile(sequence.camera(), out / "camera.yaml");
  if (!calibrated) return calibrated;
  if (!sequence.groundTruth().empty()) {
    const Status truth = writeTruth(sequence.groundTruth(), out / "groundtruth.txt");
    if (!truth) return truth;
  }
  Lists lists(out);
  for (int i = 0; i < sequence.size(); ++i) {
    const Status written = writeFrame(sequence, i, out, lists);
    if (!written) return written;
    if (progress && !progress(i + 1, sequence.size())) break;
  }
  return closeLists(lists, out);
}

}  // namespace svoscope
