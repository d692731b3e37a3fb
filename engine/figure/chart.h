// SPDX-License-Identifier: MIT
// Small line charts as an image: for figures written without a display.
#pragma once

#include <opencv2/core/mat.hpp>
#include <string>
#include <vector>

namespace svoscope {

/// Okabe-Ito colours, safe for colour-blind readers: KL blue, JS vermillion, its terms orange and
/// green.
enum class ChartColor { black, blue, vermillion, orange, green, grey };

struct ChartSeries {
  std::string name;
  ChartColor color = ChartColor::black;
  int dash = 0;              ///< px of dash and gap, 0: solid; colour is never the only cue
  std::vector<double> x, y;  ///< points that are not finite interrupt the line
};

struct ChartPanel {
  std::string title, x_label, y_label;  ///< labels with unit
  std::vector<ChartSeries> series;
  bool log_y = false;
  bool from_zero = true;  ///< the y axis starts at zero, unless log_y
};

/// Panels in rows of `columns`, each `width` x `height` px. CV_8UC3, white background.
cv::Mat drawCharts(const std::vector<ChartPanel>& panels, int columns, int width = 640,
                   int height = 440);

}  // namespace svoscope
