// SPDX-License-Identifier: MIT
#include "engine/dataset/synthetic/patterns_detail.h"

#include <cmath>

namespace svoscope::synthetic {

cv::Size Surface::pixels() const {
  return {std::max(8, static_cast<int>(std::lround(width / texel))),
          std::max(8, static_cast<int>(std::lround(height / texel)))};
}

cv::Mat cloudNoise(cv::Size size, std::uint64_t seed, double coarse, int octaves, double stretch) {
  cv::Mat sum(size, CV_32FC1, cv::Scalar(0));
  double amplitude = 0.55, cell = coarse;
  for (int o = 0; o < octaves && cell >= 1.0; ++o, cell *= 0.5, amplitude *= 0.72) {
    const int cols = static_cast<int>(size.width / (cell * stretch)) + 3;
    const int rows = static_cast<int>(size.height / cell) + 3;
    cv::Mat grid(rows, cols, CV_32FC1);
    Random random(mixSeed(seed, 100 + o));
    for (int y = 0; y < rows; ++y)
      for (int x = 0; x < cols; ++x)
        grid.at<float>(y, x) = static_cast<float>(random.uniform(-1, 1));
    cv::Mat octave;
    cv::resize(grid, octave, size, 0, 0, cv::INTER_CUBIC);
    cv::scaleAdd(octave, amplitude, sum, sum);
  }
  return sum;
}

void drawShape(cv::Mat& image, Random& random, cv::Point2d centre, double radius, double gray) {
  const int kind = random.below(4);
  const double turn = random.uniform(0, 2 * CV_PI);
  if (kind == 0) {
    const cv::Size axes(std::max(1, static_cast<int>(radius)),
                        std::max(1, static_cast<int>(radius * random.uniform(0.4, 1))));
    cv::ellipse(image, cv::Point(centre), axes, turn * 180 / CV_PI, 0, 360, cv::Scalar(gray),
                cv::FILLED, cv::LINE_AA);
    return;
  }
  const int corners = kind == 1 ? 3 + random.below(4) : 4;
  const double flat = kind == 1 ? 1.0 : random.uniform(0.15, 1);
  const int kFraction = 4;  // bits of a pixel
  std::vector<cv::Point> polygon;
  for (int i = 0; i < corners; ++i) {
    const double jitter = kind == 1 ? random.uniform(-0.3, 0.3) : 0;
    const double a = 2 * CV_PI * (i + 0.5 + jitter) / corners;
    const double u = radius * std::cos(a), v = flat * radius * std::sin(a);
    const cv::Point2d p = centre + cv::Point2d(u * std::cos(turn) - v * std::sin(turn),
                                               u * std::sin(turn) + v * std::cos(turn));
    polygon.emplace_back(static_cast<int>(std::lround(p.x * (1 << kFraction))),
                         static_cast<int>(std::lround(p.y * (1 << kFraction))));
  }
  cv::fillConvexPoly(image, polygon, cv::Scalar(gray), cv::LINE_AA, kFraction);
}

void drawShapes(cv::Mat& image, cv::Rect area, Random& random, double mean, double contrast,
                double largest_px, double smallest_px, double coverage) {
  area &= cv::Rect(0, 0, image.cols, image.rows);
  if (area.empty()) return;
  cv::Mat canvas = image(area);
  for (double radius = largest_px; radius >= smallest_px; radius /= 1.6) {
    // Small shapes cover less than large ones: otherwise they bury them.
    const double share = coverage * std::pow(radius / largest_px, 0.45);
    const int count = static_cast<int>(std::ceil(share * area.area() / (2.0 * radius * radius)));
    for (int i = 0; i < count; ++i) {
      const cv::Point2d centre{random.uniform(0, area.width), random.uniform(0, area.height)};
      const double gray = mean + contrast * random.uniform(-1, 1);
      drawShape(canvas, random, centre, radius * random.uniform(0.7, 1.3), gray);
    }
  }
}

void drawPanel(cv::Mat& image, cv::Rect r, double gray, int edge) {
  const auto bar = [&](cv::Rect b, double value) {
    cv::rectangle(image, b, cv::Scalar(value), cv::FILLED);
  };
  bar(r, gray);
  bar({r.x, r.y, r.width, edge}, std::min(250.0, gray * 1.25));
  bar({r.x, r.y, edge, r.height}, std::min(250.0, gray * 1.15));
  bar({r.x, r.y + r.height - edge, r.width, edge}, gray * 0.6);
  bar({r.x + r.width - edge, r.y, edge, r.height}, gray * 0.68);
}

void addNoise(cv::Mat& image, const cv::Mat& noise, double amplitude) {
  for (int y = 0; y < image.rows; ++y) {
    uchar* p = image.ptr<uchar>(y);
    const float* n = noise.ptr<float>(y);
    const float a = static_cast<float>(amplitude);
    for (int x = 0; x < image.cols; ++x)
      p[x] = cv::saturate_cast<uchar>(static_cast<float>(p[x]) * (1.f + a * n[x]));
  }
}

cv::Mat finish(cv::Mat image, std::uint64_t seed, double grain) {
  addNoise(image, cloudNoise(image.size(), mixSeed(seed, 7), 8, 3), grain);
  cv::GaussianBlur(image, image, cv::Size(3, 3), 0.6);
  return image;
}

}  // namespace svoscope::synthetic
