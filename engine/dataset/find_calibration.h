// SPDX-License-Identifier: MIT
// Which file of a folder is the calibration.
#pragma once

#include "engine/dataset/calibration/calibration.h"
#include "engine/dataset/sequence.h"

namespace svoscope {

struct FoundCalibration {
  Calibration calibration;
  std::filesystem::path file;
};

/// The file the user names; else camera.yaml or another usual name in the folder, in `dso/` or
/// `calibration/` below it or in the folder above; else the one file there that is a calibration.
/// Input error naming what was looked for, or the candidates if there are several.
Result<FoundCalibration> findCalibration(const std::filesystem::path& folder,
                                         const OpenOptions& options, ImageSize images = {});

/// Size of an image file, px; zero if it cannot be read.
ImageSize sizeOfImage(const std::filesystem::path& image);

}  // namespace svoscope
