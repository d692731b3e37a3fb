// SPDX-License-Identifier: MIT
#include "engine/detect/feature_detector.h"

#include <gtest/gtest.h>

#include <opencv2/imgproc.hpp>
#include <set>

#include "tests/support/plane_scene.h"

namespace svoscope {
namespace {

PyramidPtr texture() {
  const test::PlaneScene scene(test::smallCamera(), Vec3::UnitZ(), 2, 0.055);
  return scene.pyramid(SE3(), 4);
}

std::vector<DetectedFeature> detect(const cv::Mat& image, const DetectorParameters& p = {}) {
  return detectFeatures(*buildPyramid(image, 4), p,
                        OccupancyGrid(image.cols, image.rows, p.cell_px));
}

TEST(FeatureDetector, FindsAtMostOneFeaturePerCellOnTexture) {
  const PyramidPtr pyramid = texture();
  const DetectorParameters p;
  const OccupancyGrid grid(320, 240, p.cell_px);
  const auto found = detectFeatures(*pyramid, p, grid);
  EXPECT_GT(found.size(), 60u);
  std::set<int> cells;
  for (const DetectedFeature& f : found) EXPECT_TRUE(cells.insert(grid.cellOf(f.px)).second);
}

TEST(FeatureDetector, LeavesTakenCellsAlone) {
  const PyramidPtr pyramid = texture();
  const DetectorParameters p;
  OccupancyGrid grid(320, 240, p.cell_px);
  const auto all = detectFeatures(*pyramid, p, grid);
  for (const DetectedFeature& f : all) {
    if (f.px.x() < 160) grid.take(f.px);
  }
  const auto rest = detectFeatures(*pyramid, p, grid);
  EXPECT_FALSE(rest.empty());
  EXPECT_LT(rest.size(), all.size());
  for (const DetectedFeature& f : rest) EXPECT_FALSE(grid.taken(f.px));
}

TEST(FeatureDetector, FindsADrawnCornerWhereItIs) {
  cv::Mat image(120, 160, CV_8UC1, cv::Scalar(60));
  image(cv::Rect(75, 45, 85, 75)).setTo(200);
  cv::GaussianBlur(image, image, {5, 5}, 0);  // without, neighbours tie and none is a maximum
  const auto found = detect(image);
  double nearest = 1e9;
  for (const DetectedFeature& f : found) {
    if (f.type == FeatureType::corner) nearest = std::min(nearest, (f.px - Vec2(75, 45)).norm());
  }
  EXPECT_LT(nearest, 6.0);  // a pixel and a half of the coarsest level
}

TEST(FeatureDetector, AnEdgeletPointsAcrossADrawnEdge) {
  for (const double degrees : {0.0, 30.0, 90.0, 135.0}) {
    const Vec2 across(std::cos(degrees * M_PI / 180), std::sin(degrees * M_PI / 180));
    cv::Mat image(200, 200, CV_8UC1);
    for (int y = 0; y < 200; ++y)
      for (int x = 0; x < 200; ++x)
        image.at<std::uint8_t>(y, x) =
            cv::saturate_cast<std::uint8_t>(120 + 80 * across.dot(Vec2(x - 99.5, y - 99.5)));
    cv::GaussianBlur(image, image, {5, 5}, 0);
    int edgelets = 0;
    for (const DetectedFeature& f : detect(image)) {
      if (f.type != FeatureType::edgelet) continue;
      ++edgelets;
      EXPECT_GT(f.gradient_dir.dot(across), 0.99) << degrees;
      EXPECT_NEAR(f.gradient_dir.norm(), 1, 1e-9);
      EXPECT_LT(std::abs(across.dot(f.px - Vec2(99.5, 99.5))), 4.5) << degrees;
    }
    EXPECT_GE(edgelets, 3) << degrees;
  }
}

TEST(FeatureDetector, EdgeletsCanBeSwitchedOff) {
  cv::Mat image(120, 160, CV_8UC1, cv::Scalar(60));
  image(cv::Rect(80, 0, 80, 120)).setTo(200);
  DetectorParameters p;
  EXPECT_FALSE(detect(image, p).empty());
  p.min_edge_gradient = 0;
  EXPECT_TRUE(detect(image, p).empty());
}

TEST(FeatureDetector, BlankImagesGiveNothing) {
  for (const int grey : {0, 128, 255})
    EXPECT_TRUE(detect(cv::Mat(240, 320, CV_8UC1, cv::Scalar(grey))).empty()) << grey;
}

TEST(FeatureDetector, TinyImagesAreSafe) {
  for (const cv::Size& size : {cv::Size(1, 1), cv::Size(6, 6), cv::Size(16, 9), cv::Size(50, 48)}) {
    cv::Mat image(size, CV_8UC1);
    cv::RNG(3).fill(image, cv::RNG::UNIFORM, 0, 256);
    for (const DetectedFeature& f : detect(image)) {
      EXPECT_GE(f.px.x(), 8);
      EXPECT_LT(f.px.x(), size.width - 8);
    }
  }
}

TEST(FeatureDetector, TheSmallerEigenvalueTellsCornersFromEdges) {
  cv::Mat image(40, 40, CV_8UC1, cv::Scalar(60));
  image(cv::Rect(20, 20, 20, 20)).setTo(200);
  EXPECT_GT(cornerScore(image, 20, 20), 10);
  EXPECT_NEAR(cornerScore(image, 20, 32), 0, 1e-3);  // on the straight edge
  EXPECT_EQ(cornerScore(image, 10, 10), 0);
  EXPECT_EQ(cornerScore(image, 4, 20), 0);  // too close to the border
}

TEST(OccupancyGrid, CellsCoverTheWholeImage) {
  OccupancyGrid grid(100, 61, 30);
  EXPECT_EQ(grid.cells(), 4 * 3);
  EXPECT_EQ(grid.cellOf({0, 0}), 0);
  EXPECT_EQ(grid.cellOf({99, 60}), 11);
  EXPECT_EQ(grid.cellOf({-5, 400}), 8);  // outside: the nearest cell
  grid.take({31, 1});
  EXPECT_TRUE(grid.taken(Vec2(59, 29)));
  EXPECT_FALSE(grid.taken(Vec2(60, 29)));
}

TEST(OccupancyGrid, CellsGrowWithLargeImagesOnly) {
  EXPECT_EQ(scaledCell(30, 640), 30);
  EXPECT_EQ(scaledCell(30, 320), 21);
  EXPECT_EQ(scaledCell(30, 2560), 60);
  EXPECT_EQ(scaledCell(1, 640), 8);
}

}  // namespace
}  // namespace svoscope
