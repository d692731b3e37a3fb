// SPDX-License-Identifier: MIT
// Seeds and searches drawn over an image.
#include <algorithm>
#include <cmath>

#include "engine/study/lab.h"
#include "ui/model/seed_trace.h"
#include "ui/palette.h"
#include "ui/panels/scene/image_overlay.h"
#include "ui/theme.h"
#include "ui/widgets/icons.h"

namespace svoscope::ui {

namespace {

constexpr ImU32 kShadow = IM_COL32(0, 0, 0, 150);
constexpr double kLogTwo = 0.6931471805599453;

void ring(ImDrawList* list, ImVec2 p, float r, ImU32 color) {
  list->AddCircle(p, r, kShadow, 24, dp(4));
  list->AddCircle(p, r, color, 24, dp(2));
}

struct Place {
  bool selected, marked, pinned;
};

void drawSeed(const ImageView& view, const SeedView& s, ImU32 color, bool span,
              const Place& place) {
  ImDrawList* list = ImGui::GetWindowDrawList();
  const ImVec2 p = view.toScreen(s.px);
  const float r = place.marked ? dp(2.2f) : dp(1.3f);
  if (span && s.px_near.allFinite() && s.px_far.allFinite()) {
    list->AddLine(view.toScreen(s.px_near), view.toScreen(s.px_far),
                  withAlpha(color, place.selected ? 1.0f : 0.45f), place.selected ? dp(2) : dp(1));
  }
  list->AddRectFilled({p.x - r, p.y - r}, {p.x + r, p.y + r}, color);
  if (place.marked)
    list->AddRect({p.x - dp(5), p.y - dp(5)}, {p.x + dp(5), p.y + dp(5)}, ink::highlight, 0, 0,
                  dp(1.5f));
  if (place.pinned) ring(list, p, dp(6), ink::prior);
  if (place.selected) ring(list, p, dp(8), ink::selected);
}

}  // namespace

int mostUpdates(const Snapshot& snapshot) {
  int most = 10;
  if (snapshot.seeds) {
    for (const SeedView& s : *snapshot.seeds) most = std::max(most, s.updates + s.failures);
  }
  return most;
}

float seedRamp(const SeedView& s, SeedColorBy by, int most_updates) {
  switch (by) {
    case SeedColorBy::sigma: {  // 1/1000 .. 1/4 of the range, by decades
      const double ratio = s.range > 0 && s.sigma > 0 ? s.sigma / s.range : NAN;
      return static_cast<float>((std::log10(ratio) + 3) / (3 + std::log10(0.25)));
    }
    case SeedColorBy::inlier_ratio:
      return s.a + s.b > 0 ? s.a / (s.a + s.b) : NAN;
    case SeedColorBy::age:
      return static_cast<float>(s.updates + s.failures) /
             static_cast<float>(std::max(1, most_updates));
    case SeedColorBy::disagreement: {
      const BeliefView &first = s.belief[kRules[0]], &second = s.belief[kRules[1]];
      if (!drawable(first) || !drawable(second)) return NAN;
      return static_cast<float>(comparePair(first.mu, first.sigma, second.mu, second.sigma).jsd /
                                kLogTwo);
    }
    case SeedColorBy::status:
      break;
  }
  return NAN;
}

ColorScale seedScale(SeedColorBy by, int most_updates) {
  switch (by) {
    case SeedColorBy::sigma:
      return {true, 0.001f, 0.25f, "Seeds: σ / R (log)"};
    case SeedColorBy::inlier_ratio:
      return {true, 0, 1, "Seeds: inlier ratio"};
    case SeedColorBy::age:
      return {true, 0, static_cast<float>(most_updates), "Seeds: searches so far"};
    case SeedColorBy::disagreement:
      return {true, 0, static_cast<float>(kLogTwo), "Seeds: JS of both beliefs, nats"};
    case SeedColorBy::status:
      break;
  }
  return {};
}

ImU32 seedColorOf(const SeedView& s, SeedColorBy by, int most_updates) {
  if (by == SeedColorBy::status) return seedColor(s);
  // The darkest part of the ramp would vanish in a dark image.
  return viridis(0.15f + 0.85f * seedRamp(s, by, most_updates));
}

void drawSeeds(const ImageView& view, const Snapshot& snapshot, const ImageOptions& options,
               const Selection& selection, const std::set<std::int64_t>& highlighted,
               const std::vector<std::int64_t>& pinned) {
  if (!snapshot.seeds) return;
  const int most = mostUpdates(snapshot);
  for (const SeedView& s : *snapshot.seeds) {
    if (!s.visible || !s.px.allFinite()) continue;
    const Place place{selection.kind == Selection::Kind::seed && selection.id == s.id,
                      highlighted.count(s.id) > 0,
                      std::find(pinned.begin(), pinned.end(), s.id) != pinned.end()};
    if (!options.seeds && !place.selected && !place.marked && !place.pinned) continue;
    if (!view.onScreen(view.toScreen(s.px), dp(200))) continue;
    drawSeed(view, s, seedColorOf(s, options.seed_color, most), options.spans || place.selected,
             place);
  }
}

void drawSearch(const ImageView& view, int frame, const SearchLine& line,
                const SearchHover& hover) {
  ImDrawList* list = ImGui::GetWindowDrawList();
  if (line.frame == frame && line.near_px.allFinite() && line.far_px.allFinite()) {
    const ImVec2 a = view.toScreen(line.near_px), b = view.toScreen(line.far_px);
    list->AddLine(a, b, kShadow, dp(4));
    list->AddLine(a, b, ink::cursor, dp(1.6f));
    for (const ImVec2& end : {a, b}) list->AddCircleFilled(end, dp(2.5f), ink::cursor, 8);
    if (std::hypot(b.x - a.x, b.y - a.y) > dp(40))
      outlinedText(list, {a.x + dp(5), a.y + dp(2)}, ink::cursor, "near");
    if (line.matched && line.match_px.allFinite())
      ring(list, view.toScreen(line.match_px), dp(5), ink::measurement);
  }
  if (!hover.on || hover.frame != frame || !hover.px.allFinite()) return;
  const ImVec2 p = view.toScreen(hover.px);
  const float r = dp(9);
  for (const float w : {dp(4), dp(1.5f)}) {
    const ImU32 color = w > dp(2) ? kShadow : ink::highlight;
    list->AddLine({p.x - r, p.y}, {p.x + r, p.y}, color, w);
    list->AddLine({p.x, p.y - r}, {p.x, p.y + r}, color, w);
  }
}

}  // namespace svoscope::ui
