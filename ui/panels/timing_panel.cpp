// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>

#include "ui/palette.h"
#include "ui/panels/panel_context.h"
#include "ui/theme.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/icons.h"
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
  const float h = ImGui::GetTextLineHeight(), name = ImGui::GetFontSize() * 6.5f;
  const float value = ImGui::GetFontSize() * 4;
  const float room = std::max(8.0f, ImGui::GetContentRegionAvail().x - name - value);
  ImDrawList* list = ImGui::GetWindowDrawList();
  list->AddText(at, whole ? ink::text : ink::dim, stageName(stage));
  const auto length = static_cast<float>(std::clamp(ms / std::max(full, 1e-6), 0.0, 1.0)) * room;
  list->AddRectFilled({at.x + name, at.y + grid(0.5f)}, {at.x + name + std::max(1.0f, length), at.y + h - grid(0.5f)},
                      whole ? IM_COL32(104, 116, 132, 255) : stageColor(stage), dp(1));
  const std::string text = format("%.2f", ms);
  list->AddText({at.x + name + room + value - ImGui::CalcTextSize(text.c_str()).x, at.y}, ink::text, text.c_str());
  ImGui::Dummy({name + room + value, h});
}

void budgetMark(ImVec2 from, float bottom, double full, double budget) {
  const float name = ImGui::GetFontSize() * 6.5f;
  const float room = std::max(8.0f, ImGui::GetContentRegionAvail().x - name - ImGui::GetFontSize() * 4);
  if (budget <= 0 || budget > full) return;
  const float x = from.x + name + static_cast<float>(budget / full) * room;
  dashedLine(ImGui::GetWindowDrawList(), {{x, from.y}, {x, bottom}}, withAlpha(ink::text, 0.6f), dp(1), dp(3), dp(3));
}

void frameBars(PanelContext& c, double budget) {
  const FrameRecord& r = *c.record;
  const double full = std::max({r.ms(Stage::tracking), r.ms(Stage::mapping), budget, 1e-3});
  ImGui::Text("Frame %d", r.index);
  ImGui::SameLine();
  if (budget > 0) {
    ImGui::TextDisabled("%.1f of %.1f ms at %.0f Hz", r.ms(Stage::tracking), budget, c.info.rate_hz);
  } else {
    ImGui::TextDisabled("%.1f ms", r.ms(Stage::tracking));
  }
  const ImVec2 from = ImGui::GetCursorScreenPos();
  for (const Stage s : kParts) barRow(s, r.ms(s), full, false);
  barRow(Stage::tracking, r.ms(Stage::tracking), full, true);
  barRow(Stage::mapping, r.ms(Stage::mapping), full, false);
  barRow(Stage::snapshot, r.ms(Stage::snapshot), full, false);
  budgetMark(from, ImGui::GetCursorScreenPos().y, full, budget);
  if (c.status.mapping_queue > 0) valueRow("Mapping queue", format("%d jobs", c.status.mapping_queue));
}

// Stacked strip over frames: the slowest frame of each pixel column.
void stackedStrip(PanelContext& c, double budget) {
  const ImVec2 lo = ImGui::GetCursorScreenPos();
  const ImVec2 room = ImGui::GetContentRegionAvail();
  const ImVec2 hi{lo.x + std::max(8.0f, room.x), lo.y + std::max(grid(12), room.y - grid(1))};
  ImDrawList* list = ImGui::GetWindowDrawList();
  list->AddRectFilled(lo, hi, ink::canvas);
  ImGui::InvisibleButton("##strip", {hi.x - lo.x, hi.y - lo.y});
  Probe::record("timing:strip", lo, hi);
  const auto& records = c.caches.run.records();
  const int columns = std::max(1, static_cast<int>((hi.x - lo.x) / dp(2)));
  const int frames = std::max(1, static_cast<int>(records.size()));
  std::vector<const FrameRecord*> slowest(static_cast<std::size_t>(columns), nullptr);
  double full = budget * 1.2;
  for (int i = 0; i < frames; ++i) {
    const FrameRecord& r = records[static_cast<std::size_t>(i)];
    auto& slot = slowest[static_cast<std::size_t>(static_cast<long>(i) * columns / std::max(frames, columns))];
    if (!slot || partsSum(r) > partsSum(*slot)) slot = &r;
    full = std::max(full, std::min(partsSum(r), budget > 0 ? budget * 3 : 1e9));
  }
  const float width = (hi.x - lo.x) / static_cast<float>(std::min(columns, std::max(frames, columns)));
  for (int k = 0; k < columns; ++k) {
    const FrameRecord* r = slowest[static_cast<std::size_t>(k)];
    if (!r) continue;
    float y = hi.y;
    const float x = lo.x + static_cast<float>(k) * width;
    for (const Stage s : kParts) {
      const auto h = static_cast<float>(r->ms(s) / std::max(full, 1e-6)) * (hi.y - lo.y);
      const float top = std::max(lo.y, y - h);
      if (h > 0.2f) list->AddRectFilled({x, top}, {x + width, y}, stageColor(s));
      y = top;
    }
  }
  if (budget > 0 && budget < full) {
    const float y = std::round(hi.y - static_cast<float>(budget / full) * (hi.y - lo.y));
    dashedLine(list, {{lo.x, y}, {hi.x, y}}, ink::text, dp(1), dp(4), dp(4));
    const std::string text = format("%.0f ms", budget);
    outlinedText(list, {lo.x + grid(1), y - ImGui::GetTextLineHeight()}, ink::text, text.c_str());
  }
  if (!ImGui::IsItemHovered()) return;
  const int k = static_cast<int>((ImGui::GetIO().MousePos.x - lo.x) / width);
  if (k < 0 || k >= columns || !slowest[static_cast<std::size_t>(k)]) return;
  const FrameRecord& r = *slowest[static_cast<std::size_t>(k)];
  ImGui::SetTooltip("Frame %d  %.1f ms", r.index, partsSum(r));
  if (ImGui::IsMouseReleased(0)) c.view(r.index);
}

}  // namespace

void drawTimingPanel(PanelContext& c) {
  if (!c.record) return emptyState("No times yet", "Each processed frame adds the time of every stage");
  const double budget = c.info.rate_hz > 0 ? 1000 / c.info.rate_hz : 0;
  frameBars(c, budget);
  heading("Tracking time over frames");
  bool first = true;
  for (const Stage s : kParts) {
    if (!first) sameLineIfFits(legendWidth(stageName(s)) + grid(2));
    first = false;
    legendEntry(stageColor(s), Swatch::line, stageName(s));
  }
  stackedStrip(c, budget);
}

}  // namespace svoscope::ui
