// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>

#include "ui/palette.h"
#include "ui/panels/panel.h"
#include "ui/panels/panel_context.h"
#include "ui/theme.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/icons.h"
#include "ui/widgets/pen.h"
#include "ui/widgets/plot_math.h"
#include "ui/widgets/probe.h"

namespace svoscope::ui {

namespace {

// The parts that add up to the tracking thread's time.
constexpr std::array<Stage, 8> kParts = {Stage::pyramid,   Stage::initialize, Stage::sparse_align,
                                         Stage::reproject, Stage::pose,       Stage::structure,
                                         Stage::keyframe,  Stage::relocalize};

double partsSum(const FrameRecord& r) {
  double sum = 0;
  for (const Stage s : kParts) sum += r.ms(s);
  return sum;
}

void barRow(Stage stage, double ms, double full, bool whole) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float h = ImGui::GetTextLineHeight(), name = ImGui::GetFontSize() * 7.5f;
  const float value = ImGui::GetFontSize() * 4;
  const float room = std::max(8.0f, ImGui::GetContentRegionAvail().x - name - value);
  ImDrawList* list = ImGui::GetWindowDrawList();
  pen::text(list, at, whole ? ink::text : ink::dim, stageLabel(stage));
  const auto length = static_cast<float>(std::clamp(ms / std::max(full, 1e-6), 0.0, 1.0)) * room;
  if (ms > 0)
    pen::rectFilled(list, {at.x + name, at.y + grid(0.5f)},
                    {at.x + name + std::max(1.0f, length), at.y + h - grid(0.5f)},
                    whole ? IM_COL32(104, 116, 132, 255) : stageColor(stage), dp(1));
  const std::string text = format("%.2f", ms);
  pen::text(list, {at.x + name + room + value - ImGui::CalcTextSize(text.c_str()).x, at.y},
            ink::text, text.c_str());
  ImGui::Dummy({name + room + value, h});
}

void budgetMark(ImVec2 from, float bottom, double full, double budget) {
  const float name = ImGui::GetFontSize() * 7.5f;
  const float room =
      std::max(8.0f, ImGui::GetContentRegionAvail().x - name - ImGui::GetFontSize() * 4);
  if (budget <= 0 || budget > full) return;
  const float x = from.x + name + static_cast<float>(budget / full) * room;
  dashedLine(ImGui::GetWindowDrawList(), {{x, from.y}, {x, bottom}}, withAlpha(ink::text, 0.6f),
             dp(1), dp(3), dp(3));
}

void frameBars(PanelContext& c, double budget) {
  const FrameRecord& r = *c.record;
  const double full = std::max({r.ms(Stage::tracking), r.ms(Stage::mapping), budget, 1e-3});
  const std::string frame = format("Frame %d", r.index);
  ImGui::TextUnformatted(frame.c_str());
  pen::itemText(ink::text, frame.c_str());
  ImGui::SameLine();
  const std::string time = budget > 0 ? format("%.1f of %.1f ms at %.0f Hz", r.ms(Stage::tracking),
                                               budget, c.info.rate_hz)
                                      : format("%.1f ms", r.ms(Stage::tracking));
  ImGui::TextDisabled("%s", time.c_str());
  pen::itemText(ink::dim, time.c_str());
  const ImVec2 from = ImGui::GetCursorScreenPos();
  for (const Stage s : kParts) barRow(s, r.ms(s), full, false);
  barRow(Stage::tracking, r.ms(Stage::tracking), full, true);
  barRow(Stage::mapping, r.ms(Stage::mapping), full, false);
  barRow(Stage::snapshot, r.ms(Stage::snapshot), full, false);
  budgetMark(from, ImGui::GetCursorScreenPos().y, full, budget);
  if (c.status.mapping_queue > 0)
    valueRow("Mapping queue", format("%d jobs", c.status.mapping_queue));
}

// The slowest frame of each column, so that no outlier is lost when frames outnumber pixels.
struct Strip {
  ImVec2 lo, hi;
  std::vector<const FrameRecord*> slowest;
  double full = 1;
  float width() const { return (hi.x - lo.x) / static_cast<float>(slowest.size()); }
};

// Frames below the strip, each under its column.
void frameAxis(const Strip& s, const std::vector<FrameRecord>& records) {
  if (records.empty()) return;
  ImDrawList* list = ImGui::GetWindowDrawList();
  const int count = std::max(2, static_cast<int>((s.hi.x - s.lo.x) / (ImGui::GetFontSize() * 5)));
  const int step =
      std::max(1, static_cast<int>(niceStep(records.back().index - records.front().index, count)));
  for (std::size_t row = 0; row < records.size(); ++row) {
    if (records[row].index % step != 0) continue;
    const float share = (static_cast<float>(row) + 0.5f) / static_cast<float>(records.size());
    const float x = std::round(s.lo.x + share * (s.hi.x - s.lo.x));
    const std::string text = tickLabel(records[row].index, step);
    const float width = ImGui::CalcTextSize(text.c_str()).x;
    pen::line(list, {x, s.hi.y}, {x, s.hi.y + grid(0.5f)}, ink::dim);
    pen::text(list,
              {std::round(std::clamp(x - width / 2, s.lo.x, s.hi.x - width)), s.hi.y + grid(0.5f)},
              ink::dim, text.c_str());
  }
}

Strip makeStrip(const std::vector<FrameRecord>& records, ImVec2 lo, ImVec2 hi, double budget) {
  Strip s{lo, hi, {}, std::max(budget * 1.2, 1e-3)};
  const auto room = static_cast<std::size_t>(std::max(1.0f, (hi.x - lo.x) / dp(2)));
  const std::size_t columns = std::clamp<std::size_t>(records.size(), 1, room);
  s.slowest.assign(columns, nullptr);
  for (std::size_t i = 0; i < records.size(); ++i) {
    auto& slot = s.slowest[i * columns / records.size()];
    const double sum = partsSum(records[i]);
    if (!slot || sum > partsSum(*slot)) slot = &records[i];
    s.full = std::max(s.full, budget > 0 ? std::min(sum, budget * 3) : sum);
  }
  return s;
}

void drawColumns(const Strip& s, int viewed) {
  ImDrawList* list = ImGui::GetWindowDrawList();
  const float width = s.width();
  for (std::size_t k = 0; k < s.slowest.size(); ++k) {
    const FrameRecord* r = s.slowest[k];
    if (!r) continue;
    float y = s.hi.y;
    const float x = s.lo.x + static_cast<float>(k) * width;
    for (const Stage stage : kParts) {
      const auto h = static_cast<float>(r->ms(stage) / s.full) * (s.hi.y - s.lo.y);
      const float top = std::max(s.lo.y, y - h);
      if (h > 0.2f) pen::rectFilled(list, {x, top}, {x + width, y}, stageColor(stage));
      y = top;
    }
    const bool next_is_later =
        k + 1 == s.slowest.size() || !s.slowest[k + 1] || s.slowest[k + 1]->index > viewed;
    if (r->index <= viewed && next_is_later) {
      const float c = std::round(x + width / 2);
      pen::line(list, {c, s.lo.y}, {c, s.hi.y}, ink::cursor, dp(1));
    }
  }
}

void stackedStrip(PanelContext& c, double budget) {
  const ImVec2 lo = ImGui::GetCursorScreenPos();
  const ImVec2 room = ImGui::GetContentRegionAvail();
  const ImVec2 hi{lo.x + std::max(8.0f, room.x),
                  lo.y + std::max(grid(12), room.y - grid(1.5f) - ImGui::GetFontSize())};
  ImDrawList* list = ImGui::GetWindowDrawList();
  pen::rectFilled(list, lo, hi, ink::canvas);
  const bool clicked = ImGui::InvisibleButton("##strip", {hi.x - lo.x, hi.y - lo.y});
  const bool hovered = ImGui::IsItemHovered();
  Probe::record("timing:strip", lo, hi);
  const Strip s = makeStrip(c.caches.run.records(), lo, hi, budget);
  drawColumns(s, c.viewedFrame());
  frameAxis(s, c.caches.run.records());
  ImGui::Dummy({1, ImGui::GetFontSize()});  // the axis
  if (budget > 0 && budget < s.full) {
    const float y = std::round(hi.y - static_cast<float>(budget / s.full) * (hi.y - lo.y));
    dashedLine(list, {{lo.x, y}, {hi.x, y}}, withAlpha(ink::text, 0.7f), dp(1), dp(4), dp(4));
    const std::string text = format("%.0f ms", budget);
    outlinedText(list, {lo.x + grid(1), y - ImGui::GetTextLineHeight()}, ink::text, text.c_str());
  }
  if (!hovered && !clicked) return;
  const auto k =
      static_cast<std::size_t>(std::max(0.0f, (ImGui::GetIO().MousePos.x - lo.x) / s.width()));
  if (k >= s.slowest.size() || !s.slowest[k]) return;
  ImGui::SetTooltip("Frame %d  %.1f ms", s.slowest[k]->index, partsSum(*s.slowest[k]));
  if (clicked) c.view(s.slowest[k]->index);
}

void draw(PanelContext& c) {
  if (!c.record)
    return emptyState("No times yet", "Each processed frame adds the time of every stage");
  const double budget = c.info.rate_hz > 0 ? 1000 / c.info.rate_hz : 0;
  frameBars(c, budget);
  heading("Tracking time over frames");
  bool first = true;
  for (const Stage s : kParts) {
    if (!first) sameLineIfFits(legendWidth(stageLabel(s)) + grid(2));
    first = false;
    legendEntry(stageColor(s), Swatch::line, stageLabel(s));
  }
  stackedStrip(c, budget);
}

std::string csv(PanelContext& c) {
  if (c.caches.run.records().empty()) return "";
  std::string text = "frame";
  for (int s = 0; s < kStageCount; ++s) text += format(",%s_ms", stageName(static_cast<Stage>(s)));
  text += "\n";
  for (const FrameRecord& r : c.caches.run.records()) {
    text += format("%d", r.index);
    for (const double ms : r.time_ms) text += format(",%.3f", ms);
    text += "\n";
  }
  return text;
}

}  // namespace

extern const Panel kTimingPanel{"Timing", draw, csv, /*charts=*/true};

}  // namespace svoscope::ui
