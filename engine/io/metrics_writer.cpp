// SPDX-License-Identifier: MIT
#include "engine/io/metrics_writer.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "engine/base/methods.h"

namespace svoscope {

namespace {

using Json = nlohmann::ordered_json;

template <typename T>
Json orNull(const std::optional<T>& value) {
  return value ? Json(*value) : Json(nullptr);
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
      "ATE         {:.4f} m rmse (align {}, scale {:.4f}, {} of {} poses matched within {} s, "
      "{:.0f} % of the ground truth covered)\n",
      e.ate.rmse, alignmentName(e.options.alignment), e.scale, e.matched, e.poses_est,
      e.options.max_dt, 100 * e.coverage);
  if (e.rpe) {
    text +=
        fmt::format("RPE         {:.4f} m, {:.5f} rad rmse (over {}, {} pairs)\n",
                    e.rpe->trans_rmse_m, e.rpe->rot_rmse_rad, e.options.delta.text(), e.rpe->pairs);
  } else {
    text += fmt::format("RPE         not known: {}\n", e.rpe_note);
  }
  return text;
}

}  // namespace

Json ateJson(const std::optional<EvalResult>& evaluation) {
  if (!evaluation) return nullptr;
  const EvalResult& e = *evaluation;
  return {{"rmse_m", e.ate.rmse},     {"mean_m", e.ate.mean},
          {"median_m", e.ate.median}, {"max_m", e.ate.max},
          {"scale", e.scale},         {"matched", e.matched},
          {"coverage", e.coverage},   {"alignment", alignmentName(e.options.alignment)}};
}

Json rpeJson(const std::optional<EvalResult>& evaluation) {
  if (!evaluation || !evaluation->rpe) return nullptr;
  return {{"trans_rmse_m", evaluation->rpe->trans_rmse_m},
          {"rot_rmse_rad", evaluation->rpe->rot_rmse_rad},
          {"pairs", evaluation->rpe->pairs},
          {"pairs", evaluation->rpe->pairs},
          {"delta", evaluation->options.delta.text()}};
}

Json metricsJson(const RunMetrics& metrics) {
  Json times = Json::object();
  for (int i = 0; i < kStageCount; ++i) {
    const StageTime& time = metrics.time_ms[i];
    times[stageName(static_cast<Stage>(i))] =
        time.frames ? Json{{"median", time.median_ms}, {"p95", time.p95_ms}} : Json(nullptr);
  }
  Json json = {{"times", metrics.times},
               {"frames", metrics.frames},
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
