// SPDX-License-Identifier: MIT
#include <cmath>

#include "engine/dataset/synthetic/patterns_detail.h"

namespace svoscope::synthetic {
namespace {

int toPixels(const Surface& surface, double metres) {
  return static_cast<int>(std::lround(metres / surface.texel));
}

void drawBricks(cv::Mat& image, const Surface& s, Random& random, double gray) {
  const int h = std::max(3, toPixels(s, 0.09)), w = std::max(6, toPixels(s, 0.26));
  for (int y = 0, row = 0; y < image.rows; y += h, ++row)
    for (int x = row % 2 ? -w / 2 : 0; x < image.cols; x += w)
      cv::rectangle(image, cv::Rect(x, y, w - 1, h - 1),
                    cv::Scalar(gray * random.uniform(0.65, 1.3)), cv::FILLED);
}

/// A window shows what is behind or mirrored in it: dark, with bright and dark shapes.
void drawWindow(cv::Mat& image, const Surface& s, cv::Rect r, Random& random) {
  drawPanel(image, r, random.uniform(170, 235), std::max(1, toPixels(s, 0.03)));
  const int frame = std::max(2, toPixels(s, 0.09));
  const int panes = 1 + random.below(3);
  const int w = (r.width - frame) / panes - frame;
  for (int i = 0; i < panes; ++i) {
    const cv::Rect pane(r.x + frame + i * (w + frame), r.y + frame, w, r.height - 2 * frame);
    if (pane.width < 3 || pane.height < 3) continue;
    cv::rectangle(image, pane, cv::Scalar(random.uniform(25, 90)), cv::FILLED);
    drawShapes(image, pane, random, 75, 60, 0.5 * pane.width, 0.05 / s.texel, 0.15);
    const int blind = static_cast<int>(pane.height * random.uniform(0, 0.6));
    if (random.below(2))
      cv::rectangle(image, cv::Rect(pane.x, pane.y, pane.width, blind),
                    cv::Scalar(random.uniform(120, 230)), cv::FILLED);
  }
  const int sill = std::max(2, toPixels(s, 0.12));
  drawPanel(image, {r.x - sill, r.y + r.height, r.width + 2 * sill, sill}, 150, 1);
}

void drawShop(cv::Mat& image, const Surface& s, Random& random, double ground) {
  const int top = image.rows - toPixels(s, ground);
  const int sign = toPixels(s, 0.6);
  const cv::Rect board(toPixels(s, 0.5), top, image.cols - toPixels(s, 1.0), sign);
  drawPanel(image, board, random.uniform(30, 220), std::max(1, toPixels(s, 0.04)));
  drawShapes(image, board, random, 130, 110, 0.3 * sign, 0.1 * sign, 0.2);
  int x = toPixels(s, 0.6);
  while (x < image.cols - toPixels(s, 1.2)) {
    const int w = toPixels(s, random.uniform(1.0, 2.4));
    drawWindow(image, s, {x, top + sign + 4, w, toPixels(s, ground - 1.0)}, random);
    x += w + toPixels(s, random.uniform(0.3, 0.7));
  }
}

}  // namespace

cv::Mat facade(const Surface& s) {
  Random random(s.seed);
  const double base = random.uniform(95, 190);
  cv::Mat image(s.pixels(), CV_8UC1, cv::Scalar(base));
  if (random.below(2)) drawBricks(image, s, random, base);
  addNoise(image, cloudNoise(image.size(), s.seed, 2.0 / s.texel, 8), 0.25);
  const double ground = 3.2, storey = random.uniform(2.6, 3.1);
  const int windows = 2 + random.below(4);
  for (double floor = ground + 0.7; floor + 1.6 < s.height; floor += storey) {
    for (int i = 0; i < windows; ++i) {
      const double cell = s.width / windows, w = cell * random.uniform(0.4, 0.65);
      const double x = (i + 0.5) * cell - 0.5 * w, h = random.uniform(1.2, 1.7);
      drawWindow(
          image, s,
          {toPixels(s, x), image.rows - toPixels(s, floor + h), toPixels(s, w), toPixels(s, h)},
          random);
    }
  }
  drawShop(image, s, random, ground);
  cv::rectangle(image, cv::Rect(0, 0, image.cols, toPixels(s, 0.35)), cv::Scalar(0.5 * base),
                cv::FILLED);
  return finish(image, s.seed, 0.12);
}

cv::Mat asphalt(const Surface& s, bool marks) {
  cv::Mat image(s.pixels(), CV_8UC1, cv::Scalar(98));
  Random random(s.seed);
  addNoise(image, cloudNoise(image.size(), s.seed, 3.0 / s.texel, 9), 0.25);
  const int patches = 1 + static_cast<int>(s.width * s.height / 12);
  for (int i = 0; i < patches; ++i) {
    const cv::Point2d centre{random.uniform(0, image.cols), random.uniform(0, image.rows)};
    const double radius = random.uniform(0.15, 0.9) / s.texel, gray = random.uniform(55, 150);
    drawShape(image, random, centre, radius, gray);
  }
  drawShapes(image, {0, 0, image.cols, image.rows}, random, 105, 55, 0.12 / s.texel, 2.5, 0.025);
  for (int i = 0; i < patches; ++i) {  // cracks
    cv::Point p{random.below(image.cols), random.below(image.rows)};
    for (int k = 0; k < 12; ++k) {
      const cv::Point q = p + cv::Point{random.below(61) - 30, random.below(61) - 30};
      cv::line(image, p, q, cv::Scalar(45), 1, cv::LINE_AA);
      p = q;
    }
  }
  if (marks)
    for (double x = 1.0; x < s.width; x += 6.0)
      cv::rectangle(image,
                    cv::Rect(toPixels(s, x), image.rows / 2, toPixels(s, 3.0),
                             std::max(2, toPixels(s, 0.13))),
                    cv::Scalar(225), cv::FILLED);
  addNoise(image, cloudNoise(image.size(), mixSeed(s.seed, 3), 0.3 / s.texel, 6), 0.18);
  return finish(image, s.seed, 0.12);
}

}  // namespace svoscope::synthetic
