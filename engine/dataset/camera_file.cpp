// SPDX-License-Identifier: MIT
#include "engine/dataset/camera_file.h"

#include <fstream>
#include <iomanip>
#include <limits>

#include "engine/dataset/calibration/calibration.h"

namespace svoscope {

namespace fs = std::filesystem;

Result<MountedCamera> readSensorFile(const fs::path& file) {
  auto read = readCalibration(file);
  if (!read) return read.error();
  return MountedCamera{read.value().camera, read.value().T_body_cam};
}

Result<Camera> readCameraFile(const fs::path& file) {
  auto mounted = readSensorFile(file);
  if (!mounted) return mounted.error();
  return mounted.value().camera;
}

Status writeCameraFile(const Camera& camera, const fs::path& file) {
  std::ofstream out(file);
  out << std::setprecision(std::numeric_limits<double>::max_digits10);
  const Pinhole& p = camera.pinhole;
  out << "# Kalibr camchain layout; pixel centres at integer coordinates\n"
      << "cam0:\n  camera_model: pinhole\n  intrinsics: [" << p.fx << ", " << p.fy << ", " << p.cx
      << ", " << p.cy
      << "]  # fx, fy, cx, cy\n  distortion_model: " << distortionName(camera.distortion)
      << "\n  distortion_coeffs: [";
  for (size_t i = 0; i < camera.coefficients.size(); ++i)
    out << (i ? ", " : "") << camera.coefficients[i];
  out << "]\n  resolution: [" << p.width << ", " << p.height << "]\n";
  if (camera.rate_hz > 0) out << "  rate_hz: " << camera.rate_hz << "\n";
  if (!out.flush())
    return outputError("the file cannot be written", file.string(),
                       "check that the folder exists, is writable and has space left");
  return Done{};
}

}  // namespace svoscope
