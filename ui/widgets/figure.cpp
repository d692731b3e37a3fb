// SPDX-License-Identifier: MIT
#include "ui/widgets/figure.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgcodecs.hpp>

#include "ui/widgets/controls.h"

namespace svoscope::ui {

namespace {

Figure* g_active = nullptr;

std::string paint(const char* what, ImU32 color) {
  const unsigned r = color >> IM_COL32_R_SHIFT & 255, g = color >> IM_COL32_G_SHIFT & 255,
                 b = color >> IM_COL32_B_SHIFT & 255, a = color >> IM_COL32_A_SHIFT & 255;
  std::string text = format("%s=\"#%02x%02x%02x\"", what, r, g, b);
  if (a < 255) text += format(" %s-opacity=\"%.3g\"", what, a / 255.0);
  return text;
}

std::string pointList(const ImVec2* points, int count) {
  std::string text;
  for (int i = 0; i < count; ++i)
    text += format(i ? " %.5g,%.5g" : "%.5g,%.5g", points[i].x, points[i].y);
  return text;
}

std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      default:
        out += c;
    }
  }
  return out;
}

std::string base64(const std::vector<unsigned char>& bytes) {
  static const char* digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t left = std::min<std::size_t>(3, bytes.size() - i);
    unsigned word = static_cast<unsigned>(bytes[i]) << 16;
    if (left > 1) word |= static_cast<unsigned>(bytes[i + 1]) << 8;
    if (left > 2) word |= bytes[i + 2];
    for (std::size_t k = 0; k < 4; ++k) out += k <= left ? digits[word >> (18 - 6 * k) & 63] : '=';
  }
  return out;
}

}  // namespace

Figure::Figure() : before_(g_active) { g_active = this; }
Figure::~Figure() { g_active = before_; }
Figure* Figure::active() { return g_active; }

void Figure::grow(ImVec2 p, float margin) {
  ImVec4 c{-1e30f, -1e30f, 1e30f, 1e30f};
  if (!clip_stack_.empty()) c = clip_stack_.back();
  if (!std::isfinite(p.x + p.y)) return;
  lo_ = {std::min(lo_.x, std::clamp(p.x - margin, c.x, c.z)),
         std::min(lo_.y, std::clamp(p.y - margin, c.y, c.w))};
  hi_ = {std::max(hi_.x, std::clamp(p.x + margin, c.x, c.z)),
         std::max(hi_.y, std::clamp(p.y + margin, c.y, c.w))};
}

void Figure::polyline(const ImVec2* points, int count, ImU32 color, float width, bool closed,
                      float on, float off) {
  for (int i = 0; i < count; ++i) grow(points[i], width / 2);
  elements_ +=
      format("<%s points=\"", closed ? "polygon" : "polyline") + pointList(points, count) +
      "\" fill=\"none\" " + paint("stroke", color) + format(" stroke-width=\"%.3g\"", width) +
      (off > 0 ? format(" stroke-dasharray=\"%.3g %.3g\"", on, off) : std::string()) + "/>\n";
}

void Figure::polygon(const ImVec2* points, int count, ImU32 color) {
  for (int i = 0; i < count; ++i) grow(points[i], 0);
  elements_ +=
      "<polygon points=\"" + pointList(points, count) + "\" " + paint("fill", color) + "/>\n";
}

void Figure::circle(ImVec2 center, float radius, ImU32 color, float width) {
  grow(center, radius + width / 2);
  elements_ += format("<circle cx=\"%.5g\" cy=\"%.5g\" r=\"%.3g\" ", center.x, center.y, radius);
  elements_ += width > 0 ? "fill=\"none\" " + paint("stroke", color) +
                               format(" stroke-width=\"%.3g\"/>\n", width)
                         : paint("fill", color) + "/>\n";
}

void Figure::text(ImVec2 at, ImU32 color, const char* text) {
  const float size = ImGui::GetFontSize();
  std::string rest = text;
  while (!rest.empty()) {
    const std::size_t end = std::min(rest.find('\n'), rest.size());
    const std::string line = rest.substr(0, end);
    rest.erase(0, std::min(rest.size(), end + 1));
    const float width = ImGui::CalcTextSize(line.c_str()).x;
    if (width > 0) {
      grow(at, 0);
      grow({at.x + width, at.y + size}, 0);
      // The length keeps the layout where another font stands in.
      elements_ += format("<text x=\"%.5g\" y=\"%.5g\" textLength=\"%.5g\" ", at.x,
                          at.y + 0.8f * size, width) +
                   format("lengthAdjust=\"spacingAndGlyphs\" font-size=\"%.3g\" ", 0.86f * size) +
                   paint("fill", color) + ">" + escaped(line) + "</text>\n";
    }
    at.y += size;
  }
}

void Figure::image(ImVec2 lo, ImVec2 hi, const cv::Mat& pixels) {
  std::vector<unsigned char> png;
  if (pixels.empty() || !cv::imencode(".png", pixels, png)) return;
  grow(lo, 0);
  grow(hi, 0);
  elements_ += format("<image x=\"%.5g\" y=\"%.5g\" width=\"%.5g\" height=\"%.5g\" ", lo.x, lo.y,
                      hi.x - lo.x, hi.y - lo.y) +
               "preserveAspectRatio=\"none\" image-rendering=\"pixelated\" "
               "xlink:href=\"data:image/png;base64," +
               base64(png) + "\"/>\n";
}

void Figure::pushClip(ImVec2 lo, ImVec2 hi) {
  ImVec4 clip{lo.x, lo.y, std::max(lo.x, hi.x), std::max(lo.y, hi.y)};
  clip_stack_.push_back(clip);
  ++clip_count_;
  clips_ += format(
      "<clipPath id=\"c%d\"><rect x=\"%.5g\" y=\"%.5g\" width=\"%.5g\" "
      "height=\"%.5g\"/></clipPath>\n",
      clip_count_, clip.x, clip.y, clip.z - clip.x, clip.w - clip.y);
  elements_ += format("<g clip-path=\"url(#c%d)\">\n", clip_count_);
}

void Figure::popClip() {
  if (clip_stack_.empty()) return;
  clip_stack_.pop_back();
  elements_ += "</g>\n";
}

std::string Figure::svg(ImU32 background) const {
  const float margin = 4;
  const float x = std::floor(lo_.x - margin), y = std::floor(lo_.y - margin);
  const float width = std::ceil(hi_.x + margin) - x, height = std::ceil(hi_.y + margin) - y;
  std::string text =
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" "
      "xmlns:xlink=\"http://www.w3.org/1999/xlink\" version=\"1.1\" ";
  text += format("width=\"%g\" height=\"%g\" viewBox=\"%g %g %g %g\" ", width, height, x, y, width,
                 height);
  text += "font-family=\"DejaVu Sans, Verdana, sans-serif\" xml:space=\"preserve\">\n<defs>\n" +
          clips_ + "</defs>\n";
  text += format("<rect x=\"%g\" y=\"%g\" width=\"%g\" height=\"%g\" ", x, y, width, height) +
          paint("fill", background) + "/>\n";
  text += elements_;
  for (std::size_t i = 0; i < clip_stack_.size(); ++i) text += "</g>\n";
  return text + "</svg>\n";
}

}  // namespace svoscope::ui
