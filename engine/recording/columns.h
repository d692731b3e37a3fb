// SPDX-License-Identifier: MIT
// Which columns a value has: one list for the tables, the writer and the reader, so that they cannot
// come apart. A list calls f(name, field) for every field; what has several numbers takes several
// columns. docs/recording.md says what they mean.
#pragma once

#include <string>
#include <type_traits>

#include "engine/recording/names.h"
#include "engine/recording/sqlite.h"
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

template <typename R, typename F>
void visitFunnel(R& funnel, F&& f) {
  f("aligned_sparse", funnel.aligned_sparse);
  f("candidates", funnel.candidates);
  f("projected", funnel.projected);
  f("tried", funnel.tried);
  f("matched", funnel.matched);
  f("inliers", funnel.inliers);
  f("inlier_landmarks", funnel.inlier_landmarks);
  f("inlier_seeds", funnel.inlier_seeds);
  f("inlier_edgelets", funnel.inlier_edgelets);
  f("inlier_segments", funnel.inlier_segments);
  f("required", funnel.required);
}

template <typename R, typename F>
void visitRecord(R& r, F&& f) {
  f("frame", r.index);
  f("timestamp", r.timestamp);
  f("state", named(r.state));
  f("pose_good", r.pose_good);
  f("is_keyframe", r.is_keyframe);
  f("keyframe_id", r.keyframe_id);
  f("relocalized", r.relocalized);
  f("reason", r.reason);
  f("keyframe_reason", r.keyframe_reason);
  f("", r.T_world_cam);
  visitFunnel(r.funnel, f);
  f("align_rmse", r.align_rmse);
  f("reprojection_px", r.reprojection_px);
  f("gain", r.gain);
  f("offset", r.offset);
  f("median_depth", r.median_depth);
  f("disparity_tracks", r.disparity_tracks);
  f("disparity_px", r.disparity_px);
  f("landmarks", r.landmarks);
  f("seeds", r.seeds);
  f("keyframes", r.keyframes);
  f("seeds_converged", r.seeds_converged);
  f("seeds_rejected", r.seeds_rejected);
  f("seed_updates", r.seed_updates);
  f("segment_updates", r.segment_updates);
  for (int i = 0; i < kStageCount; ++i)
    f((std::string("ms_") + stageName(static_cast<Stage>(i))).c_str(), r.time_ms[static_cast<std::size_t>(i)]);
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
  f("kl_before", v.kl_before);
  f("kl_after", v.kl_after);
  f("js_before", v.js_before);
  f("js_after", v.js_after);
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

/// What may change in a seed from frame to frame, and what stays; not what follows from its belief and
/// the poses (engine/snapshot/seed_placement.h).
template <typename R, typename F>
void visitSeedState(R& v, F&& f) {
  f("keyframe_id", v.keyframe_id);
  f("type", v.type);
  f("status", v.status);
  f("ending", v.ending);
  f("outcome", v.outcome);
  f("level", v.level);
  f("direction", v.direction);
  f("px_ref", v.px_ref);
  f("mu", v.mu);
  f("sigma", v.sigma);
  f("a", v.a);
  f("b", v.b);
  f("kl", v.kl);
  f("js", v.js);
  f("range", v.range);
  f("updates", v.updates);
  f("failures", v.failures);
  f("px_ref_end", v.px_ref_end);
  f("mu_end", v.mu_end);
  f("sigma_end", v.sigma_end);
  f("last_x", v.last_x);
  f("last_tau", v.last_tau);
  f("true_inv_distance", v.true_inv_distance);
}

/// "a REAL, b INTEGER, ..." of CREATE TABLE, the same without types, and as many question marks.
class ColumnList {
 public:
  template <typename T>
  void operator()(const char* name, const T&) {
    if constexpr (std::is_floating_point_v<T>) add(name, "REAL");
    else if constexpr (std::is_same_v<T, SE3>) for (const char* c : {"tx", "ty", "tz", "qx", "qy", "qz", "qw"}) add(name + std::string(c), "REAL");
    else if constexpr (std::is_same_v<T, Vec2f>) for (const char* c : {"_x", "_y"}) add(name + std::string(c), "REAL");
    else if constexpr (std::is_same_v<T, Vec3f>) for (const char* c : {"_x", "_y", "_z"}) add(name + std::string(c), "REAL");
    else if constexpr (std::is_same_v<T, BeliefView>) for (const char* c : {"_mu", "_sigma", "_a", "_b"}) add(name + std::string(c), "REAL");
    else if constexpr (std::is_same_v<T, std::string>) add(name, "TEXT");
    else add(name, "INTEGER");
  }
  template <typename T>
  void operator()(const char* name, Named<T>) { add(name, "TEXT"); }

  void add(const std::string& name, const std::string& type) {
    const char* comma = names.empty() ? "" : ", ";
    declarations += comma + name + " " + type;
    names += comma + name;
    marks += std::string(comma) + "?";
  }
  std::string declarations, names, marks;
};

class PutColumns {
 public:
  explicit PutColumns(Query& query) : q_(query) {}
  template <typename T>
  void operator()(const char*, const T& v) {
    if constexpr (std::is_enum_v<T> || std::is_integral_v<T>) q_.put(static_cast<std::int64_t>(v));
    else if constexpr (std::is_floating_point_v<T>) q_.put(static_cast<double>(v));
    else if constexpr (std::is_same_v<T, std::string>) q_.put(v);
    else if constexpr (std::is_same_v<T, BeliefView>) for (const float c : {v.mu, v.sigma, v.a, v.b}) q_.put(static_cast<double>(c));
    else if constexpr (std::is_same_v<T, SE3>) {
      for (int i = 0; i < 3; ++i) q_.put(v.translation()[i]);
      for (int i = 0; i < 4; ++i) q_.put(v.quaternion().coeffs()[i]);
    } else for (int i = 0; i < v.size(); ++i) q_.put(static_cast<double>(v[i]));
  }
  template <typename T>
  void operator()(const char*, Named<T> v) { q_.put(nameOf(v.value)); }

 private:
  Query& q_;
};

class GetColumns {
 public:
  explicit GetColumns(Query& query) : q_(query) {}
  template <typename T>
  void operator()(const char*, T& v) {
    if constexpr (std::is_enum_v<T>) v = valueOfCode<T>(q_.integer());
    else if constexpr (std::is_integral_v<T>) v = static_cast<T>(q_.integer());
    else if constexpr (std::is_floating_point_v<T>) v = static_cast<T>(q_.real());
    else if constexpr (std::is_same_v<T, std::string>) v = q_.text();
    else if constexpr (std::is_same_v<T, BeliefView>) for (float* c : {&v.mu, &v.sigma, &v.a, &v.b}) *c = static_cast<float>(q_.real());
    else if constexpr (std::is_same_v<T, SE3>) {
      Vec3 t;
      Eigen::Quaterniond q;
      for (int i = 0; i < 3; ++i) t[i] = q_.real();
      for (int i = 0; i < 4; ++i) q.coeffs()[i] = q_.real();
      v = SE3::fromParts(q, t);
    } else for (int i = 0; i < v.size(); ++i) v[i] = static_cast<float>(q_.real());
  }
  template <typename T>
  void operator()(const char*, Named<T> v) { v.value = valueOf<T>(q_.text()); }

 private:
  Query& q_;
};

}  // namespace svoscope
