// SPDX-License-Identifier: MIT
// A small plot: axes, zoom and pan, a cursor tied to the frame, events, legend, read-out, export.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "ui/widgets/plot_math.h"

namespace svoscope::ui {

struct PlotSeries {
  std::string label;
  const std::vector<float>* x = nullptr;  ///< increasing
  const std::vector<float>* y = nullptr;
  ImU32 color = 0;
  bool dashed = false;
  const std::vector<float>* band_lo = nullptr;  ///< optional shaded band
  const std::vector<float>* band_hi = nullptr;
  bool dotted = false;  ///< finer than dashed
};

struct PlotMark {
  float x = 0;
  ImU32 color = 0;
  std::string text;
  int cross = -1;  ///< row from the top of a cross on a line through the plot: a loss; -1: none
};

struct PlotLevel {
  double y = 0;
  ImU32 color = 0;
  std::string label;
};

/// The x range several plots share. `fit`: all frames known, or those of the plot's series if
/// `known` is empty; a plot without data keeps the range.
struct LinkedX {
  Range range;
  bool fit = true;
  Range known{1, 0};  ///< lo > hi: empty
};

/// What one plot remembers between frames.
struct PlotState {
  Range y;
  bool fit_y = true;
  bool log_y = false;
  std::set<std::string> hidden;
};

struct PlotSpec {
  const char* id = "plot";  ///< also the probe label and file name
  std::string y_label;      ///< quantity and unit
  std::vector<PlotSeries> series;
  const std::vector<PlotMark>* marks = nullptr;
  std::vector<PlotLevel> levels;
  double cursor = -1;  ///< x of the frame cursor; below zero: none
  ImVec2 size{0, 0};
  bool show_x_labels = true;
  bool zero_based = false;  ///< keep y = 0 in view when fitting
};

struct PlotResult {
  bool clicked = false;
  double clicked_x = 0;
  bool export_csv = false;  ///< asked for in the context menu
};

PlotResult plot(const PlotSpec& spec, PlotState& state, LinkedX& linked);

/// Height of the plot `index` of `count` that fill `room` below each other, the last one with
/// labels of the frames: their data areas are equally high.
float stackedHeight(int index, int count, float room, float least);

/// Comma-separated values of the visible series within the visible range.
std::string plotCsv(const PlotSpec& spec, const PlotState& state, const LinkedX& linked);

}  // namespace svoscope::ui
