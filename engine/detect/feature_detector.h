// SPDX-License-Identifier: MIT
// Corners and edgelets, at most one per grid cell, so that features spread over the image.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/base/kinds.h"
#include "engine/frame/pyramid.h"

namespace svoscope {

struct DetectorParameters {
  int cell_px = 30;              ///< side of a grid cell, px of level 0 at 640 px width
  int corner_levels = 3;         ///< corners are sought on levels 0 .. corner_levels - 1
  int fast_threshold = 10;       ///< grey levels
  double min_corner_score = 4;   ///< Shi-Tomasi: smaller eigenvalue's root, grey levels per px
  double min_edge_gradient = 6;  ///< grey levels per px of level 1; 0 = no edgelets
  int border_px = 8;             ///< kept free on every level
};

struct DetectedFeature {
  Vec2 px = Vec2::Zero();  ///< level-0 coordinates
  int level = 0;
  FeatureType type = FeatureType::corner;
  double score = 0;                  ///< comparable within a type
  Vec2 gradient_dir = Vec2::Zero();  ///< unit vector across the edge; zero for corners
};

/// Which cells of the image are taken.
class OccupancyGrid {
 public:
  OccupancyGrid() = default;
  OccupancyGrid(int width, int height, int cell_px);

  int cellOf(const Vec2& px) const;
  bool taken(int cell) const { return taken_[cell] != 0; }
  bool taken(const Vec2& px) const { return taken(cellOf(px)); }
  void take(const Vec2& px) { taken_[cellOf(px)] = 1; }
  int cells() const { return static_cast<int>(taken_.size()); }
  /// The same places with cells of another size: a cell is taken if its centre lies in a taken one,
  /// or the other way round.
  OccupancyGrid withCells(int cell_px) const;

 private:
  Vec2 centreOf(int cell) const;

  int cell_px_ = 1, columns_ = 0, rows_ = 0;
  std::vector<std::uint8_t> taken_;
};

/// Cell size for an image: `cell_px` is meant for 640 px width and grows with the image.
int scaledCell(int cell_px, int image_width);

/// Features in the free cells of `grid` (level-0 cells), corners first, edgelets in cells without
/// a corner; ordered by cell.
std::vector<DetectedFeature> detectFeatures(const Pyramid& pyramid,
                                            const DetectorParameters& parameters,
                                            const OccupancyGrid& grid);

/// Root of the smaller eigenvalue of the 8x8 mean structure tensor at an integer pixel, grey
/// levels per px (Shi & Tomasi). Zero within 5 px of the border.
double cornerScore(const cv::Mat& image, int x, int y);

}  // namespace svoscope
