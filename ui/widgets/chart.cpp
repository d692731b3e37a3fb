// SPDX-License-Identifier: MIT
#include "ui/widgets/chart.h"

#include <algorithm>
#include <cmath>

#include "ui/palette.h"
#include "ui/theme.h"
#include "ui/widgets/axis_draw.h"
#include "ui/widgets/icons.h"
#include "ui/widgets/pen.h"
#include "ui/widgets/probe.h"

namespace svoscope::ui {

namespace {

constexpr float kFar = 1e5f;  // pixels beyond this only lose precision

ImVec2 bounded(ImVec2 p) { return {std::clamp(p.x, -kFar, kFar), std::clamp(p.y, -kFar, kFar)}; }

std::string tickText(double t, double step, bool log) {
  if (log) return logTickLabel(t);
  if (t != 0 && std::abs(step) < 1e-3) return format("%.1e", t);
  return tickLabel(t, step);
}

// Title and legend, wrapped within `width`; the height they take.
float legendLines(const ChartSpec& spec, ImVec2 at, float width) {
  ImDrawList* list = ImGui::GetWindowDrawList();
  const float font = ImGui::GetFontSize(), line = font + grid(0.5f);
  pen::text(list, at, ink::text, spec.title.c_str());
  float x = spec.title.empty() ? 0 : ImGui::CalcTextSize(spec.title.c_str()).x + grid(3), y = 0;
  for (const ChartLegend& entry : spec.legend) {
    const float w = legendWidth(entry.label.c_str());
    if (x > 0 && x + w > width) {
      x = 0;
      y += line;
    }
    drawSwatch(entry.swatch, {at.x + x + font * 0.36f, at.y + y + font / 2}, font * 0.28f,
               entry.color);
    pen::text(list, {at.x + x + font, at.y + y}, ink::dim, entry.label.c_str());
    x += w + grid(3);
  }
  return y + (spec.title.empty() && spec.legend.empty() ? 0 : line);
}

Range usable(Range r, bool log) {
  if (!std::isfinite(r.lo) || !std::isfinite(r.hi) || r.lo > r.hi)
    r = log ? Range{0.1, 10} : Range{0, 1};
  if (log && r.lo <= 0) r.lo = r.hi > 0 ? r.hi * 1e-3 : 1e-3;
  if (r.hi <= r.lo) return padded(r, 0.1, log);
  return r;
}

}  // namespace

Chart::Chart(const ChartSpec& spec)
    : list_(ImGui::GetWindowDrawList()), start_(ImGui::GetCursorScreenPos()) {
  ImGui::PushID(spec.id);
  ImGui::BeginGroup();
  const float width = spec.size.x > 0 ? spec.size.x : ImGui::GetContentRegionAvail().x;
  const float height = legendLines(spec, start_, width);
  bottom_ = start_.y + (spec.size.y > 0 ? spec.size.y : ImGui::GetFontSize() * 10);
  ImGui::SetCursorScreenPos({start_.x, start_.y + height});
  layOut(spec);
  if (!drawable()) return;
  axes(spec);
  ImGui::SetCursorScreenPos(lo_);
  ImGui::InvisibleButton("##area", {hi_.x - lo_.x, hi_.y - lo_.y});
  Probe::record(spec.id, lo_, hi_);
  mouse_ = ImGui::GetIO().MousePos;
  hovered_ = ImGui::IsItemHovered();
  const ImVec2 drag = ImGui::GetMouseDragDelta(0, 0);
  clicked_ = ImGui::IsItemDeactivated() && hovered_ && std::hypot(drag.x, drag.y) < 4;
  pen::pushClipRect(list_, lo_, hi_, true);
}

Chart::~Chart() {
  if (drawable()) pen::popClipRect(list_);
  ImGui::SetCursorScreenPos(start_);
  ImGui::Dummy({std::max(1.0f, hi_.x - start_.x), std::max(1.0f, bottom_ - start_.y)});
  ImGui::EndGroup();
  ImGui::PopID();
}

void Chart::layOut(const ChartSpec& spec) {
  const float font = ImGui::GetFontSize();
  const float width = spec.size.x > 0 ? spec.size.x : ImGui::GetContentRegionAvail().x;
  const float rows = static_cast<float>((spec.y_label.empty() ? 0 : 1) + spec.mark_rows);
  const float top = ImGui::GetCursorScreenPos().y + rows * font;
  lo_ = {std::round(start_.x + (spec.y_ticks ? font * 2.9f : grid(1.5f))),
         std::round(top + grid(0.5f))};
  hi_ = {std::round(start_.x + width - grid(1.5f)),
         std::round(bottom_ - font - grid(1) - (spec.x_label.empty() ? 0 : font))};
  x_ = {usable(spec.x, spec.log_x), lo_.x, hi_.x, spec.log_x};
  y_ = {usable(spec.y, spec.log_y), hi_.y, lo_.y, spec.log_y};
  free_from_.assign(static_cast<std::size_t>(spec.mark_rows), start_.x);
}

void Chart::axes(const ChartSpec& spec) {
  const float font = ImGui::GetFontSize();
  pen::rectFilled(list_, lo_, hi_, ink::canvas);
  const int count = std::max(3, static_cast<int>((hi_.y - lo_.y) / (font * 1.8f)));
  if (spec.y_ticks)
    drawYTicks(list_, lo_, hi_, y_, count,
               [&](double t, double step) { return tickText(t, step, spec.log_y); });
  if (!spec.y_label.empty()) {
    const float y = lo_.y - font * static_cast<float>(1 + spec.mark_rows) - grid(0.25f);
    pen::text(list_, {start_.x, std::round(y)}, ink::dim, spec.y_label.c_str());
  }
  xAxis(spec);
}

void Chart::xAxis(const ChartSpec& spec) {
  const float font = ImGui::GetFontSize();
  const int count = std::max(2, static_cast<int>((hi_.x - lo_.x) / (font * 4)));
  const auto ticks = spec.log_x ? logTicks(x_.data, count) : linearTicks(x_.data, count);
  const double step = ticks.size() > 1 ? ticks[1] - ticks[0] : x_.data.span();
  float free_from = lo_.x - font * 2;
  for (const double t : ticks) {
    const float x = std::round(x_.toPixel(t));
    if (x < lo_.x - 1 || x > hi_.x + 1) continue;
    pen::line(list_, {x, lo_.y}, {x, hi_.y}, ink::grid);
    const std::string text = tickText(t, step, spec.log_x);
    const float w = ImGui::CalcTextSize(text.c_str()).x;
    const float tx = std::clamp(x - w / 2, start_.x, hi_.x - w);
    if (tx < free_from) continue;
    free_from = tx + w + grid(1);
    pen::text(list_, {std::round(tx), hi_.y + grid(0.5f)}, ink::dim, text.c_str());
  }
  if (spec.x_label.empty()) return;
  const float w = ImGui::CalcTextSize(spec.x_label.c_str()).x;
  const float x = std::max(start_.x, std::round((lo_.x + hi_.x - w) / 2));
  pen::text(list_, {x, std::round(hi_.y + font + grid(0.5f))}, ink::dim, spec.x_label.c_str());
}

void Chart::line(const std::vector<float>& x, const std::vector<float>& y, const LineStyle& s) {
  if (!drawable() || x.size() != y.size()) return;
  for (auto& run : buildRuns(x.data(), y.data(), static_cast<int>(x.size()), x_, y_)) {
    for (ImVec2& p : run) p = bounded(p);
    if (run.size() == 1) pen::circleFilled(list_, run[0], dp(s.width), s.color, 8);
    dashedLine(list_, run, s.color, dp(s.width), dp(5), s.dashed ? dp(3.5f) : 0);
  }
}

void Chart::band(const std::vector<float>& x, const std::vector<float>& lo,
                 const std::vector<float>& hi, ImU32 color) {
  if (!drawable() || x.size() != lo.size() || x.size() != hi.size()) return;
  const ImDrawListFlags before = list_->Flags;
  list_->Flags &=
      ~ImDrawListFlags_AntiAliasedFill;  // neighbours must not fade at their common edge
  for (std::size_t i = 1; i < x.size(); ++i) {
    if (!std::isfinite(x[i - 1] + x[i] + lo[i - 1] + lo[i] + hi[i - 1] + hi[i])) continue;
    pen::quadFilled(list_, bounded(at(x[i - 1], hi[i - 1])), bounded(at(x[i], hi[i])),
                    bounded(at(x[i], lo[i])), bounded(at(x[i - 1], lo[i - 1])), color);
  }
  list_->Flags = before;
}

void Chart::area(const std::vector<float>& x, const std::vector<float>& y, ImU32 color) {
  band(x, std::vector<float>(x.size(), static_cast<float>(y_.data.lo)), y, color);
}

void Chart::point(double x, double y, PointShape shape, float radius, ImU32 color) {
  if (!drawable() || !std::isfinite(x) || !std::isfinite(y)) return;
  const ImVec2 p = bounded(at(x, y));
  const float r = dp(radius);
  switch (shape) {
    case PointShape::circle:
      pen::circleFilled(list_, p, r, color, 10);
      break;
    case PointShape::square:
      pen::rectFilled(list_, {p.x - r, p.y - r}, {p.x + r, p.y + r}, color);
      break;
    case PointShape::diamond:
      pen::quadFilled(list_, {p.x, p.y - r}, {p.x + r, p.y}, {p.x, p.y + r}, {p.x - r, p.y}, color);
      break;
    case PointShape::triangle:
      pen::triangleFilled(list_, {p.x, p.y - r}, {p.x + r, p.y + r}, {p.x - r, p.y + r}, color);
      break;
    case PointShape::cross:
      pen::line(list_, {p.x - r, p.y - r}, {p.x + r, p.y + r}, color, dp(1.5f));
      pen::line(list_, {p.x - r, p.y + r}, {p.x + r, p.y - r}, color, dp(1.5f));
      break;
  }
}

void Chart::errorBar(double x, double lo, double hi, ImU32 color) {
  if (!drawable() || !std::isfinite(x + lo + hi)) return;
  const ImVec2 a = bounded(at(x, lo)), b = bounded(at(x, hi));
  const float cap = dp(3);
  pen::line(list_, a, b, color, dp(1.2f));
  pen::line(list_, {a.x - cap, a.y}, {a.x + cap, a.y}, color, dp(1.2f));
  pen::line(list_, {b.x - cap, b.y}, {b.x + cap, b.y}, color, dp(1.2f));
}

void Chart::spanAt(double lo, double hi, float height, ImU32 color) {
  if (!drawable() || !std::isfinite(lo + hi)) return;
  const float y = hi_.y - height * (hi_.y - lo_.y), cap = dp(4);
  const float a = bounded({x_.toPixel(lo), y}).x, b = bounded({x_.toPixel(hi), y}).x;
  pen::line(list_, {a, y}, {b, y}, color, dp(2));
  pen::line(list_, {a, y - cap}, {a, y + cap}, color, dp(2));
  pen::line(list_, {b, y - cap}, {b, y + cap}, color, dp(2));
}

void Chart::markX(double value, const LineStyle& s, const std::string& label, int row) {
  if (!drawable() || !std::isfinite(value) || (x_.log && value <= 0)) return;
  const float x = std::round(x_.toPixel(value));
  if (x < lo_.x - 1 || x > hi_.x + 1) return;
  dashedLine(list_, {{x, lo_.y}, {x, hi_.y}}, s.color, dp(s.width), dp(4), s.dashed ? dp(4) : 0);
  marked_x_.push_back(x);
  if (label.empty()) return;
  if (!free_from_.empty()) return labelAbove(x, s.color, label);
  const float w = ImGui::CalcTextSize(label.c_str()).x;
  const float tx = x + grid(1) + w > hi_.x ? x - w - grid(1) : x + grid(1);
  outlinedText(list_, {tx, lo_.y + grid(0.5f) + static_cast<float>(row) * ImGui::GetFontSize()},
               ink::text, label.c_str());
}

// In the first row where nothing is in the way; marks come from left to right.
void Chart::labelAbove(float x, ImU32 color, const std::string& label) {
  const float font = ImGui::GetFontSize(), w = ImGui::CalcTextSize(label.c_str()).x;
  const float tx = std::round(std::clamp(x - w / 2, start_.x, std::max(start_.x, hi_.x - w)));
  for (std::size_t row = 0; row < free_from_.size(); ++row) {
    if (tx < free_from_[row]) continue;
    free_from_[row] = tx + w + grid(1.5f);
    pen::popClipRect(list_);
    const float y = lo_.y - font * static_cast<float>(row + 1) - grid(0.25f);
    pen::text(list_, {tx, std::round(y)}, color, label.c_str());
    pen::pushClipRect(list_, lo_, hi_, true);
    return;
  }
}

void Chart::markY(double value, const LineStyle& s, const std::string& label) {
  if (!drawable() || !std::isfinite(value) || (y_.log && value <= 0)) return;
  const float y = std::round(y_.toPixel(value));
  if (y < lo_.y - 1 || y > hi_.y + 1) return;
  dashedLine(list_, {{lo_.x, y}, {hi_.x, y}}, s.color, dp(s.width), dp(4), s.dashed ? dp(4) : 0);
  if (label.empty()) return;
  const float w = ImGui::CalcTextSize(label.c_str()).x, font = ImGui::GetFontSize();
  ImVec2 p{hi_.x - w - grid(1), y - font - 1 < lo_.y ? y + 1 : y - font - 1};
  const auto crossed = [&](float x) { return x > p.x - grid(1) && x < p.x + w + grid(1); };
  if (std::any_of(marked_x_.begin(), marked_x_.end(), crossed)) p.x = lo_.x + grid(1);
  pen::rectFilled(list_, {p.x - grid(0.5f), p.y}, {p.x + w + grid(0.5f), p.y + font},
                  withAlpha(ink::canvas, 0.5f));  // curves stay visible
  pen::text(list_, p, s.color, label.c_str());
}

void Chart::shadeX(double lo, double hi, ImU32 color) {
  if (!drawable() || !std::isfinite(lo + hi) || (x_.log && lo <= 0)) return;
  const float a = std::clamp(x_.toPixel(lo), lo_.x, hi_.x),
              b = std::clamp(x_.toPixel(hi), lo_.x, hi_.x);
  if (b > a) pen::rectFilled(list_, {a, lo_.y}, {b, hi_.y}, color);
}

std::optional<Chart::Box> Chart::dragged(bool& released) const {
  released = false;
  if (!drawable()) return std::nullopt;
  const ImGuiIO& io = ImGui::GetIO();
  const ImVec2 from = io.MouseClickedPos[0];
  const bool inside = from.x >= lo_.x && from.x <= hi_.x && from.y >= lo_.y && from.y <= hi_.y;
  released = ImGui::IsMouseReleased(0);
  if (!inside || !(ImGui::IsMouseDown(0) || released)) return std::nullopt;
  if (!ImGui::IsWindowFocused(ImGuiFocusedFlags_ChildWindows)) return std::nullopt;
  const ImVec2 to{std::clamp(io.MousePos.x, lo_.x, hi_.x), std::clamp(io.MousePos.y, lo_.y, hi_.y)};
  if (std::hypot(to.x - from.x, to.y - from.y) < 5) return std::nullopt;
  const auto ordered = [](double a, double b) { return std::pair(std::min(a, b), std::max(a, b)); };
  const auto [x0, x1] = ordered(x_.toData(from.x), x_.toData(to.x));
  const auto [y0, y1] = ordered(y_.toData(from.y), y_.toData(to.y));
  return Box{x0, x1, y0, y1};
}

void Chart::box(const Box& b, ImU32 color) {
  if (!drawable()) return;
  const ImVec2 p = bounded(at(b.x_lo, b.y_hi)), q = bounded(at(b.x_hi, b.y_lo));
  pen::rectFilled(list_, p, q, withAlpha(color, 0.12f));
  pen::rect(list_, p, q, color, 0, 0, dp(1.3f));
}

ChartGrid::ChartGrid(int charts, float least_width, float least_height, int most_columns) {
  start_ = ImGui::GetCursorScreenPos();
  const ImVec2 room = ImGui::GetContentRegionAvail();
  columns_ = std::clamp(static_cast<int>(room.x / least_width), 1,
                        std::max(1, std::min(most_columns, charts)));
  const int rows = (charts + columns_ - 1) / columns_;
  const float gap = grid(2);
  cell_.x =
      std::floor((room.x - gap * static_cast<float>(columns_ - 1)) / static_cast<float>(columns_));
  cell_.y = std::max(least_height, std::floor((room.y - gap * static_cast<float>(rows)) /
                                              static_cast<float>(rows)));
  cell_.y = std::min(cell_.y, least_height * 2.2f);
}

ImVec2 ChartGrid::next() {
  const float x = static_cast<float>(index_ % columns_), y = static_cast<float>(index_ / columns_);
  ImGui::SetCursorScreenPos(
      {start_.x + x * (cell_.x + grid(2)), start_.y + y * (cell_.y + grid(2))});
  ++index_;
  return cell_;
}

}  // namespace svoscope::ui
