// SPDX-License-Identifier: MIT
// The words behind "synthetic:": preset and options.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "engine/base/result.h"

namespace svoscope {

/// "synthetic:room?frames=100&noise=2": defaults are those of every preset unless the preset says
/// otherwise.
struct SyntheticSpec {
  std::string text;    ///< as given; the name of the sequence
  std::string preset;  ///< "room"
  int frames = 300;
  double rate_hz = 30;      ///< 10 for `forward`; not an option
  double noise = 1.5;       ///< standard deviation of the image noise, grey levels
  double blur = 0;          ///< exposure as a fraction of the frame interval, 0..1
  double step = 1;          ///< illumination steps by exactly this ratio, every 25 frames
  double light = 0;         ///< illumination steps: ratio up to 1.3^light, every 25 frames
  double occlude = 0;       ///< fraction of the image covered by a moving object, 0..0.9
  int movers = 0;           ///< boxes that move through the scene on their own
  double texture = 1;       ///< contrast of all surfaces, 0..1
  double travel = 1;        ///< what is left of the camera's translation, 0..1
  double speed = 1;         ///< motion of the camera is this many times as fast
  std::uint64_t seed = 1;   ///< textures, layout and noise
  int blackout_first = -1;  ///< first black frame
  int blackout_count = 0;
  int width = 640, height = 480;  ///< px; the focal length scales with the width
};

struct NamedText {
  std::string name, text;
};

/// Presets and options with a line of description each, for help texts and menus.
const std::vector<NamedText>& syntheticPresets();
const std::vector<NamedText>& syntheticOptions();

/// Unknown presets and options are usage errors that list the known ones, values out of range name
/// the range.
Result<SyntheticSpec> parseSyntheticSpec(const std::string& text);

}  // namespace svoscope
