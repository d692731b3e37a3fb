// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cctype>

#include "ui/palette.h"
#include "ui/panels/panel.h"
#include "ui/panels/panel_context.h"
#include "ui/panels/run/run_options.h"
#include "ui/theme.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/probe.h"

namespace svoscope::ui {

namespace {

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char ch) { return std::tolower(ch); });
  return text;
}

bool matches(const Event& e, const std::string& filter) {
  return filter.empty() || lower(e.text).find(filter) != std::string::npos ||
         lower(eventName(e.kind)).find(filter) != std::string::npos;
}

void row(PanelContext& c, const Event& e, int id) {
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  ImGui::PushID(id);
  const std::string frame = format("%d", e.frame_index);
  const bool current = e.frame_index == c.viewedFrame();
  if (ImGui::Selectable(frame.c_str(), current, ImGuiSelectableFlags_SpanAllColumns))
    c.view(e.frame_index);
  Probe::record("log:" + frame, ImGui::GetItemRectMin(), ImGui::GetItemRectMax());
  ImGui::PopID();
  ImGui::TableNextColumn();
  legendEntry(eventColor(e.kind), Swatch::dot, eventName(e.kind));
  ImGui::TableNextColumn();
  elidedText(e.text, ink::text);
}

void draw(PanelContext& c) {
  const auto& events = c.caches.run.events();
  inputText("##log_filter", "Filter, for example lost", c.options<LogOptions>().filter,
            ImGui::GetFontSize() * 14);
  const std::string filter = lower(c.options<LogOptions>().filter);
  std::vector<int> shown;
  for (std::size_t i = events.size(); i-- > 0;) {
    if (matches(events[i], filter)) shown.push_back(static_cast<int>(i));
  }
  const int hidden = static_cast<int>(events.size() - shown.size());
  ImGui::SameLine();
  ImGui::AlignTextToFramePadding();
  if (hidden > 0)
    ImGui::TextColored(toVec4(okabe::orange), "%d hidden by the filter", hidden);
  else
    ImGui::TextDisabled("%s, newest first",
                        counted(static_cast<int>(shown.size()), "message").c_str());
  if (events.empty())
    return emptyState("No messages yet", "Keyframes, losses and warnings appear here");
  constexpr ImGuiTableFlags kFlags =
      ImGuiTableFlags_ScrollY | ImGuiTableFlags_RowBg | ImGuiTableFlags_SizingFixedFit;
  if (!ImGui::BeginTable("##log", 3, kFlags)) return;
  ImGui::TableSetupScrollFreeze(0, 1);
  ImGui::TableSetupColumn("Frame");
  ImGui::TableSetupColumn("Kind");
  ImGui::TableSetupColumn("Message", ImGuiTableColumnFlags_WidthStretch);
  ImGui::TableHeadersRow();
  ImGuiListClipper clipper;
  clipper.Begin(static_cast<int>(shown.size()));
  while (clipper.Step()) {
    for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
      const int at = shown[static_cast<std::size_t>(i)];
      row(c, events[static_cast<std::size_t>(at)], at);
    }
  }
  ImGui::EndTable();
}

}  // namespace

extern const Panel kLogPanel{"Log", draw};

}  // namespace svoscope::ui
