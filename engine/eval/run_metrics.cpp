// SPDX-License-Identifier: MIT
#include "engine/eval/run_metrics.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "engine/base/methods.h"
#include "engine/base/quantile.h"
#include "engine/eval/estimate.h"

namespace svoscope {

namespace {

using Json = nlohmann::ordered_json;

template <typename T>
Json orNull(const std::optional<T>& value) {
  return value ? Json(*value) : Json(nullptr);
}

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

Json seedsJson(const RunMetrics& metrics) {
  Json rules;
  for (const RuleInfo& rule : kRuleTable) rules[rule.id] = nullptr;
  rules[seedRule(metrics.method)] = {
      {"converged", metrics.seeds.converged},
      {"rejected", metrics.seeds.rejected},
      {"updates_to_converge_median", orNull(metrics.seeds.updates_to_converge_median)}};
  return rules;
}

std::string evaluationText(const RunMetrics& metrics) {
  if (!metrics.evaluation) {
    return fmt::format("ATE         not known: {}\n", metrics.evaluation_note);
  }
  const EvalResult& e = *metrics.evaluation;
  std::string text = fmt::format(
      "ATE         {:.4f} m rmse (align {}, scale {:.4f}, {} of {} poses matched within {} s)\n",
      e.ate.rmse, alignmentName(e.options.alignment), e.scale, e.matched, e.poses_est,
      e.options.max_dt);
  if (e.rpe) {
    text +=
        fmt::format("RPE         {:.4f} m, {:.5f} rad rmse (over {}, {} pairs)\n",
                    e.rpe->trans_rmse_m, e.rpe->rot_rmse_rad, e.options.delta.text(), e.rpe->pairs);
  } else {
    text += fmt::format("RPE         not known: no poses are {} apart\n", e.options.delta.text());
  }
  return text;
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

Json ateJson(const std::optional<EvalResult>& evaluation) {
  if (!evaluation) return nullptr;
  const EvalResult& e = *evaluation;
  return {{"rmse_m", e.ate.rmse},
          {"mean_m", e.ate.mean},
          {"median_m", e.ate.median},
          {"max_m", e.ate.max},
          {"scale", e.scale},
          {"matched", e.matched},
          {"alignment", alignmentName(e.options.alignment)}};
}

Json rpeJson(const std::optional<EvalResult>& evaluation) {
  if (!evaluation || !evaluation->rpe) return nullptr;
  return {{"trans_rmse_m", evaluation->rpe->trans_rmse_m},
          {"rot_rmse_rad", evaluation->rpe->rot_rmse_rad},
          {"delta", evaluation->options.delta.text()}};
}

Json metricsJson(const RunMetrics& metrics) {
  Json times = Json::object();
  for (int i = 0; i < kStageCount; ++i) {
    const StageTime& time = metrics.time_ms[i];
    times[stageName(static_cast<Stage>(i))] =
        time.frames ? Json{{"median", time.median_ms}, {"p95", time.p95_ms}} : Json(nullptr);
  }
  Json json = {{"frames", metrics.frames},
               {"tracked", metrics.tracked},
               {"maps", metrics.maps},
               {"init_frame", orNull(metrics.init_frame)},
               {"tracked_fraction_after_init", orNull(metrics.tracked_fraction_after_init)},
               {"keyframes", metrics.keyframes},
               {"losses", metrics.losses},
               {"relocalisations", metrics.relocalisations},
               {"relocalisation_time_s", orNull(metrics.relocalisation_time_s)},
               {"init_time_s", orNull(metrics.init_time_s)}};
  json["ate"] = ateJson(metrics.evaluation);
  json["rpe"] = rpeJson(metrics.evaluation);
  json["time_ms"] = times;
  json["fps"] = metrics.fps;
  json["points"] = metrics.points;
  json["segments"] = metrics.segments;
  json["seeds"] = seedsJson(metrics);
  json["peak_rss_mb"] = metrics.peak_rss_mb;
  return json;
}

std::string metricsText(const RunMetrics& metrics) {
  std::string text = fmt::format("frames      {}, tracked {}", metrics.frames, metrics.tracked);
  if (metrics.init_frame) {
    text += fmt::format(" ({:.1f} % since frame {}, {:.2f} s to start)\n",
                        100 * *metrics.tracked_fraction_after_init, *metrics.init_frame,
                        *metrics.init_time_s);
  } else {
    text += " (never initialised)\n";
  }
  text += fmt::format("keyframes   {}, losses {}, relocalisations {}\n", metrics.keyframes,
                      metrics.losses, metrics.relocalisations);
  if (metrics.maps > 1) {
    text += fmt::format(
        "maps        {}: the trajectory is that of the map with most poses, the others are in "
        "trajectory-mapN.txt\n",
        metrics.maps);
  }
  text += fmt::format("map         {} points, {} segments\n", metrics.points, metrics.segments);
  text += evaluationText(metrics);
  const StageTime& tracking = metrics.time_ms[static_cast<int>(Stage::tracking)];
  text += fmt::format("tracking    {:.2f} ms median, {:.2f} ms p95; {:.1f} frames/s in all\n",
                      tracking.median_ms, tracking.p95_ms, metrics.fps);
  return text;
}

}  // namespace svoscope
