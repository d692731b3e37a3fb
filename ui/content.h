// SPDX-License-Identifier: MIT
// What the host shows: draws one ImGui frame and says when it is done. The inspector implements
// it; tests bring tiny ones of their own.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace svoscope::ui {

class UiContent {
 public:
  virtual ~UiContent() = default;
  /// One frame's content, between NewFrame and Render; fills the display.
  virtual void draw() = 0;
  /// Colours and sizes on a fresh style, `scale` times their normal size. Fonts are the host's.
  virtual void applyTheme(float scale) { (void)scale; }
  virtual bool wantsClose() const { return false; }
  /// File name of a screenshot the user asked for, once.
  virtual std::optional<std::string> takeScreenshotRequest() { return std::nullopt; }
  virtual void filesDropped(const std::vector<std::string>& files) { (void)files; }
};

}  // namespace svoscope::ui
