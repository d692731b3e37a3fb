// SPDX-License-Identifier: MIT
// A picture of any quantity against any other: lines, areas, points, bars, marks, a legend, a
// read-out and a brush. Plots over frames, with zoom and a linked x axis, are in widgets/plot.h.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ui/widgets/controls.h"
#include "ui/widgets/plot_math.h"

namespace svoscope::ui {

struct ChartLegend {
  std::string label;
  ImU32 color = 0;
  Swatch swatch = Swatch::line;
};

struct ChartSpec {
  const char* id = "chart";      ///< probe label
  std::string title;             ///< first words of the legend line: what is shown
  std::string x_label, y_label;  ///< quantity and unit, below and above the axes
  Range x, y;
  bool log_x = false, log_y = false;
  bool y_ticks = true;  ///< densities need none
  int mark_rows = 0;    ///< rows above the data area for the labels of markX; 0: they stand inside
  ImVec2 size{0, 0};
  std::vector<ChartLegend> legend;
};

enum class PointShape { circle, diamond, cross, square, triangle };

struct LineStyle {
  ImU32 color = 0;
  float width = 1.5f;
  bool dashed = false;
};

/// Draws axes when made and the rest on request, clipped to the data area; done when destroyed.
class Chart {
 public:
  explicit Chart(const ChartSpec& spec);
  ~Chart();
  Chart(const Chart&) = delete;
  Chart& operator=(const Chart&) = delete;

  void line(const std::vector<float>& x, const std::vector<float>& y, const LineStyle& style);
  /// Between y and the bottom.
  void area(const std::vector<float>& x, const std::vector<float>& y, ImU32 color);
  void band(const std::vector<float>& x, const std::vector<float>& lo, const std::vector<float>& hi,
            ImU32 color);
  void point(double x, double y, PointShape shape, float radius, ImU32 color);
  /// Vertical error bar with caps.
  void errorBar(double x, double lo, double hi, ImU32 color);
  /// Horizontal bar with caps at a height of the data area (0 bottom, 1 top).
  void spanAt(double lo, double hi, float height, ImU32 color);
  /// Vertical line; the label stands in row `row` from the top, or above the data area if there are
  /// rows for that: then marks are made from left to right.
  void markX(double x, const LineStyle& style, const std::string& label = "", int row = 0);
  /// The label stands at the right end, or at the left one if a vertical line made before is there.
  void markY(double y, const LineStyle& style, const std::string& label = "");
  void shadeX(double lo, double hi, ImU32 color);

  bool drawable() const { return hi_.x - lo_.x > 12 && hi_.y - lo_.y > 12; }
  bool hovered() const { return hovered_; }
  bool clicked() const { return clicked_; }
  double mouseX() const { return x_.toData(mouse_.x); }
  double mouseY() const { return y_.toData(mouse_.y); }
  ImVec2 at(double x, double y) const { return {x_.toPixel(x), y_.toPixel(y)}; }
  ImVec2 lo() const { return lo_; }
  ImVec2 hi() const { return hi_; }

  struct Box {
    double x_lo, x_hi, y_lo, y_hi;
  };
  /// Rectangle being dragged, and whether it was let go in this frame.
  std::optional<Box> dragged(bool& released) const;
  void box(const Box& b, ImU32 color);

 private:
  void layOut(const ChartSpec& spec);
  void axes(const ChartSpec& spec);
  void xAxis(const ChartSpec& spec);
  void labelAbove(float x, ImU32 color, const std::string& label);

  ImDrawList* list_ = nullptr;
  ImVec2 start_, lo_, hi_, mouse_;
  Axis x_, y_;
  float bottom_ = 0;
  std::vector<float> free_from_;  ///< per row of labels above: pixel from which it is free
  std::vector<float> marked_x_;   ///< pixels of the vertical lines
  bool hovered_ = false, clicked_ = false;
};

/// Lays charts out in rows: equal cells, as many columns as fit `least_width`.
class ChartGrid {
 public:
  ChartGrid(int charts, float least_width, float least_height, int most_columns = 3);
  /// Goes to the next cell; its size.
  ImVec2 next();

 private:
  ImVec2 start_, cell_;
  int columns_ = 1, index_ = 0;
};

}  // namespace svoscope::ui
