// SPDX-License-Identifier: MIT
// Procedural surfaces: grey images that look like paint, wood, print, brick or asphalt, with
// detail at all scales and nothing that repeats. Sizes in metres, `texel` in metres per pixel.
#pragma once

#include <cstdint>
#include <opencv2/core/mat.hpp>

namespace svoscope::synthetic {

struct Surface {
  double width, height;  ///< m
  double texel;          ///< m
  std::uint64_t seed;

  cv::Size pixels() const;
};

/// Smooth noise of several octaves, CV_32F, about -1..1. `coarse` is the largest cell in pixels,
/// `stretch` > 1 draws it out along x, as the grain of wood.
cv::Mat cloudNoise(cv::Size size, std::uint64_t seed, double coarse, int octaves,
                   double stretch = 1);

/// Overlapping shapes of all sizes from `largest` down to 8 mm: print, cartons, rubbish, gravel.
cv::Mat shapes(const Surface& surface, double mean, double contrast, double largest);
/// Painted wall: faint structure only.
cv::Mat plaster(const Surface& surface, double mean, double contrast);
/// Painted wall with pictures, notes and shelves.
cv::Mat pictureWall(const Surface& surface, double mean);
/// Wooden boards along x.
cv::Mat boards(const Surface& surface, double mean, double board_width);
/// Slabs of `tile` metres with stains and rubbish: unlike each other.
cv::Mat stoneFloor(const Surface& surface, double mean, double tile);

/// A corridor's wall: blank paint, a door, a skirting board.
cv::Mat corridorWall(const Surface& surface);
/// A corridor's ceiling: panels and a lamp across.
cv::Mat corridorCeiling(const Surface& surface);
/// A house: plaster or brick, windows, a door.
cv::Mat facade(const Surface& surface);
/// Asphalt with patches, cracks, covers; lane marks along x if `marks`.
cv::Mat asphalt(const Surface& surface, bool marks);

}  // namespace svoscope::synthetic
