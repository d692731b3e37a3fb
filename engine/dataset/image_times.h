// SPDX-License-Identifier: MIT
// Times of images that no list gives.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "engine/dataset/sequence.h"

namespace svoscope {

struct ImageTimes {
  TimeSource source = TimeSource::assumed;
  std::vector<double> seconds;     ///< one per image, increasing
  std::vector<std::string> notes;  ///< contradictions and assumptions
};

/// Images in order. Their names, if these are time stamps; else counted with the rate that the user
/// gives, or the calibration; else with kAssumedRate, which is said in a note.
ImageTimes timesOfImages(const std::vector<std::filesystem::path>& images, const Camera& camera,
                         const OpenOptions& options);

/// A note if a nominal rate is more than a tenth off the median step of the times; empty if not.
std::string rateContradiction(const std::vector<double>& seconds, double rate_hz,
                              const std::string& rate_source);

}  // namespace svoscope
