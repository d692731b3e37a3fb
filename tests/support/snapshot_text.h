// SPDX-License-Identifier: MIT
// A snapshot as text, every number with all its bits: two are equal if their texts are.
#pragma once

#include <cstdio>
#include <string>

#include "engine/recording/columns.h"

namespace svoscope::test {

class TextColumns {
 public:
  template <typename T>
  void operator()(const char* name, const T& v) {
    text += std::string(" ") + name + "=";
    if constexpr (std::is_same_v<T, std::string>)
      text += v;
    else if constexpr (std::is_enum_v<T> || std::is_integral_v<T>)
      text += std::to_string(static_cast<long long>(v));
    else if constexpr (std::is_floating_point_v<T>)
      add(v);
    else if constexpr (std::is_same_v<T, BeliefView>)
      add(v.mu), add(v.sigma), add(v.a), add(v.b);
    else if constexpr (std::is_same_v<T, SE3>) {
      for (int i = 0; i < 3; ++i) add(v.translation()[i]);
      for (int i = 0; i < 4; ++i) add(v.quaternion().coeffs()[i]);
    } else
      for (int i = 0; i < v.size(); ++i) add(v[i]);
  }
  template <typename T>
  void operator()(const char* name, Named<T> v) {
    text += std::string(" ") + name + "=" + nameOf(v.value);
  }

  std::string text;

 private:
  void add(double value) {
    char digits[40];
    std::snprintf(digits, sizeof(digits), "%a,",
                  value == 0 ? 0.0 : value);  // the sign of zero is not kept
    text += digits;
  }
};

/// The parts of a snapshot, a line for each row.
inline std::vector<std::string> textOf(const Snapshot& s) {
  std::vector<std::string> lines;
  const auto line = [&](const std::string& what, const auto& fill) {
    TextColumns columns;
    fill(columns);
    lines.push_back(what + columns.text);
  };
  line("record", [&](TextColumns& c) { visitRecord(s.record, c); });
  line("snapshot", [&](TextColumns& c) { c("number", s.sequence_number); });
  for (const Event& e : s.events) line("event", [&](TextColumns& c) { visitEvent(e, c); });
  for (const FeatureView& f : s.features)
    line("feature", [&](TextColumns& c) { visitFeature(f, c); });
  if (!s.seeds || !s.seed_updates || !s.keyframes || !s.points)
    return lines.push_back("no lists"), lines;
  for (const SeedView& v : *s.seeds) {
    line("seed", [&](TextColumns& c) {
      c("id", v.id);
      visitSeedState(c, v);
      c("visible", v.visible);
      for (const Vec2f& px : {v.px, v.px_near, v.px_far}) c("px", px);
      for (const Vec3f& p : {v.position, v.position_end, v.position_near, v.position_far})
        c("p", p);
    });
  }
  for (const SeedUpdateView& u : *s.seed_updates)
    line("update", [&](TextColumns& c) { visitSeedUpdate(u, c); });
  for (const KeyframeView& k : *s.keyframes) {
    line("keyframe", [&](TextColumns& c) {
      visitKeyframe(k, c);
      c("frame", k.frame_index);
    });
  }
  for (const MapPointView& p : *s.points) line("point", [&](TextColumns& c) { visitPoint(p, c); });
  return lines;
}

}  // namespace svoscope::test
