// SPDX-License-Identifier: MIT
// Brushes shared by the surfaces.
#pragma once

#include <opencv2/core/mat.hpp>
#include <opencv2/imgproc.hpp>

#include "engine/dataset/synthetic/patterns.h"
#include "engine/dataset/synthetic/random.h"

namespace svoscope::synthetic {

/// A random polygon, ellipse or slanted rectangle of about `radius` pixels.
void drawShape(cv::Mat& image, Random& random, cv::Point2d centre, double radius, double gray);

/// Covers `area` of the image with shapes, large ones first; grey = mean +- contrast.
void drawShapes(cv::Mat& image, cv::Rect area, Random& random, double mean, double contrast,
                double largest_px, double smallest_px, double coverage);

/// A filled rectangle with a lighter and a darker edge, as if it stood out a little.
void drawPanel(cv::Mat& image, cv::Rect r, double gray, int edge);

/// Multiplies by 1 + amplitude * noise: keeps 8-bit areas from being flat.
void addNoise(cv::Mat& image, const cv::Mat& noise, double amplitude);

/// Ends a drawing: fine grain, then a slight blur so that no texel stands alone.
cv::Mat finish(cv::Mat image, std::uint64_t seed, double grain);

}  // namespace svoscope::synthetic
