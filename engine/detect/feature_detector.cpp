// SPDX-License-Identifier: MIT
#include "engine/detect/feature_detector.h"

#include <algorithm>
#include <cmath>
#include <opencv2/features2d.hpp>
#include <opencv2/imgproc.hpp>

namespace svoscope {

OccupancyGrid::OccupancyGrid(int width, int height, int cell_px)
    : cell_px_(std::max(cell_px, 1)),
      columns_((width + cell_px_ - 1) / cell_px_),
      rows_((height + cell_px_ - 1) / cell_px_),
      taken_(static_cast<std::size_t>(columns_) * rows_, 0) {}

int OccupancyGrid::cellOf(const Vec2& px) const {
  const int c = std::clamp(static_cast<int>(px.x()) / cell_px_, 0, columns_ - 1);
  const int r = std::clamp(static_cast<int>(px.y()) / cell_px_, 0, rows_ - 1);
  return r * columns_ + c;
}

Vec2 OccupancyGrid::centreOf(int cell) const {
  return cell_px_ * Vec2(cell % columns_ + 0.5, cell / columns_ + 0.5);
}

OccupancyGrid OccupancyGrid::withCells(int cell_px) const {
  if (cell_px == cell_px_) return *this;
  OccupancyGrid other(columns_ * cell_px_, rows_ * cell_px_, cell_px);
  for (int cell = 0; cell < other.cells(); ++cell)
    if (taken(other.centreOf(cell))) other.taken_[cell] = 1;
  for (int cell = 0; cell < cells(); ++cell)
    if (taken(cell)) other.take(centreOf(cell));
  return other;
}

int scaledCell(int cell_px, int image_width) {
  return std::max(8, static_cast<int>(std::lround(cell_px * std::sqrt(image_width / 640.0))));
}

double cornerScore(const cv::Mat& image, int x, int y) {
  if (x < 5 || y < 5 || x >= image.cols - 5 || y >= image.rows - 5) return 0;
  float xx = 0, yy = 0, xy = 0;
  for (int v = -4; v < 4; ++v) {
    const std::uint8_t* row = image.ptr<std::uint8_t>(y + v) + x - 4;
    const std::uint8_t* up = image.ptr<std::uint8_t>(y + v - 1) + x - 4;
    const std::uint8_t* down = image.ptr<std::uint8_t>(y + v + 1) + x - 4;
    for (int u = 0; u < 8; ++u) {
      const float dx = 0.5f * (static_cast<float>(row[u + 1]) - static_cast<float>(row[u - 1]));
      const float dy = 0.5f * (static_cast<float>(down[u]) - static_cast<float>(up[u]));
      xx += dx * dx;
      yy += dy * dy;
      xy += dx * dy;
    }
  }
  const float mean = 1.0f / 64;
  const float half_trace = 0.5f * (xx + yy) * mean, half_diff = 0.5f * (xx - yy) * mean;
  const float smaller = half_trace - std::sqrt(half_diff * half_diff + xy * xy * mean * mean);
  return std::sqrt(std::max(smaller, 0.0f));
}

namespace {

void detectCorners(const Pyramid& pyramid, const DetectorParameters& p, const OccupancyGrid& grid,
                   std::vector<DetectedFeature>& best) {
  std::vector<cv::KeyPoint> keypoints;
  const int levels = std::min<int>(p.corner_levels, static_cast<int>(pyramid.size()));
  for (int level = 0; level < levels; ++level) {
    const cv::Mat& image = pyramid[level];
    cv::FAST(image, keypoints, p.fast_threshold, true, cv::FastFeatureDetector::TYPE_9_16);
    for (const cv::KeyPoint& k : keypoints) {
      const int x = static_cast<int>(k.pt.x), y = static_cast<int>(k.pt.y);
      if (x < p.border_px || y < p.border_px || x >= image.cols - p.border_px ||
          y >= image.rows - p.border_px)
        continue;
      const Vec2 px = fromLevel(Vec2(x, y), level);
      const int cell = grid.cellOf(px);
      if (grid.taken(cell)) continue;
      const double score = cornerScore(image, x, y);
      if (score < p.min_corner_score || score <= best[cell].score) continue;
      best[cell] = {px, level, FeatureType::corner, score, Vec2::Zero()};
    }
  }
}

/// Strongest gradient of each free cell without a corner, on the smoothed level 1.
void detectEdgelets(const Pyramid& pyramid, const DetectorParameters& p, const OccupancyGrid& grid,
                    std::vector<DetectedFeature>& best) {
  if (p.min_edge_gradient <= 0 || pyramid.size() < 2) return;
  cv::Mat smooth, dx, dy;
  cv::GaussianBlur(pyramid[1], smooth, cv::Size(3, 3), 0);
  cv::Scharr(smooth, dx, CV_16S, 1, 0);
  cv::Scharr(smooth, dy, CV_16S, 0, 1);
  // Scharr's kernel sums to 32 times the central difference per pixel.
  constexpr float kScharr = 1.0f / 32.0f;
  const auto least2 =
      static_cast<float>(p.min_edge_gradient * p.min_edge_gradient) / (kScharr * kScharr);
  std::vector<float> strongest(best.size(), least2);
  const int border = std::max(p.border_px, 5);
  for (int y = border; y < smooth.rows - border; ++y) {
    const auto* gx = dx.ptr<short>(y);
    const auto* gy = dy.ptr<short>(y);
    for (int x = border; x < smooth.cols - border; ++x) {
      const float m2 = static_cast<float>(gx[x]) * gx[x] + static_cast<float>(gy[x]) * gy[x];
      if (m2 < least2) continue;
      const Vec2 px = fromLevel(Vec2(x, y), 1);
      const int cell = grid.cellOf(px);
      if (m2 <= strongest[cell] || grid.taken(cell) ||
          (best[cell].score > 0 && best[cell].type == FeatureType::corner))
        continue;
      strongest[cell] = m2;
      const Vec2 dir = Vec2(gx[x], gy[x]).normalized();
      best[cell] = {px, 1, FeatureType::edgelet, std::sqrt(m2) * kScharr, dir};
    }
  }
}

}  // namespace

std::vector<DetectedFeature> detectFeatures(const Pyramid& pyramid, const DetectorParameters& p,
                                            const OccupancyGrid& grid) {
  std::vector<DetectedFeature> best(static_cast<std::size_t>(grid.cells()));
  detectCorners(pyramid, p, grid, best);
  detectEdgelets(pyramid, p, grid, best);
  std::vector<DetectedFeature> found;
  for (const DetectedFeature& f : best) {
    if (f.score > 0) found.push_back(f);
  }
  return found;
}

}  // namespace svoscope
