// SPDX-License-Identifier: MIT
#include "ui/widgets/toasts.h"

#include <algorithm>

#include "ui/palette.h"
#include "ui/theme.h"
#include "ui/widgets/controls.h"

namespace svoscope::ui {

void Toasts::add(std::string text, bool is_error) {
  const float seconds = is_error ? 10.0f : 4.0f;
  for (Toast& t : toasts_) {
    if (t.text != text) continue;
    ++t.count;
    t.seconds_left = seconds;
    return;
  }
  toasts_.push_back({std::move(text), is_error, seconds, 1});
  if (toasts_.size() > 5) toasts_.erase(toasts_.begin());
}

void Toasts::draw(ImVec2 bottom_right) {
  ImDrawList* list = ImGui::GetForegroundDrawList();
  const float wrap = ImGui::GetFontSize() * 28;
  float y = bottom_right.y;
  for (std::size_t i = toasts_.size(); i-- > 0;) {
    Toast& t = toasts_[i];
    t.seconds_left -= ImGui::GetIO().DeltaTime;
    const float alpha = std::clamp(t.seconds_left * 2, 0.0f, 1.0f);
    const std::string text = t.count > 1 ? t.text + format(" (%d times)", t.count) : t.text;
    const ImVec2 size = ImGui::CalcTextSize(text.c_str(), nullptr, false, wrap);
    const float pad = grid(2);
    const ImVec2 hi{bottom_right.x, y};
    const ImVec2 lo{hi.x - size.x - 3 * pad, hi.y - size.y - 2 * pad};
    list->AddRectFilled(lo, hi, withAlpha(IM_COL32(38, 43, 51, 255), 0.97f * alpha), dp(4));
    list->AddRectFilled(lo, {lo.x + dp(3), hi.y},
                        withAlpha(t.is_error ? okabe::vermillion : ink::accent, alpha), dp(2));
    list->AddText(ImGui::GetFont(), ImGui::GetFontSize(), {lo.x + 2 * pad, lo.y + pad},
                  withAlpha(ink::text, alpha), text.c_str(), nullptr, wrap);
    y = lo.y - grid(1);
  }
  toasts_.erase(std::remove_if(toasts_.begin(), toasts_.end(),
                               [](const Toast& t) { return t.seconds_left <= 0; }),
                toasts_.end());
}

}  // namespace svoscope::ui
