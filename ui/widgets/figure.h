// SPDX-License-Identifier: MIT
// A panel as a vector picture: while one is being taken, what widgets draw through pen.h is noted
// here, too, in the same pixels. Used by the UI thread only.
#pragma once

#include <imgui/imgui.h>

#include <opencv2/core/mat.hpp>
#include <string>
#include <vector>

namespace svoscope::ui {

class Figure {
 public:
  Figure();  ///< becomes the active one
  ~Figure();
  Figure(const Figure&) = delete;
  Figure& operator=(const Figure&) = delete;

  /// The figure being taken; null if none is.
  static Figure* active();

  /// Dashes of `on` and gaps of `off` pixels; `off` 0: solid.
  void polyline(const ImVec2* points, int count, ImU32 color, float width, bool closed,
                float on = 0, float off = 0);
  void polygon(const ImVec2* points, int count, ImU32 color);
  void circle(ImVec2 center, float radius, ImU32 color, float width);  ///< width 0: filled
  void text(ImVec2 at, ImU32 color, const char* text);      ///< upper left corner; lines at '\n'
  void image(ImVec2 lo, ImVec2 hi, const cv::Mat& pixels);  ///< not smoothed
  void pushClip(ImVec2 lo, ImVec2 hi);
  void popClip();

  bool empty() const { return lo_.x > hi_.x; }
  /// SVG 1.1 on `background`, as large as what was drawn.
  std::string svg(ImU32 background) const;

 private:
  void grow(ImVec2 p, float margin);

  Figure* before_;
  std::string elements_, clips_;
  std::vector<ImVec4> clip_stack_;
  int clip_count_ = 0;
  ImVec2 lo_{1e30f, 1e30f}, hi_{-1e30f, -1e30f};
};

}  // namespace svoscope::ui
