// SPDX-License-Identifier: MIT
#include "engine/dataset/image_times.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/base/stamps.h"

namespace svoscope {

namespace {

std::vector<double> counted(std::size_t frames, double rate_hz) {
  std::vector<double> seconds;
  for (std::size_t i = 0; i < frames; ++i) seconds.push_back(static_cast<double>(i) / rate_hz);
  return seconds;
}

}  // namespace

const char* timeSourceName(TimeSource source) {
  constexpr const char* kNames[] = {"listed", "file names", "container", "rate", "assumed"};
  return kNames[static_cast<int>(source)];
}

std::string rateContradiction(const std::vector<double>& seconds, double rate_hz,
                              const std::string& rate_source) {
  const double step = medianStep(seconds);
  if (!(step > 0) || !(rate_hz > 0) || std::abs(step * rate_hz - 1) < 0.1) return "";
  return fmt::format(
      "{} says {:.4g} Hz, but the images are {:.4g} ms apart ({:.4g} Hz): the times "
      "of the images are used",
      rate_source, rate_hz, 1e3 * step, 1 / step);
}

ImageTimes timesOfImages(const std::vector<std::filesystem::path>& images, const Camera& camera,
                         const OpenOptions& options) {
  std::vector<std::string> stems;
  for (const auto& image : images) stems.push_back(image.stem().string());
  ImageTimes times;
  if (options.rate_hz > 0) {
    times.source = TimeSource::rate;
    times.seconds = counted(images.size(), options.rate_hz);
    return times;
  }
  if (const auto stamps = stampsOfNames(stems)) {
    times.source = TimeSource::file_names;
    times.seconds = stamps->seconds;
    times.notes.push_back(fmt::format("the names of the images are taken as their times, in {}",
                                      stampUnitName(stamps->unit)));
    const std::string note = rateContradiction(times.seconds, camera.rate_hz, "the calibration");
    if (!note.empty()) times.notes.push_back(note);
    return times;
  }
  times.source = camera.rate_hz > 0 ? TimeSource::rate : TimeSource::assumed;
  times.seconds = counted(images.size(), camera.rate_hz > 0 ? camera.rate_hz : kAssumedRate);
  if (times.source == TimeSource::assumed) {
    times.notes.push_back(
        fmt::format("the times of the images are unknown: {:.0f} Hz is assumed, and no error over "
                    "time is computed; give the rate with --rate HZ",
                    kAssumedRate));
  }
  return times;
}

}  // namespace svoscope
