// SPDX-License-Identifier: MIT
#include "ui/widgets/timeline.h"

#include <algorithm>
#include <cmath>

#include "ui/palette.h"
#include "ui/theme.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/icons.h"
#include "ui/widgets/plot_math.h"
#include "ui/widgets/probe.h"

namespace svoscope::ui {

namespace {

struct Strip {
  ImDrawList* list;
  ImVec2 lo, hi;
  int frames;

  float x(double frame) const {
    return lo.x + static_cast<float>(frame / std::max(1, frames)) * (hi.x - lo.x);
  }
};

// Consecutive frames of one state are one rectangle: a long run stays cheap to draw.
void drawStates(const Strip& s, const std::vector<FrameRecord>& records, float y0, float y1) {
  for (std::size_t i = 0; i < records.size();) {
    std::size_t j = i + 1;
    while (j < records.size() && records[j].state == records[i].state) ++j;
    const float a = s.x(records[i].index);
    const float b = std::max(s.x(records[j - 1].index + 1), a + 1);
    s.list->AddRectFilled({a, y0}, {b, y1}, withAlpha(stateColor(records[i].state), 0.85f));
    // Not by colour alone: lost is hatched.
    if (records[i].state == TrackingState::lost) {
      for (float x = a + dp(2); x < b; x += dp(4)) {
        s.list->AddLine({x, y1}, {std::min(x + dp(3), b), y0}, IM_COL32(0, 0, 0, 170), dp(1));
      }
    }
    i = j;
  }
}

void drawKeyframes(const Strip& s, const std::vector<FrameRecord>& records, float y0, float y1) {
  float last = -1e9f;
  for (const FrameRecord& r : records) {
    if (!r.is_keyframe) continue;
    const float x = std::round(s.x(r.index + 0.5));
    if (x - last < 1) continue;
    s.list->AddLine({x, y0}, {x, y1}, eventColor(EventKind::keyframe), dp(1));
    last = x;
  }
}

void drawTimes(const Strip& s, const std::vector<FrameRecord>& records, double budget, float y0,
               float y1) {
  const double full = budget > 0 ? budget * 1.25 : 40;
  const auto columns = static_cast<std::size_t>(std::max(1.0f, s.hi.x - s.lo.x));
  std::vector<float> tracking(columns, 0), mapping(columns, 0);
  const float width = std::max(1.0f, s.x(1) - s.x(0));
  for (const FrameRecord& r : records) {
    const auto c = static_cast<std::size_t>(
        std::clamp(s.x(r.index) - s.lo.x, 0.0f, static_cast<float>(columns - 1)));
    tracking[c] = std::max(tracking[c], static_cast<float>(r.ms(Stage::tracking)));
    mapping[c] = std::max(mapping[c], static_cast<float>(r.ms(Stage::mapping)));
  }
  const auto bar = [&](std::size_t c, float ms, ImU32 color) {
    const float h = static_cast<float>(std::min(1.0, ms / full)) * (y1 - y0);
    if (ms <= 0) return;
    const float x = s.lo.x + static_cast<float>(c);
    s.list->AddRectFilled({x, y1 - std::max(1.0f, h)}, {x + width, y1}, color);
  };
  for (std::size_t c = 0; c < columns; ++c)
    bar(c, mapping[c], withAlpha(stageColor(Stage::mapping), 0.45f));
  for (std::size_t c = 0; c < columns; ++c) {
    const bool late = budget > 0 && tracking[c] > budget;
    bar(c, tracking[c], late ? okabe::orange : IM_COL32(104, 116, 132, 255));
  }
  if (budget > 0) {
    const float y = std::round(y1 - static_cast<float>(budget / full) * (y1 - y0));
    dashedLine(s.list, {{s.lo.x, y}, {s.hi.x, y}}, withAlpha(ink::text, 0.4f), dp(1), dp(3), dp(4));
  }
}

void marker(const Strip& s, const Event& e, float y) {
  const float x = s.x(e.frame_index + 0.5), r = dp(4);
  const ImU32 color = eventColor(e.kind);
  if (e.kind == EventKind::lost || e.kind == EventKind::error) {
    s.list->AddLine({x - r * 0.8f, y - r}, {x + r * 0.8f, y + r}, color, dp(2));
    s.list->AddLine({x + r * 0.8f, y - r}, {x - r * 0.8f, y + r}, color, dp(2));
  } else if (e.kind == EventKind::relocalized) {
    s.list->AddCircle({x, y}, r * 0.9f, color, 12, dp(2));
  } else if (e.kind == EventKind::initialized) {
    s.list->AddTriangleFilled({x - r * 0.8f, y - r}, {x - r * 0.8f, y + r}, {x + r, y}, color);
  } else if (e.kind == EventKind::warning) {
    s.list->AddTriangle({x - r, y + r}, {x + r, y + r}, {x, y - r}, color, dp(1.5f));
  }
}

void drawCursor(const Strip& s, int frame, bool engine) {
  if (frame < 0) return;
  const float x = std::round(s.x(frame + 0.5));
  if (engine) {
    dashedLine(s.list, {{x, s.lo.y}, {x, s.hi.y}}, withAlpha(ink::cursor, 0.7f), dp(1), dp(3),
               dp(2));
    return;
  }
  s.list->AddLine({x, s.lo.y}, {x, s.hi.y}, ink::cursor, dp(1.5f));
  s.list->AddTriangleFilled({x - dp(5), s.lo.y}, {x + dp(5), s.lo.y}, {x, s.lo.y + dp(6)},
                            ink::cursor);
}

void drawScale(const Strip& s, float y) {
  const int count = std::max(2, static_cast<int>((s.hi.x - s.lo.x) / (ImGui::GetFontSize() * 6)));
  const double step = std::max(1.0, niceStep(s.frames, count));
  for (double t = 0; t < s.frames; t += step) {
    const std::string text = tickLabel(t, step);
    const float x = std::round(s.x(t + 0.5));
    s.list->AddLine({x, y}, {x, y + grid(1)}, ink::faint);
    if (x + ImGui::CalcTextSize(text.c_str()).x + grid(1) > s.hi.x) break;
    s.list->AddText({x + grid(0.75f), y}, ink::dim, text.c_str());
  }
}

void hoverInfo(const TimelineSpec& spec, int frame) {
  ImGui::BeginTooltip();
  ImGui::Text("Frame %d", frame);
  const auto& records = *spec.records;
  const auto it = std::lower_bound(records.begin(), records.end(), frame,
                                   [](const FrameRecord& r, int f) { return r.index < f; });
  if (it == records.end() || it->index != frame) {
    ImGui::TextUnformatted("Not processed yet");
  } else {
    ImGui::TextUnformatted(it->reason.empty() ? stateName(it->state) : it->reason.c_str());
    ImGui::Text("%d inliers, tracking %.1f ms", it->funnel.inliers, it->ms(Stage::tracking));
    if (it->is_keyframe) ImGui::Text("Keyframe %d", it->keyframe_id);
    if (frame < spec.history_first) ImGui::TextUnformatted("Image and features no longer held");
  }
  for (const Event& e : *spec.events) {
    if (e.frame_index == frame && e.kind != EventKind::keyframe)
      ImGui::TextUnformatted(e.text.c_str());
  }
  ImGui::EndTooltip();
}

}  // namespace

int frameAtPixel(float x, float lo, float hi, int frames) {
  if (!(hi > lo) || frames < 1) return 0;
  const auto frame =
      static_cast<int>(std::floor((x - lo) / (hi - lo) * static_cast<float>(frames)));
  return std::clamp(frame, 0, frames - 1);
}

std::optional<int> timeline(const char* label, const TimelineSpec& spec) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const ImVec2 size{std::max(4.0f, ImGui::GetContentRegionAvail().x), std::max(4.0f, spec.height)};
  ImGui::InvisibleButton(label, size);
  const Strip s{ImGui::GetWindowDrawList(), at, {at.x + size.x, at.y + size.y}, spec.frames};
  Probe::record(label, s.lo, s.hi);
  s.list->PushClipRect(s.lo, s.hi, true);
  s.list->AddRectFilled(s.lo, s.hi, ink::canvas);
  const float text = ImGui::GetFontSize() + grid(0.5f);
  const float time_bottom = s.hi.y - text - grid(3.5f);
  drawTimes(s, *spec.records, spec.budget_ms, s.lo.y + grid(3), time_bottom);
  for (const Event& e : *spec.events) marker(s, e, s.lo.y + grid(1.75f));
  drawKeyframes(s, *spec.records, time_bottom + grid(0.25f), time_bottom + grid(1.5f));
  drawStates(s, *spec.records, time_bottom + grid(1.75f), time_bottom + grid(3));
  if (spec.history_first > 0 && !spec.records->empty()) {
    s.list->AddRectFilled(s.lo, {s.x(spec.history_first), s.hi.y - text},
                          IM_COL32(10, 11, 13, 130));
    const float x = std::round(s.x(spec.history_first));
    s.list->AddLine({x, s.lo.y}, {x, s.hi.y - text}, ink::faint, dp(1));
  }
  drawScale(s, s.hi.y - text);
  if (spec.engine != spec.viewed) drawCursor(s, spec.engine, true);
  drawCursor(s, spec.viewed, false);
  s.list->PopClipRect();
  const int frame = frameAtPixel(ImGui::GetIO().MousePos.x, s.lo.x, s.hi.x, spec.frames);
  if (ImGui::IsItemHovered() && spec.frames > 0) hoverInfo(spec, frame);
  if (ImGui::IsItemActive() && spec.frames > 0) return frame;
  return std::nullopt;
}

}  // namespace svoscope::ui
