// SPDX-License-Identifier: MIT
// The optional ground truth of a sequence. It never keeps a sequence from opening: what is wrong
// with it becomes a note.
#pragma once

#include <filesystem>
#include <optional>

#include "engine/dataset/list_sequence.h"

namespace svoscope {

/// Reads `file`, if it is there, as poses of the camera, or of a body that carries it at
/// T_body_cam.
void attachTruth(const std::filesystem::path& file, const std::optional<SE3>& T_body_cam,
                 ImageList& list);

}  // namespace svoscope
