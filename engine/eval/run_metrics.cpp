// SPDX-License-Identifier: MIT
#include "engine/eval/run_metrics.h"

#include <algorithm>
#include <cmath>

#include "engine/base/methods.h"
#include "engine/base/quantile.h"
#include "engine/eval/estimate.h"

namespace svoscope {

namespace {

/// Losses, and the mean sequence time until tracking was found again.
void countLosses(const std::vector<FrameRecord>& records, RunMetrics& metrics) {
  double total_s = 0, lost_since = 0;
  bool lost = false;
  for (const FrameRecord& record : records) {
    if (record.state == TrackingState::lost && !lost) {
      ++metrics.losses;
      lost_since = record.timestamp;
      lost = true;
    }
    if (record.relocalized) {
      ++metrics.relocalisations;
      total_s += lost ? record.timestamp - lost_since : 0;
    }
    if (record.state != TrackingState::lost) lost = false;
  }
  if (metrics.relocalisations > 0) {
    metrics.relocalisation_time_s = total_s / metrics.relocalisations;
  }
}

StageTime stageTime(const std::vector<FrameRecord>& records, Stage stage) {
  std::vector<double> values;
  for (const FrameRecord& record : records) {
    if (record.ms(stage) > 0) values.push_back(record.ms(stage));
  }
  return {interpolatedQuantile(values, 0.5).value_or(0),
          interpolatedQuantile(values, 0.95).value_or(0), static_cast<int>(values.size())};
}

}  // namespace

const char* seedRule(const std::string& id) {
  const MethodInfo* method = findMethod(id);
  return ruleInfo(method ? method->rule : kRules.front()).id;
}

RunMetrics metricsOfRecords(const std::vector<FrameRecord>& records, int frames) {
  RunMetrics metrics;
  metrics.frames = std::max(frames, static_cast<int>(records.size()));
  metrics.maps = mapCount(records);
  const int main_map = mainMap(records);
  int before_init = 0;
  for (const FrameRecord& record : records) {
    if (record.pose_good) {
      metrics.tracked += hasPoseIn(record, main_map);
      if (!metrics.init_frame) {
        metrics.init_frame = record.index;
        metrics.init_time_s = record.timestamp - records.front().timestamp;
      }
    }
    if (!metrics.init_frame) ++before_init;
    // The reference of a start became a keyframe before its row could say so.
    metrics.keyframes += record.is_keyframe + (record.is_keyframe && record.keyframe_id == 1);
    metrics.seeds.converged += record.seeds_converged;
    metrics.seeds.rejected += record.seeds_rejected;
  }
  if (metrics.init_frame) {
    metrics.tracked_fraction_after_init =
        metrics.tracked / static_cast<double>(metrics.frames - before_init);
  }
  countLosses(records, metrics);
  for (int i = 0; i < kStageCount; ++i) {
    metrics.time_ms[i] = stageTime(records, static_cast<Stage>(i));
  }
  return metrics;
}

}  // namespace svoscope
