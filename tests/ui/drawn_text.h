// SPDX-License-Identifier: MIT
// The texts that widgets draw by pen.h, with their places: what a figure notes of a frame.
#pragma once

#include <algorithm>
#include <cstdlib>
#include <functional>
#include <string>
#include <vector>

#include "ui/widgets/figure.h"

namespace svoscope::ui {

struct DrawnText {
  float x = 0, y = 0, width = 0, size = 0;  ///< pixels; y of the base line
  std::string text;                         ///< as in SVG: &lt; for <
};

inline std::vector<DrawnText> drawnTexts(const std::function<void()>& draw) {
  std::string svg;
  {
    Figure figure;
    draw();
    svg = figure.svg(0);
  }
  const auto number = [&](std::size_t from, const char* name) {
    const std::string key = std::string(name) + "=\"";
    const std::size_t at = svg.find(key, from);
    return std::strtof(svg.c_str() + at + key.size(), nullptr);
  };
  std::vector<DrawnText> texts;
  for (std::size_t at = svg.find("<text "); at != std::string::npos;
       at = svg.find("<text ", at + 1)) {
    const std::size_t open = svg.find('>', at) + 1, close = svg.find("</text>", open);
    texts.push_back({number(at, " x"), number(at, " y"), number(at, " textLength"),
                     number(at, " font-size"), svg.substr(open, close - open)});
  }
  return texts;
}

inline int countOf(const std::vector<DrawnText>& texts, const std::string& text) {
  return static_cast<int>(std::count_if(texts.begin(), texts.end(),
                                        [&](const DrawnText& t) { return t.text == text; }));
}

inline bool anyHas(const std::vector<DrawnText>& texts, const std::string& part) {
  return std::any_of(texts.begin(), texts.end(),
                     [&](const DrawnText& t) { return t.text.find(part) != std::string::npos; });
}

}  // namespace svoscope::ui
