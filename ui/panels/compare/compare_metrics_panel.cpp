// SPDX-License-Identifier: MIT
#include <algorithm>

#include "ui/palette.h"
#include "ui/panels/compare/compare_panel.h"
#include "ui/panels/panel.h"
#include "ui/theme.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/probe.h"

namespace svoscope::ui {

namespace {

void header(PanelContext& c, const CompareData& data) {
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  ImGui::TextDisabled("Frames so far: %d", c.engineFrame() + 1);
  for (std::size_t i = 0; i < data.runs().size(); ++i) {
    const RunStyle& style = data.runs()[i].style;
    ImGui::TableNextColumn();
    legendEntry(style.color, swatchOf(style.dash), style.label.c_str());
    const bool current = static_cast<int>(i) == c.runs.current();
    tooltip(style.poses_only ? "Trajectory of another system"
            : current        ? "The current run"
                             : "Click to make it the current run");
    if (ImGui::IsItemHovered() && ImGui::IsMouseClicked(0) && !style.poses_only)
      c.state.run_request = static_cast<int>(i);
  }
}

void stateRow(PanelContext& c) {
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  if (c.viewedFrame() < 0)
    ImGui::TextDisabled("No frame yet");
  else
    ImGui::TextDisabled("Frame %d", c.viewedFrame());
  for (int i = 0; i < c.runs.size(); ++i) {
    ImGui::TableNextColumn();
    const FrameRecord* record =
        c.all_caches[static_cast<std::size_t>(i)]->run.find(c.viewedFrame());
    if (!record) {
      ImGui::TextDisabled("–");
    } else if (c.runs.style(i).poses_only) {
      ImGui::TextDisabled("%s", record->pose_good ? "pose" : "no pose");
    } else {
      legendEntry(stateColor(record->state), Swatch::dot, stateLabel(record->state));
      if (!record->reason.empty()) tooltip(record->reason.c_str());
    }
  }
}

float leastWidth(const CompareData& data) {
  float width = ImGui::GetFontSize() * 8.5f;
  for (const ComparedRun& run : data.runs()) {
    width += std::max(legendWidth(run.style.label.c_str()), ImGui::GetFontSize() * 5.5f) + grid(3);
  }
  return width;
}

void metricTable(PanelContext& c, const CompareData& data) {
  const bool truth = !c.info.ground_truth.empty();
  for (const MetricRow& row : metricRows(data, truth)) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::TextDisabled("%s", row.name.c_str());
    tooltip(row.hint.c_str());
    for (std::size_t i = 0; i < row.values.size(); ++i) {
      ImGui::TableNextColumn();
      const bool best =
          row.best >= 0 && row.values[i] == row.values[static_cast<std::size_t>(row.best)];
      ImGui::PushStyleColor(ImGuiCol_Text, toVec4(best ? ink::selected : ink::dim));
      ImGui::TextUnformatted(row.values[i].c_str());
      ImGui::PopStyleColor();
      if (!best) continue;  // underlined: brightness alone is easily missed
      const ImVec2 lo = ImGui::GetItemRectMin(), hi = ImGui::GetItemRectMax();
      ImGui::GetWindowDrawList()->AddLine({lo.x, hi.y}, {hi.x, hi.y}, ink::selected, dp(1));
    }
  }
}

}  // namespace

Swatch swatchOf(Dash dash) {
  return dash == Dash::solid    ? Swatch::line
         : dash == Dash::dashed ? Swatch::dashed
                                : Swatch::dotted;
}

bool updateComparison(PanelContext& c) {
  if (c.runs.size() < 2) return false;
  std::vector<CompareSource> sources;
  for (const auto& caches : c.all_caches) sources.push_back({&caches->run, &caches->truth});
  c.compare.update(c.runs, sources, static_cast<Alignment>(c.state.align_mode), !c.status.playing);
  return c.engineFrame() >= 0;
}

bool comparing(PanelContext& c) {
  if (c.runs.size() > 1) {
    updateComparison(c);
    return true;
  }
  emptyState("Only one run is open",
             "Open several on this sequence with --method all, or add --with RECORDING or "
             "--trajectory FILE");
  return false;
}

std::string runStateText(const RunStyle& style, const FrameRecord* record) {
  if (!record) return "no such frame";
  if (style.poses_only) return record->pose_good ? "pose" : "no pose";
  if (record->state == TrackingState::tracking)
    return stateLabel(record->state) + format(", %d inliers", record->funnel.inliers);
  return stateSentence(*record);
}

void runTitle(PanelContext&, const RunStyle& style, const FrameRecord* record) {
  legendEntry(style.color, swatchOf(style.dash), style.label.c_str());
  ImGui::SameLine(0, grid(2));
  const bool lost = record && !style.poses_only && record->state == TrackingState::lost;
  const std::string text = runStateText(style, record);
  std::string shown = text;
  const float room = std::max(1.0f, ImGui::GetContentRegionAvail().x - grid(1));
  if (const auto comma = text.find(", ");
      comma != std::string::npos && ImGui::CalcTextSize(text.c_str()).x > room) {
    shown = text.substr(comma + 2);  // that it tracks is plain from the number
  }
  elidedText(shown, lost ? okabe::orange : ink::dim);
  tooltip(text.c_str());
}

namespace {

void draw(PanelContext& c) {
  if (!comparing(c)) return;
  const CompareData& data = c.compare;
  const int columns = static_cast<int>(data.runs().size()) + 1;
  ImGui::PushStyleVar(ImGuiStyleVar_CellPadding, {grid(1), grid(0.5f)});
  const ImGuiTableFlags look =
      ImGuiTableFlags_NoSavedSettings | ImGuiTableFlags_RowBg | ImGuiTableFlags_BordersInnerV;
  // Where columns would be cut off, the table scrolls sideways.
  const bool wide = ImGui::GetContentRegionAvail().x >= leastWidth(data);
  const ImGuiTableFlags flags =
      look |
      (wide ? ImGuiTableFlags_SizingStretchProp
            : ImGuiTableFlags_SizingFixedFit | ImGuiTableFlags_ScrollX | ImGuiTableFlags_ScrollY);
  if (ImGui::BeginTable("##metrics", columns, flags)) {
    header(c, data);
    stateRow(c);
    metricTable(c, data);
    ImGui::EndTable();
  }
  ImGui::PopStyleVar();
  if (c.info.ground_truth.empty()) return note("Without ground truth there are no errors");
  for (const ComparedRun& run : data.runs()) {
    if (!run.problem.empty()) note(run.style.label + ": " + run.problem);
  }
}

std::string csv(PanelContext& c) {
  return updateComparison(c) ? metricsCsv(c.compare, !c.info.ground_truth.empty()) : std::string();
}

}  // namespace

extern const Panel kCompareMetricsPanel{"Compare metrics", draw, csv};

}  // namespace svoscope::ui
