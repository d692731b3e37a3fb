// SPDX-License-Identifier: MIT
// Rendered sequences with exact poses and depths: "synthetic:PRESET?option=value&...".
#pragma once

#include <memory>
#include <string>

#include "engine/dataset/sequence.h"
#include "engine/dataset/synthetic/spec.h"

namespace svoscope {

/// True if the text asks for a synthetic sequence: starts with "synthetic:".
bool isSyntheticSpec(const std::string& text);

/// Builds the scene; frames are rendered when they are read. The same text gives the same bytes,
/// in whatever order the frames are read. Usage errors list the known presets and options
/// (syntheticPresets(), syntheticOptions() in spec.h).
Result<std::unique_ptr<Sequence>> openSyntheticSequence(const std::string& text);

}  // namespace svoscope
