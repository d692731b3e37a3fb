// SPDX-License-Identifier: MIT
// Which columns a value has: one list for the tables, the writer and the reader, so that they
// cannot come apart. A list calls f(name, field) for every field; what has several numbers takes
// several columns. docs/recording.md says what they mean.
#pragma once

#include <string>
#include <string_view>
#include <type_traits>

#include "engine/recording/names.h"
#include "engine/snapshot/frame_fields.h"
#include "engine/snapshot/snapshot.h"

namespace svoscope {

/// An enumeration that is stored as its name.
template <typename T>
struct Named {
  T& value;
};
template <typename T>
Named<T> named(T& value) {
  return {value};
}

/// The columns of a frame are those of the one list of its fields; its index is the key `frame`.
template <typename R, typename F>
void visitRecord(R& r, F&& f) {
  visitFrameFields(r, [&](const FrameField& field, auto& value) {
    if constexpr (std::is_same_v<std::decay_t<decltype(value)>, TrackingState>)
      f(field.name, named(value));
    else
      f(std::string_view(field.name) == "index" ? "frame" : field.name, value);
  });
}

template <typename R, typename F>
void visitFeature(R& v, F&& f) {
  f("id", v.id);
  f("type", v.type);
  f("origin", v.origin);
  f("status", v.status);
  f("level", v.level);
  f("px", v.px);
  f("predicted", v.predicted_px);
  f("px_end", v.px_end);
  f("direction", v.direction);
  f("depth", v.depth);
  f("residual_px", v.residual_px);
  f("observations", v.observations);
  f("reference_keyframe", v.reference_keyframe);
}

template <typename R, typename F>
void visitSeedUpdate(R& v, F&& f) {
  f("seed_id", v.seed_id);
  f("keyframe_id", v.keyframe_id);
  f("searched_frame", v.frame_index);
  f("outcome", v.outcome);
  f("px", v.px);
  f("score", v.score);
  f("x", v.x);
  f("tau", v.tau);
  for (const FilterRule rule : kRules) {
    const std::string id = ruleInfo(rule).id;
    f((id + "_before").c_str(), v.before[rule]);
    f((id + "_after").c_str(), v.after[rule]);
  }
  f("kl_belief_measurement", v.kl_belief_measurement);
  f("kl_measurement_belief", v.kl_measurement_belief);
  f("jsd", v.jsd);
  f("affinity", v.affinity);
}

template <typename R, typename F>
void visitPoint(R& v, F&& f) {
  f("id", v.id);
  f("type", named(v.type));
  f("p", v.position);
  f("p_end", v.position_end);
  f("sigma", v.sigma);
  f("observations", v.observations);
  f("reference_keyframe", v.reference_keyframe);
}

template <typename R, typename F>
void visitKeyframe(R& v, F&& f) {
  f("keyframe_id", v.id);
  f("in_map", v.in_map);
  f("", v.T_world_cam);
}

template <typename R, typename F>
void visitEvent(R& v, F&& f) {
  f("frame", v.frame_index);
  f("kind", named(v.kind));
  f("text", v.text);
}

template <typename R, typename F>
void visitParameter(R& v, F&& f) {
  f("key", v.key);
  f("value", v.value);
  f("default_value", v.default_value);
  f("unit", v.unit);
  f("meaning", v.meaning);
  f("type", v.type);
  f("minimum", v.minimum);
  f("maximum", v.maximum);
  f("needs_reset", v.needs_reset);
}

template <typename R, typename F>
void visitPinhole(R& v, F&& f) {
  f("width", v.width);
  f("height", v.height);
  f("fx", v.fx);
  f("fy", v.fy);
  f("cx", v.cx);
  f("cy", v.cy);
}

/// What may change in a seed from frame to frame, and what stays; not what follows from its belief
/// and the poses (engine/snapshot/seed_placement.h). Calls f(name, field of each of the rows).
template <typename F, typename... Rows>
constexpr void visitSeedState(F&& f, Rows&... v) {
  f("keyframe_id", v.keyframe_id...);
  f("type", v.type...);
  f("status", v.status...);
  f("ending", v.ending...);
  f("outcome", v.outcome...);
  f("level", v.level...);
  f("direction", v.direction...);
  f("px_ref", v.px_ref...);
  f("mu", v.mu...);
  f("sigma", v.sigma...);
  f("a", v.a...);
  f("b", v.b...);
  for (const FilterRule rule : kRules) f(ruleInfo(rule).id, v.belief[rule]...);
  f("range", v.range...);
  f("updates", v.updates...);
  f("failures", v.failures...);
  f("px_ref_end", v.px_ref_end...);
  f("mu_end", v.mu_end...);
  f("sigma_end", v.sigma_end...);
  f("last_x", v.last_x...);
  f("last_tau", v.last_tau...);
  f("true_inv_distance", v.true_inv_distance...);
}

constexpr int seedStateFields() {
  int count = 0;
  visitSeedState([&](const char*) { ++count; });
  return count;
}

}  // namespace svoscope
