// SPDX-License-Identifier: MIT
// The figures of a run; engine/io/metrics_writer.h writes them.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "engine/eval/evaluate.h"
#include "engine/snapshot/frame_record.h"

namespace svoscope {

struct StageTime {
  double median_ms = 0, p95_ms = 0;  ///< over the frames in which the stage ran
  int frames = 0;
};

struct SeedFigures {
  int converged = 0, rejected = 0;
  std::optional<double> updates_to_converge_median;
};

struct RunMetrics {
  std::string method;
  std::string times = "listed";   ///< where the times of the images come from; "assumed": no errors
  int frames = 0;                 ///< passed through the engine, unreadable ones included
  int maps = 0;                   ///< with a good pose; poses of different maps make no trajectory
  int tracked = 0;                ///< with a good pose in the map that has most of them
  std::optional<int> init_frame;  ///< sequence index of the first good pose of any map
  std::optional<double> tracked_fraction_after_init;
  std::optional<double> init_time_s;  ///< sequence time from the first frame to init_frame
  int keyframes = 0;
  int losses = 0;
  int relocalisations = 0;                      ///< losses that were mended
  std::optional<double> relocalisation_time_s;  ///< mean sequence time from loss to recovery
  std::optional<EvalResult> evaluation;
  std::string evaluation_note;  ///< why there is none
  std::array<StageTime, kStageCount> time_ms{};
  double fps = 0;  ///< frames / wall-clock time of the run, reading included
  int points = 0;  ///< in the map, without segment end points
  int segments = 0;
  SeedFigures seeds;  ///< of the method's rule
  double peak_rss_mb = 0;
};

/// Id of the filter rule of a method, "js"; of the first rule if there is no such method.
const char* seedRule(const std::string& method);

/// Fills what follows from the rows: all counts, fractions and times, but not fps, map, seeds'
/// updates or evaluation. `frames` is at least the number of rows.
RunMetrics metricsOfRecords(const std::vector<FrameRecord>& records, int frames);

}  // namespace svoscope
