// SPDX-License-Identifier: MIT
// Calibration files: Kalibr camchain (camera.yaml) and ASL sensor.yaml.
#pragma once

#include <filesystem>

#include "engine/base/result.h"
#include "engine/geometry/camera.h"
#include "engine/geometry/se3.h"

namespace svoscope {

/// The camera of a calibration file in any known layout (calibration/calibration.h), without notes.
Result<Camera> readCameraFile(const std::filesystem::path& file);

struct MountedCamera {
  Camera camera;
  SE3 T_body_cam;  ///< T_BS of the file, m; identity if absent
};

/// ASL sensor.yaml of a camera. Errors as above, and a T_BS that is not a rigid motion.
Result<MountedCamera> readSensorFile(const std::filesystem::path& file);

/// Writes a Kalibr camchain that readCameraFile reads back exactly. Output error if impossible.
Status writeCameraFile(const Camera& camera, const std::filesystem::path& file);

}  // namespace svoscope
