// SPDX-License-Identifier: MIT
#pragma once

#include "engine/dataset/loader.h"

namespace svoscope {

/// Opens a video with NAME.yaml or another calibration beside it. Its times are those that the
/// container gives each frame, unless the user gives a rate. Reading forward is fast, backward
/// reopens.
OpenedSequence openVideo(const std::filesystem::path& file, const OpenOptions& options);

/// The name ends like that of a video (".mp4", ".avi", ...).
bool hasVideoName(const std::filesystem::path& file);

}  // namespace svoscope
