// SPDX-License-Identifier: MIT
#include <cmath>

#include "engine/dataset/synthetic/patterns_detail.h"

namespace svoscope::synthetic {
namespace {

cv::Mat blank(const Surface& surface, double gray) {
  return cv::Mat(surface.pixels(), CV_8UC1, cv::Scalar(gray));
}

int toPixels(const Surface& surface, double metres) {
  return static_cast<int>(std::lround(metres / surface.texel));
}

/// Lines of words, as on a page or a label.
void drawWriting(cv::Mat& image, cv::Rect area, Random& random, double line_px, double gray) {
  for (double y = area.y + line_px; y < area.y + area.height - line_px; y += line_px) {
    double x = area.x + line_px;
    const double end = area.x + area.width * random.uniform(0.6, 0.95);
    while (x < end) {
      const double word = line_px * random.uniform(0.5, 3);
      cv::rectangle(image,
                    cv::Rect(static_cast<int>(x), static_cast<int>(y), static_cast<int>(word),
                             std::max(1, static_cast<int>(0.5 * line_px))),
                    cv::Scalar(gray + random.uniform(-30, 30)), cv::FILLED);
      x += word + 0.6 * line_px;
    }
  }
}

/// A shelf board with books of different width, height and shade.
void drawShelf(cv::Mat& image, const Surface& s, cv::Rect area, Random& random) {
  drawPanel(image, area, 60, std::max(1, toPixels(s, 0.01)));
  const int board = std::max(2, toPixels(s, 0.03));
  int x = area.x + board;
  while (x < area.x + area.width - board) {
    const int w = std::max(2, toPixels(s, random.uniform(0.02, 0.06)));
    const int h = static_cast<int>(area.height * random.uniform(0.55, 0.9));
    const cv::Rect book(x, area.y + area.height - board - h, w, h);
    if (book.x + book.width > area.x + area.width - board) break;
    drawPanel(image, book, random.uniform(40, 220), 1);
    const int band = book.y + static_cast<int>(h * random.uniform(0.15, 0.7));
    cv::rectangle(image, cv::Rect(book.x, band, w, std::max(2, h / 8)),
                  cv::Scalar(random.uniform(20, 240)), cv::FILLED);
    x += w + (random.below(6) == 0 ? w : 0);
  }
}

void drawPicture(cv::Mat& image, const Surface& s, cv::Rect r, Random& random) {
  drawPanel(image, r, random.uniform(30, 230), std::max(1, toPixels(s, 0.012)));
  const int frame = std::max(2, toPixels(s, 0.03));
  const cv::Rect inner(r.x + frame, r.y + frame, r.width - 2 * frame, r.height - 2 * frame);
  if (inner.width < 8 || inner.height < 8) return;
  if (random.below(3) == 0) {
    cv::rectangle(image, inner, cv::Scalar(225), cv::FILLED);
    drawWriting(image, inner, random, std::max(4.0, 0.025 / s.texel), 60);
  } else {
    cv::rectangle(image, inner, cv::Scalar(random.uniform(60, 190)), cv::FILLED);
    drawShapes(image, inner, random, 125, 95, 0.3 * inner.width, 0.012 / s.texel, 0.35);
  }
}

}  // namespace

cv::Mat shapes(const Surface& s, double mean, double contrast, double largest) {
  cv::Mat image = blank(s, mean);
  Random random(s.seed);
  addNoise(image, cloudNoise(image.size(), mixSeed(s.seed, 1), 0.4 / s.texel, 5), 0.25);
  drawShapes(image, {0, 0, image.cols, image.rows}, random, mean, contrast, largest / s.texel,
             std::max(2.5, 0.008 / s.texel), 0.3);
  // Some writing in the places that are left.
  const cv::Rect label(image.cols / 6 + random.below(image.cols / 4 + 1),
                       image.rows / 5 + random.below(image.rows / 4 + 1), image.cols / 3,
                       image.rows / 4);
  cv::rectangle(image, label, cv::Scalar(mean > 128 ? 235 : 200), cv::FILLED);
  drawWriting(image, label, random, std::max(4.0, 0.02 / s.texel), 50);
  return finish(image, s.seed, 0.10);
}

cv::Mat plaster(const Surface& s, double mean, double contrast) {
  cv::Mat image = blank(s, mean);
  addNoise(image, cloudNoise(image.size(), s.seed, 0.5 / s.texel, 7), contrast);
  return finish(image, s.seed, 0.3 * contrast);
}

cv::Mat pictureWall(const Surface& s, double mean) {
  cv::Mat image = blank(s, mean);
  addNoise(image, cloudNoise(image.size(), s.seed, 0.6 / s.texel, 7), 0.16);
  Random random(s.seed);
  const int columns = std::max(1, static_cast<int>(s.width / 0.9));
  const int rows = std::max(1, static_cast<int>((s.height - 0.3) / 0.75));
  for (int i = 0; i < columns * rows; ++i) {
    const double cell_w = s.width / columns, cell_h = (s.height - 0.3) / rows;
    const double w = cell_w * random.uniform(0.45, 0.85), h = cell_h * random.uniform(0.45, 0.85);
    const double x = (i % columns + random.uniform(0, 1)) * cell_w - random.uniform(0, w);
    const double y = (i / columns) * cell_h + random.uniform(0.05, 0.95 * (cell_h - h));
    const cv::Rect r(toPixels(s, x), toPixels(s, y), toPixels(s, w), toPixels(s, h));
    if (random.below(4) == 0)
      drawShelf(image, s, r, random);
    else
      drawPicture(image, s, r, random);
  }
  const int skirting = toPixels(s, 0.1);
  drawPanel(image, {0, image.rows - skirting, image.cols, skirting}, 0.55 * mean, 2);
  return finish(image, s.seed, 0.08);
}

cv::Mat boards(const Surface& s, double mean, double board_width) {
  cv::Mat image = blank(s, mean);
  Random random(s.seed);
  const int row_px = std::max(4, toPixels(s, board_width));
  for (int y = 0; y < image.rows; y += row_px) {
    int x = -toPixels(s, random.uniform(0, 1.2));
    while (x < image.cols) {
      const int length = toPixels(s, random.uniform(0.7, 1.6));
      drawPanel(image, {x, y, length, row_px}, mean * random.uniform(0.7, 1.25), 1);
      x += length;
    }
  }
  addNoise(image, cloudNoise(image.size(), s.seed, 0.05 / s.texel, 5, 10), 0.28);
  addNoise(image, cloudNoise(image.size(), mixSeed(s.seed, 2), 0.5 / s.texel, 6), 0.2);
  // Knots and scratches, so that boards differ at small scale too.
  drawShapes(image, {0, 0, image.cols, image.rows}, random, 0.7 * mean, 0.5 * mean, 0.02 / s.texel,
             0.006 / s.texel, 0.012);
  return finish(image, s.seed, 0.08);
}

cv::Mat stoneFloor(const Surface& s, double mean, double tile) {
  cv::Mat image = blank(s, mean);
  Random random(s.seed);
  const int size = std::max(8, toPixels(s, tile));
  for (int y = 0; y < image.rows; y += size) {
    for (int x = 0; x < image.cols; x += size) {
      const double gray = mean * random.uniform(0.65, 1.35);
      drawPanel(image, {x, y, size, size}, gray, std::max(1, toPixels(s, 0.008)));
      const cv::Rect inner(x + 3, y + 3, size - 6, size - 6);
      drawShapes(image, inner, random, gray, 0.55 * mean, 0.25 * size, 0.012 / s.texel, 0.12);
    }
  }
  addNoise(image, cloudNoise(image.size(), s.seed, 1.0 / s.texel, 8), 0.3);
  return finish(image, s.seed, 0.1);
}

cv::Mat corridorWall(const Surface& s) {
  cv::Mat image = blank(s, 205);
  addNoise(image, cloudNoise(image.size(), s.seed, 1.0 / s.texel, 4), 0.04);
  Random random(s.seed);
  const int skirting = toPixels(s, 0.1);
  drawPanel(image, {0, image.rows - skirting, image.cols, skirting}, 95, toPixels(s, 0.01));
  drawPanel(image, {0, toPixels(s, 1.55), image.cols, toPixels(s, 0.08)}, 150, toPixels(s, 0.008));
  const int door_w = toPixels(s, 0.95), door_h = toPixels(s, 2.05), frame = toPixels(s, 0.07);
  const int x = toPixels(s, random.uniform(0.5, s.width - 1.6));
  drawPanel(image, {x, image.rows - door_h, door_w, door_h}, 70, toPixels(s, 0.01));
  drawPanel(image, {x + frame, image.rows - door_h + frame, door_w - 2 * frame, door_h - frame},
            random.uniform(120, 185), toPixels(s, 0.008));
  const int handle = x + (random.below(2) ? 2 * frame : door_w - 3 * frame);
  drawPanel(image, {handle, image.rows - toPixels(s, 1.05), frame, toPixels(s, 0.03)}, 40, 2);
  // A sign beside the door: the only corners on the wall.
  const int sign = x + door_w + toPixels(s, 0.12);
  drawPanel(image, {sign, image.rows - toPixels(s, 1.6), toPixels(s, 0.18), toPixels(s, 0.12)}, 235,
            toPixels(s, 0.006));
  return finish(image, s.seed, 0.015);
}

cv::Mat corridorCeiling(const Surface& s) {
  cv::Mat image = blank(s, 225);
  const int panel = toPixels(s, 0.6), gap = std::max(1, toPixels(s, 0.012));
  for (int x = 0; x < image.cols; x += panel)
    cv::rectangle(image, cv::Rect(x, 0, gap, image.rows), cv::Scalar(150), cv::FILLED);
  for (int y = image.rows / 2; y < image.rows; y += panel)
    cv::rectangle(image, cv::Rect(0, y, image.cols, gap), cv::Scalar(150), cv::FILLED);
  drawPanel(image, {panel, image.rows / 2 - panel / 2, 2 * panel, panel}, 180, toPixels(s, 0.03));
  cv::rectangle(image,
                cv::Rect(panel + gap * 4, image.rows / 2 - panel / 2 + gap * 4, 2 * panel - gap * 8,
                         panel - gap * 8),
                cv::Scalar(252), cv::FILLED);
  return finish(image, s.seed, 0.015);
}

}  // namespace svoscope::synthetic
