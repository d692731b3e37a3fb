// SPDX-License-Identifier: MIT
#include "engine/figure/svg.h"

#include <fmt/format.h>

#include <cmath>

namespace svoscope {

const char* const kSvgStyle = R"(svg{font-family:"DejaVu Sans",Verdana,sans-serif;font-size:11px}
svg .ink{fill:#1f2328}svg .dim{fill:#57606a}svg .title{fill:#1f2328;font-size:12px;font-weight:600}
svg .grid{stroke:#e3e6ea;fill:none}svg .axis{stroke:#8c959f;fill:none}
svg .truth{stroke:#6e7781;fill:none}svg .loss{stroke:#1f2328;fill:none}svg .ground{fill:#ffffff}
@media (prefers-color-scheme:dark){svg .ink,svg .title{fill:#dee2e7}svg .dim{fill:#929aa6}
svg .grid{stroke:#2b313a}svg .axis{stroke:#6b7480})"
                              R"(svg .truth{stroke:#c4c8ce}svg .loss{stroke:#f5f7fa}
svg .ground{fill:#18191d}}
)";

std::string xmlEscaped(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    switch (c) {
      case '&':
        escaped += "&amp;";
        break;
      case '<':
        escaped += "&lt;";
        break;
      case '>':
        escaped += "&gt;";
        break;
      case '"':
        escaped += "&quot;";
        break;
      case '\'':
        escaped += "&#39;";
        break;
      default: {
        const auto code = static_cast<unsigned char>(c);
        escaped += code < 32 && c != '\n' && c != '\t' ? '?' : c;
      }
    }
  }
  return escaped;
}

Svg::Svg(double width, double height, const std::string& label)
    : width_(width), height_(height), label_(label) {}

void Svg::line(FigurePoint a, FigurePoint b, const std::string& attributes) {
  body_ += fmt::format("<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" {}/>\n", a.x,
                       a.y, b.x, b.y, attributes);
}

void Svg::polyline(const std::vector<FigurePoint>& points, const std::string& attributes) {
  constexpr double kNear = 0.7;
  if (points.empty()) return;
  std::string text;
  FigurePoint last{-1e9, -1e9};
  for (std::size_t i = 0; i < points.size(); ++i) {
    const FigurePoint p = points[i];
    if (i + 1 < points.size() && std::hypot(p.x - last.x, p.y - last.y) < kNear) continue;
    text += fmt::format("{}{:.1f},{:.1f}", text.empty() ? "" : " ", p.x, p.y);
    last = p;
  }
  body_ += fmt::format("<polyline points=\"{}\" fill=\"none\" {}/>\n", text, attributes);
}

void Svg::rect(FigurePoint corner, double width, double height, const std::string& attributes) {
  body_ += fmt::format("<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" {}/>\n",
                       corner.x, corner.y, width, height, attributes);
}

void Svg::circle(FigurePoint centre, double radius, const std::string& attributes) {
  body_ += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:.1f}\" {}/>\n", centre.x,
                       centre.y, radius, attributes);
}

void Svg::cross(FigurePoint c, double r, const std::string& attributes) {
  body_ += fmt::format(
      "<path d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}M{:.1f} {:.1f}L{:.1f} {:.1f}\" {}/>\n", c.x - r,
      c.y - r, c.x + r, c.y + r, c.x - r, c.y + r, c.x + r, c.y - r, attributes);
}

void Svg::text(FigurePoint at, const std::string& text, TextAnchor anchor, const std::string& css) {
  const char* names[] = {"start", "middle", "end"};
  body_ +=
      fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\" class=\"{}\">{}</text>\n",
                  at.x, at.y, names[static_cast<int>(anchor)], css, xmlEscaped(text));
}

void Svg::turnedText(FigurePoint at, const std::string& text, const std::string& css) {
  body_ += fmt::format(
      "<text transform=\"translate({:.1f} {:.1f}) rotate(-90)\" text-anchor=\"middle\" "
      "class=\"{}\">{}</text>\n",
      at.x, at.y, css, xmlEscaped(text));
}

void Svg::beginClip(FigurePoint corner, double width, double height) {
  // A nested picture cuts at its border and needs no name that could clash with another's.
  body_ += fmt::format(
      "<svg x=\"{0:.1f}\" y=\"{1:.1f}\" width=\"{2:.1f}\" height=\"{3:.1f}\" "
      "viewBox=\"{0:.1f} {1:.1f} {2:.1f} {3:.1f}\">\n",
      corner.x, corner.y, width, height);
}

void Svg::endClip() { body_ += "</svg>\n"; }

std::string Svg::head(bool standalone) const {
  return fmt::format(
      "<svg {}viewBox=\"0 0 {:.0f} {:.0f}\" width=\"{:.0f}\" height=\"{:.0f}\" role=\"img\" "
      "aria-label=\"{}\">\n",
      standalone ? "xmlns=\"http://www.w3.org/2000/svg\" " : "", width_, height_, width_, height_,
      xmlEscaped(label_));
}

std::string Svg::inlined() const { return head(false) + body_ + "</svg>\n"; }

std::string Svg::standalone() const {
  return head(true) + "<style>\n" + kSvgStyle + "</style>\n" +
         fmt::format("<rect class=\"ground\" width=\"{:.0f}\" height=\"{:.0f}\"/>\n", width_,
                     height_) +
         body_ + "</svg>\n";
}

}  // namespace svoscope
