// SPDX-License-Identifier: MIT
#include "ui/widgets/text.h"

#include <algorithm>
#include <cmath>
#include <cstdarg>
#include <cstdio>

#include "ui/palette.h"
#include "ui/theme.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/pen.h"

namespace svoscope::ui {

namespace {

constexpr const char* kEllipsis = "…";

float widthOf(const std::string& text) { return ImGui::CalcTextSize(text.c_str()).x; }

/// Calls `use` with each line of a text.
template <typename Use>
void eachLine(const std::string& text, const Use& use) {
  for (std::size_t from = 0; from <= text.size();) {
    const std::size_t end = std::min(text.find('\n', from), text.size());
    use(text.substr(from, end - from));
    from = end + 1;
  }
}

// Centred about cx; the height of the next line.
float centredLines(const std::string& text, float cx, float y, ImU32 color) {
  eachLine(text, [&](const std::string& line) {
    ImGui::GetWindowDrawList()->AddText({std::round(cx - widthOf(line) / 2), std::round(y)}, color,
                                        line.c_str());
    y += ImGui::GetTextLineHeight();
  });
  return y;
}

}  // namespace

std::string format(const char* pattern, ...) {
  va_list args, again;
  va_start(args, pattern);
  va_copy(again, args);
  const int length = std::vsnprintf(nullptr, 0, pattern, args);
  va_end(args);
  std::string text(static_cast<std::size_t>(std::max(0, length)), '\0');
  std::vsnprintf(text.data(), text.size() + 1, pattern, again);
  va_end(again);
  return text;
}

std::string counted(int count, const char* noun) {
  return format("%d %s%s", count, noun, count == 1 ? "" : "s");
}

void valueRow(const char* name, const std::string& value, ImU32 color) {
  const float start = ImGui::GetCursorPosX();
  ImGui::PushStyleColor(ImGuiCol_Text, toVec4(ink::dim));
  ImGui::TextUnformatted(name);
  pen::itemText(ink::dim, name);
  ImGui::PopStyleColor();
  const float column = start + ImGui::GetFontSize() * 9.5f;
  const float value_x = std::max(column, start + ImGui::GetItemRectSize().x + grid(2));
  ImGui::SameLine(0, 0);
  ImGui::SetCursorPosX(value_x);  // unlike SameLine(x), right in table columns, too
  float room = ImGui::GetContentRegionAvail().x;
  if (room < ImGui::GetFontSize() * 7 &&
      ImGui::CalcTextSize(value.c_str()).x > room) {  // below the name
    ImGui::NewLine();
    ImGui::SetCursorPosX(start + grid(3));
    room = ImGui::GetContentRegionAvail().x;
  }
  if (color) ImGui::PushStyleColor(ImGuiCol_Text, toVec4(color));
  const std::string shown = wrapped(value, room);
  ImGui::TextUnformatted(shown.c_str());
  pen::itemText(color ? color : ink::text, shown.c_str());
  if (color) ImGui::PopStyleColor();
}

void heading(const char* text) {
  ImGui::Dummy({0, grid(0.5f)});
  ImGui::TextUnformatted(text);
  pen::itemText(ink::text, text);
  const ImVec2 at = ImGui::GetItemRectMax();
  const float right = ImGui::GetWindowPos().x + ImGui::GetContentRegionMax().x;
  const float y = std::round((ImGui::GetItemRectMin().y + at.y) / 2);
  if (right > at.x + grid(2)) {
    pen::line(ImGui::GetWindowDrawList(), {at.x + grid(2), y}, {right, y}, ink::line);
  }
}

void note(const std::string& text) {
  ImGui::PushStyleColor(ImGuiCol_Text, toVec4(ink::dim));
  const std::string shown = wrapped(text, ImGui::GetContentRegionAvail().x);
  ImGui::TextUnformatted(shown.c_str());
  pen::itemText(ink::dim, shown.c_str());
  ImGui::PopStyleColor();
}

std::string wrapped(const std::string& text, float width) {
  std::string result = text;
  std::size_t line = 0;
  for (std::size_t blank = text.find(' '); blank != std::string::npos;) {
    const std::size_t next = text.find(' ', blank + 1);
    const std::size_t end = next == std::string::npos ? text.size() : next;
    if (ImGui::CalcTextSize(text.data() + line, text.data() + end).x > width) {
      result[blank] = '\n';
      line = blank + 1;
    }
    blank = next;
  }
  return result;
}

std::string elided(const std::string& text, float width) {
  if (widthOf(text) <= width) return text;
  std::string shown;
  for (std::size_t i = 0; i < text.size();) {
    std::size_t next = i + 1;
    while (next < text.size() && (text[next] & 0xC0) == 0x80)
      ++next;  // the rest of a UTF-8 character
    if (widthOf(text.substr(0, next) + kEllipsis) > width) break;
    shown = text.substr(0, next);
    i = next;
  }
  while (!shown.empty() && shown.back() == ' ') shown.pop_back();
  return shown + kEllipsis;
}

std::string fitted(const std::string& text, float width) {
  std::string result;
  eachLine(wrapped(text, width), [&](const std::string& line) {
    result += (result.empty() ? "" : "\n") + elided(line, width);
  });
  return result;
}

void elidedText(const std::string& text, ImU32 color) {
  const std::string shown = elided(text, ImGui::GetContentRegionAvail().x);
  ImGui::PushStyleColor(ImGuiCol_Text, toVec4(color));
  ImGui::TextUnformatted(shown.c_str());
  pen::itemText(color, shown.c_str());
  ImGui::PopStyleColor();
  if (shown != text) tooltip(text.c_str());
}

std::vector<float> sharedWidths(std::vector<float> widths, float room) {
  std::vector<float> sorted = widths;
  std::sort(sorted.begin(), sorted.end());
  float left = room;
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    const float share = std::max(0.0f, left / static_cast<float>(sorted.size() - i));
    if (sorted[i] > share) {
      for (float& width : widths) width = std::min(width, std::floor(share));
      return widths;
    }
    left -= sorted[i];
  }
  return widths;
}

void missingRow(const char* name, const char* why) {
  valueRow(name, "–", ink::dim);
  tooltip(why);
}

void emptyState(const char* title, const std::string& what_to_do) {
  const ImVec2 room = ImGui::GetContentRegionAvail();
  const float width = std::min(room.x, ImGui::GetFontSize() * 36);
  if (width < 1) return;
  const std::string head = wrapped(title, width), body = wrapped(what_to_do, width);
  const float height =
      ImGui::CalcTextSize(head.c_str()).y + ImGui::CalcTextSize(body.c_str()).y + grid(1);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float cx = at.x + room.x / 2;
  const float y =
      centredLines(head, cx, at.y + std::max(0.0f, (room.y - height) * 0.42f), ink::text);
  if (!body.empty()) centredLines(body, cx, y + grid(1), ink::dim);
}

}  // namespace svoscope::ui
