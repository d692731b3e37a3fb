// SPDX-License-Identifier: MIT
#include "engine/tracking/initializer_features.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

namespace svoscope {

namespace {

constexpr int kBorder = 12;  // px of the level: the finest patch has to fit

/// Best response of each cell of one level.
struct CellMaps {
  cv::Mat corner;  ///< CV_32F, smaller eigenvalue of the structure tensor
  cv::Mat gx, gy;  ///< CV_32F, smoothed gradients, grey levels per px
};

CellMaps responses(const cv::Mat& image) {
  CellMaps maps;
  cv::cornerMinEigenVal(image, maps.corner, 5, 3);
  cv::Mat smooth;
  cv::GaussianBlur(image, smooth, {3, 3}, 0);
  cv::Scharr(smooth, maps.gx, CV_32F, 1, 0, 1.0 / 32);
  cv::Scharr(smooth, maps.gy, CV_32F, 0, 1, 1.0 / 32);
  return maps;
}

/// cornerMinEigenVal scales 8-bit images to [0, 1] and gradients by 2: back to grey levels per px.
double cornerScore(float eigenvalue) { return std::sqrt(std::max(0.0f, eigenvalue)) * 255.0 / 2.0; }

cv::Rect cellRect(const cv::Mat& image, int row, int column, int cell) {
  const int x0 = std::max(kBorder, column * cell), y0 = std::max(kBorder, row * cell);
  const int x1 = std::min(image.cols - kBorder, (column + 1) * cell);
  const int y1 = std::min(image.rows - kBorder, (row + 1) * cell);
  return {x0, y0, std::max(0, x1 - x0), std::max(0, y1 - y0)};
}

Vec2 toLevelZero(int x, int y, int level) {
  const double s = 1 << level;
  return {(x + 0.5) * s - 0.5, (y + 0.5) * s - 0.5};
}

StartFeature bestCorner(const CellMaps& maps, const cv::Rect& rect, int level) {
  StartFeature feature;
  for (int y = rect.y; y < rect.y + rect.height; ++y) {
    const float* row = maps.corner.ptr<float>(y);
    for (int x = rect.x; x < rect.x + rect.width; ++x) {
      if (cornerScore(row[x]) <= feature.score) continue;
      feature.score = cornerScore(row[x]);
      feature.px = toLevelZero(x, y, level);
    }
  }
  feature.level = level;
  return feature;
}

StartFeature bestEdgelet(const CellMaps& maps, const cv::Rect& rect, int level) {
  StartFeature feature;
  feature.type = FeatureType::edgelet;
  feature.level = level;
  double best = 0;
  for (int y = rect.y; y < rect.y + rect.height; ++y)
    for (int x = rect.x; x < rect.x + rect.width; ++x) {
      const Vec2 g(maps.gx.at<float>(y, x), maps.gy.at<float>(y, x));
      if (g.squaredNorm() <= best) continue;
      best = g.squaredNorm();
      feature.px = toLevelZero(x, y, level);
      feature.gradient_dir = g.normalized();
    }
  feature.score = std::sqrt(best);
  return feature;
}

bool nearAny(const std::vector<StartFeature>& features, const Vec2& px, double distance) {
  return std::any_of(features.begin(), features.end(), [&](const StartFeature& f) {
    return (f.px - px).squaredNorm() < distance * distance;
  });
}

struct Thresholds {
  double corner, edgelet;  ///< grey levels per px
  int cells;               ///< about this many in the image
};

std::vector<StartFeature> detectOnce(const std::vector<CellMaps>& maps, const cv::Mat& image,
                                     const Thresholds& limits, int& corners) {
  const double area = static_cast<double>(image.cols) * image.rows;
  const int cell = std::max(12, static_cast<int>(std::sqrt(area / limits.cells)));
  std::vector<StartFeature> out;
  corners = 0;
  for (int r = 0; r * cell < image.rows; ++r)
    for (int c = 0; c * cell < image.cols; ++c) {
      StartFeature best = bestCorner(maps[0], cellRect(image, r, c, cell), 0);
      if (best.score < limits.corner) best = bestEdgelet(maps[0], cellRect(image, r, c, cell), 0);
      if (best.score < (best.type == FeatureType::corner ? limits.corner : limits.edgelet))
        continue;
      if (nearAny(out, best.px, 0.4 * cell)) continue;
      corners += best.type == FeatureType::corner;
      out.push_back(best);
    }
  return out;
}

}  // namespace

std::vector<StartFeature> detectStartFeatures(const std::vector<cv::Mat>& pyramid, int wanted) {
  const std::vector<CellMaps> maps{responses(pyramid[0])};
  std::vector<StartFeature> best;
  const int n = std::max(1, wanted);
  for (const Thresholds& limits : {Thresholds{4.0, 6.0, n}, Thresholds{2.5, 5.0, 3 * n / 2},
                                   Thresholds{1.5, 4.0, 2 * n}, Thresholds{0.8, 2.0, 2 * n}}) {
    int corners = 0;
    best = detectOnce(maps, pyramid[0], limits, corners);
    if (corners >= wanted / 2) break;
    if (limits.corner < 2 && static_cast<int>(best.size()) >= wanted / 2) break;
  }
  return best;
}

}  // namespace svoscope
