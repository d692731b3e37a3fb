// SPDX-License-Identifier: MIT
#include "ui/panels/scene/image_overlay.h"

#include <algorithm>
#include <cmath>

#include "ui/model/selection_history.h"
#include "ui/palette.h"
#include "ui/theme.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/icons.h"

namespace svoscope::ui {

namespace {

float valueOf(const FeatureView& f, ColorBy by) {
  switch (by) {
    case ColorBy::depth:
      return f.depth;
    case ColorBy::observations:
      return static_cast<float>(f.observations);
    case ColorBy::residual:
      return f.residual_px;
    case ColorBy::level:
      return f.level;
    default:
      return 0;
  }
}

constexpr ImU32 kShadow = IM_COL32(0, 0, 0, 150);

void shadowedLine(ImDrawList* list, ImVec2 a, ImVec2 b, ImU32 color, float width) {
  list->AddLine(a, b, kShadow, width + dp(1.5f));
  list->AddLine(a, b, color, width);
}

// Half the width of a patch on its level, but never too small to see or to hit.
float glyphRadius(const ImageView& view, const FeatureView& f) {
  return std::clamp(1.6f * static_cast<float>(1 << std::min<int>(f.level, 5)) * view.zoom, dp(3),
                    dp(9));
}

void drawCorner(ImDrawList* list, ImVec2 p, float r, ImU32 color, bool strong) {
  const ImVec2 lo{p.x - r, p.y - r}, hi{p.x + r, p.y + r};
  list->AddRect({lo.x - 1, lo.y - 1}, {hi.x + 1, hi.y + 1}, kShadow);
  list->AddRect(lo, hi, color, 0, 0, strong ? dp(2) : dp(1.3f));
}

// The edge itself, perpendicular to the gradient, and a tick along the gradient.
void drawEdgelet(ImDrawList* list, ImVec2 p, float r, float direction, ImU32 color) {
  const float c = std::cos(direction), s = std::sin(direction), l = r * 1.5f;
  shadowedLine(list, {p.x + s * l, p.y - c * l}, {p.x - s * l, p.y + c * l}, color, dp(1.6f));
  list->AddLine(p, {p.x + c * r, p.y + s * r}, color, dp(1));
}

void drawSegment(const ImageView& view, ImDrawList* list, const FeatureView& f, ImU32 color) {
  const ImVec2 a = view.toScreen(f.px), b = view.toScreen(f.px_end);
  shadowedLine(list, a, b, color, dp(2));
  list->AddCircleFilled(a, dp(2.5f), color, 8);
  list->AddCircleFilled(b, dp(2.5f), color, 8);
}

void drawCross(ImDrawList* list, ImVec2 p, float r, ImU32 color) {
  shadowedLine(list, {p.x - r, p.y - r}, {p.x + r, p.y + r}, color, dp(1.3f));
  shadowedLine(list, {p.x - r, p.y + r}, {p.x + r, p.y - r}, color, dp(1.3f));
}

void drawGlyph(const ImageView& view, ImDrawList* list, const FeatureView& f, ImU32 color) {
  const ImVec2 p = view.toScreen(f.px);
  const float r = glyphRadius(view, f);
  if (f.status == FeatureStatus::not_aligned) return list->AddCircle(p, r * 0.8f, color, 10, dp(1));
  switch (f.type) {
    case FeatureType::corner:
      drawCorner(list, p, r, color, false);
      break;
    case FeatureType::edgelet:
      drawEdgelet(list, p, r, f.direction, color);
      break;
    case FeatureType::segment:
      drawSegment(view, list, f, color);
      break;
  }
  if (f.status == FeatureStatus::outlier) drawCross(list, p, r * 0.8f, color);
}

// Prediction -> measurement, exaggerated so that sub-pixel residuals can be seen.
void drawResidual(const ImageView& view, ImDrawList* list, const FeatureView& f,
                  const ImageOptions& options, ImU32 color) {
  if (f.status == FeatureStatus::not_aligned || f.origin == FeatureOrigin::track) return;
  if (!f.predicted_px.allFinite()) return;
  const ImVec2 p = view.toScreen(f.px);
  if (options.residuals) {
    const Px stick = (f.predicted_px - f.px) * options.residual_scale;
    const ImVec2 e = view.toScreen(f.px + stick);
    list->AddLine(p, e, withAlpha(color, 0.95f), dp(1.2f));
  }
  if (options.predicted) {
    const ImVec2 q = view.toScreen(f.predicted_px);
    list->AddLine({q.x - dp(3), q.y}, {q.x + dp(3), q.y}, ink::text, dp(1));
    list->AddLine({q.x, q.y - dp(3)}, {q.x, q.y + dp(3)}, ink::text, dp(1));
    list->AddLine(q, p, withAlpha(ink::text, 0.6f), dp(1));
  }
}

void drawStartTrack(const ImageView& view, ImDrawList* list, const FeatureView& f, ImU32 color) {
  const ImVec2 a = view.toScreen(f.predicted_px), b = view.toScreen(f.px);
  shadowedLine(list, a, b, withAlpha(color, 0.9f), dp(1.3f));
  list->AddCircleFilled(b, dp(2.5f), color, 8);
}

void highlight(ImDrawList* list, ImVec2 p, float r) {
  list->AddCircle(p, r + dp(5), kShadow, 24, dp(4));
  list->AddCircle(p, r + dp(5), ink::selected, 24, dp(2));
}

float segmentDistance(ImVec2 p, ImVec2 a, ImVec2 b) {
  const float dx = b.x - a.x, dy = b.y - a.y, n = dx * dx + dy * dy;
  const float t = n > 0 ? std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / n, 0.0f, 1.0f) : 0;
  return std::hypot(p.x - a.x - t * dx, p.y - a.y - t * dy);
}

}  // namespace

ColorScale colorScaleOf(const std::vector<FeatureView>& features, ColorBy by) {
  ColorScale scale;
  if (by == ColorBy::origin || by == ColorBy::status) return scale;
  scale.ramp = true;
  static constexpr const char* labels[] = {
      "", "", "Depth, map units", "Observations", "Residual, px", "Level"};
  scale.label = labels[static_cast<int>(by)];
  std::vector<float> values;
  for (const FeatureView& f : features) {
    const float v = valueOf(f, by);
    if (f.status != FeatureStatus::not_aligned && std::isfinite(v)) values.push_back(v);
  }
  if (values.empty()) return scale;
  std::sort(values.begin(), values.end());
  scale.lo = values[values.size() / 50];
  scale.hi = std::max(values[values.size() - 1 - values.size() / 50], scale.lo + 1e-6f);
  return scale;
}

ImU32 colorOf(const FeatureView& f, const ColorScale& scale, ColorBy by) {
  if (by == ColorBy::origin) return featureColor(f);
  if (by == ColorBy::status) {
    return f.status == FeatureStatus::inlier ? okabe::green : featureColor(f);
  }
  // The darkest part of the ramp would vanish in a dark image.
  return viridis(0.15f + 0.85f * (valueOf(f, by) - scale.lo) / (scale.hi - scale.lo));
}

bool shows(const ImageOptions& o, const FeatureView& f) {
  if (!f.px.allFinite()) return false;
  if (f.origin == FeatureOrigin::track) return o.tracks;
  if (f.status == FeatureStatus::outlier && !o.outliers) return false;
  if (f.status == FeatureStatus::not_aligned && !o.not_aligned) return false;
  switch (f.type) {
    case FeatureType::corner:
      return o.corners;
    case FeatureType::edgelet:
      return o.edgelets;
    case FeatureType::segment:
      return o.segments;
  }
  return true;
}

std::string hiddenText(const ImageOptions& options, const Snapshot& snapshot) {
  static constexpr const char* names[] = {"tracks",  "outliers", "failed",
                                          "corners", "edgelets", "segments"};
  int counts[6] = {}, all = 0;
  for (const FeatureView& f : snapshot.features) {
    if (shows(options, f) || !f.px.allFinite()) continue;
    const bool outlier = f.status == FeatureStatus::outlier && !options.outliers;
    const bool failed = f.status == FeatureStatus::not_aligned && !options.not_aligned;
    ++counts[f.origin == FeatureOrigin::track ? 0
             : outlier                        ? 1
             : failed                         ? 2
                                              : 3 + static_cast<int>(f.type)];
    ++all;
  }
  if (all == 0) return "";
  std::string by;
  for (int i = 0; i < 6; ++i) {
    if (counts[i] == all) return format("%d hidden: %s", all, names[i]);
    if (counts[i]) by += format("%s%d %s", by.empty() ? "" : ", ", counts[i], names[i]);
  }
  return format("%d hidden: ", all) + by;
}

void drawTrails(const ImageView& view, const std::vector<std::vector<Vec2f>>& trails,
                const Snapshot& snapshot, const ImageOptions& options) {
  ImDrawList* list = ImGui::GetWindowDrawList();
  for (std::size_t i = 0; i < trails.size() && i < snapshot.features.size(); ++i) {
    const FeatureView& f = snapshot.features[i];
    if (trails[i].size() < 2 || !shows(options, f)) continue;
    const ImU32 color = featureColor(f);
    const auto n = static_cast<float>(trails[i].size());
    for (std::size_t k = 1; k < trails[i].size(); ++k) {
      const float fade = 0.55f * (1 - static_cast<float>(k) / n) + 0.08f;
      list->AddLine(view.toScreen(trails[i][k - 1]), view.toScreen(trails[i][k]),
                    withAlpha(color, fade), dp(1.2f));
    }
  }
}

namespace {

void drawFeature(const ImageView& view, const FeatureView& f, const ImageOptions& options,
                 ImU32 color, bool selected) {
  ImDrawList* list = ImGui::GetWindowDrawList();
  const ImVec2 p = view.toScreen(f.px);
  if (f.origin == FeatureOrigin::track) {
    drawStartTrack(view, list, f, color);
  } else {
    drawResidual(view, list, f, options, color);
    drawGlyph(view, list, f, color);
  }
  const float r = glyphRadius(view, f);
  if (selected) highlight(list, p, r);
  if (!options.ids && !selected) return;
  const std::string text = format("%lld", static_cast<long long>(f.id));
  outlinedText(list, {p.x + (selected ? r : 0) + dp(8), p.y - ImGui::GetFontSize() / 2},
               selected ? ink::selected : color, text.c_str());
}

}  // namespace

void drawFeatures(const ImageView& view, const Snapshot& snapshot, const ImageOptions& options,
                  const Selection& selection) {
  const ColorScale scale = colorScaleOf(snapshot.features, options.color_by);
  const FeatureView* on_top = nullptr;
  for (const FeatureView& f : snapshot.features) {
    if (!f.px.allFinite()) continue;
    if (selection == selectionOf(f)) {
      on_top = &f;
      continue;
    }
    if (!shows(options, f)) continue;
    if (f.type != FeatureType::segment && !view.onScreen(view.toScreen(f.px), dp(40))) continue;
    drawFeature(view, f, options, colorOf(f, scale, options.color_by), false);
  }
  if (on_top) drawFeature(view, *on_top, options, colorOf(*on_top, scale, options.color_by), true);
}

Selection pick(const ImageView& view, const Snapshot& snapshot, const ImageOptions& options,
               ImVec2 at, float radius) {
  Selection best;
  float nearest = radius;
  for (const FeatureView& f : snapshot.features) {
    if (!shows(options, f)) continue;
    const ImVec2 p = view.toScreen(f.px);
    const float d = f.type == FeatureType::segment ? segmentDistance(at, p, view.toScreen(f.px_end))
                                                   : std::hypot(p.x - at.x, p.y - at.y);
    if (d >= nearest) continue;
    nearest = d;
    best = selectionOf(f);
  }
  if (best || !snapshot.seeds || !options.seeds) return best;
  for (const SeedView& s : *snapshot.seeds) {
    if (!s.visible || !s.px.allFinite()) continue;
    const ImVec2 p = view.toScreen(s.px);
    const float d = std::hypot(p.x - at.x, p.y - at.y);
    if (d >= nearest) continue;
    nearest = d;
    best = {Selection::Kind::seed, s.id};
  }
  return best;
}

}  // namespace svoscope::ui
