// SPDX-License-Identifier: MIT
#include "ui/harness/engine_values.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/eval/run_metrics.h"
#include "engine/snapshot/frame_fields.h"
#include "ui/model/truth.h"

namespace svoscope::ui {
namespace {

struct Now {
  const RunView& run;
  FrameRecord record;  // of the frame in view; index -1 if none
};

struct Named {
  const char* name;
  ScriptValue (*value)(const Now&);
};

ScriptValue number(double value) { return value; }

ScriptValue eventTexts(const Now& now) {
  std::vector<std::string> texts;
  for (const Event& event : now.run.events(0)) texts.push_back(event.text);
  return texts;
}

int countOf(const Now& now, bool (*which)(const FrameRecord&)) {
  const std::vector<FrameRecord> records = now.run.records(0);
  return static_cast<int>(std::count_if(records.begin(), records.end(), which));
}

RunMetrics metricsOf(const Now& now) {
  const std::vector<FrameRecord> records = now.run.records(0);
  return metricsOfRecords(records, static_cast<int>(records.size()));
}

/// NaN without a result: no comparison holds then.
ScriptValue truthValue(const Now& now, double TruthState::*value) {
  const TruthState truth =
      alignTruth(now.run.records(0), now.run.info().ground_truth, Alignment::sim3);
  return number(truth.valid ? truth.*value : NAN);
}

const Named kValues[] = {
    {"frame", [](const Now& n) { return number(n.record.index); }},
    {"next_frame", [](const Now& n) { return number(n.run.status().next_frame); }},
    {"playing", [](const Now& n) { return number(n.run.status().playing); }},
    {"finished", [](const Now& n) { return number(n.run.status().finished); }},
    {"frames", [](const Now& n) { return number(n.run.info().frames); }},
    {"method", [](const Now& n) { return ScriptValue(n.run.info().method); }},
    {"sequence", [](const Now& n) { return ScriptValue(n.run.info().sequence); }},
    {"events", eventTexts},
    {"tracked",
     [](const Now& n) {
       return number(countOf(n, [](const FrameRecord& r) { return r.pose_good; }));
     }},
    {"tracked_fraction",
     [](const Now& n) { return number(metricsOf(n).tracked_fraction_after_init.value_or(0)); }},
    {"start_frame", [](const Now& n) { return number(metricsOf(n).init_frame.value_or(-1)); }},
    {"losses", [](const Now& n) { return number(metricsOf(n).losses); }},
    {"ate", [](const Now& n) { return truthValue(n, &TruthState::ate_rmse); }},
    {"rpe", [](const Now& n) { return truthValue(n, &TruthState::rpe_trans); }},
    {"scale", [](const Now& n) { return truthValue(n, &TruthState::scale); }},
    {"frames_lost", [](const Now& n) {
       return number(
           countOf(n, [](const FrameRecord& r) { return r.state == TrackingState::lost; }));
     }}};

template <typename T>
ScriptValue scriptValue(const T& value) {
  if constexpr (std::is_same_v<T, TrackingState>)
    return std::string(stateName(value));
  else if constexpr (std::is_same_v<T, std::string>)
    return value;
  else
    return static_cast<double>(value);
}

/// Calls f(name, field) for every field of the record but its pose.
template <typename F>
void visitValues(const FrameRecord& record, F&& f) {
  visitFrameFields(record, [&](const FrameField& field, const auto& value) {
    if constexpr (!std::is_same_v<std::decay_t<decltype(value)>, SE3>) f(field.name, value);
  });
}

FrameRecord recordOf(const RunView& run, int frame) {
  const std::vector<FrameRecord> records = run.records(0);
  const auto found = std::find_if(records.rbegin(), records.rend(),
                                  [&](const FrameRecord& r) { return r.index == frame; });
  return found == records.rend() ? FrameRecord() : *found;
}

}  // namespace

std::optional<ScriptValue> engineValue(const RunView& run, int frame, const std::string& name) {
  for (const Named& known : kValues) {
    if (name == known.name) return known.value({run, recordOf(run, frame)});
  }
  std::optional<ScriptValue> found;
  visitValues(recordOf(run, frame), [&](const char* field, const auto& value) {
    if (name == field) found = scriptValue(value);
  });
  return found;
}

std::string engineValueNames() {
  std::string names;
  for (const Named& known : kValues) names += std::string(known.name) + ", ";
  visitValues({}, [&](const char* field, const auto&) { names += std::string(field) + ", "; });
  return names + "labels, width, height";
}

}  // namespace svoscope::ui
