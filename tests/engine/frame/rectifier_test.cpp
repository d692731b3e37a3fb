// SPDX-License-Identifier: MIT
#include "engine/frame/rectifier.h"

#include <gtest/gtest.h>

#include <cmath>

namespace svoscope {
namespace {

std::vector<Camera> distortedCameras() {
  const Pinhole euroc{752, 480, 458.654, 457.296, 367.215, 248.375};
  const Pinhole wide{640, 480, 280, 280, 322, 238};
  return {{euroc, Distortion::radtan, {-0.2834, 0.0740, 1.9e-4, 1.8e-5}, 20},
          cameraPreset("tum-fr1").value(),
          {wide, Distortion::radtan, {-0.4, 0, 0, 0}, 0},  // folds back inside the image
          {wide, Distortion::equidistant, {-0.01, 0.02, -0.015, 0.004}, 0},
          {wide, Distortion::fov, {0.93}, 0}};
}

/// Smooth grey value of a ray, known everywhere: what a perfect lens would see.
double pattern(const Vec3& ray) {
  return 128 + 60 * std::sin(9 * ray.x() / ray.z()) + 50 * std::cos(7 * ray.y() / ray.z());
}

TEST(Rectifier, SceneIsWhereThePinholeSaysItIs) {
  for (const Camera& camera : distortedCameras()) {
    cv::Mat image(camera.pinhole.height, camera.pinhole.width, CV_8UC1, cv::Scalar(0));
    for (int y = 0; y < image.rows; ++y) {
      for (int x = 0; x < image.cols; ++x) {
        const Vec3 ray = camera.unproject(Vec2(x, y));
        if (ray.allFinite()) image.at<uchar>(y, x) = cv::saturate_cast<uchar>(pattern(ray));
      }
    }
    const Rectifier rectifier(camera);
    ASSERT_FALSE(rectifier.identity());
    const cv::Mat out = rectifier.rectify(image);
    ASSERT_EQ(out.size(), image.size());
    double worst = 0;
    for (int y = 2; y < out.rows - 2; ++y)
      for (int x = 2; x < out.cols - 2; ++x)
        worst = std::max(worst, std::abs(out.at<uchar>(y, x) -
                                         pattern(rectifier.pinhole().unproject(Vec2(x, y)))));
    EXPECT_LT(worst, 3.5) << distortionName(camera.distortion);
  }
}

TEST(Rectifier, EveryPixelComesFromInsideTheOriginal) {
  for (const Camera& camera : distortedCameras()) {
    const Pinhole p = rectifiedPinhole(camera);
    EXPECT_GE(p.fx, 0.499 * camera.pinhole.fx);
    EXPECT_NEAR(p.fx / p.fy, camera.pinhole.fx / camera.pinhole.fy, 1e-12);
    for (int y = 0; y < p.height; ++y) {
      for (int x = 0; x < p.width; ++x) {
        const Vec2 px = camera.project(p.unproject(Vec2(x, y)));
        ASSERT_TRUE(px.x() >= 0 && px.y() >= 0 && px.x() <= p.width - 1 && px.y() <= p.height - 1)
            << distortionName(camera.distortion) << " " << x << " " << y;
      }
    }
  }
}

TEST(Rectifier, KeepsMostOfTheField) {
  const Camera euroc = distortedCameras()[0];
  EXPECT_LT(rectifiedPinhole(euroc).fx, 1.0 * euroc.pinhole.fx);
}

TEST(Rectifier, NoDistortionPassesTheImageThrough) {
  Camera camera = cameraPreset("tum-fr3").value();
  const cv::Mat image(480, 640, CV_8UC1, cv::Scalar(7));
  EXPECT_TRUE(Rectifier(camera).identity());
  EXPECT_EQ(Rectifier(camera).rectify(image).data, image.data);
  EXPECT_EQ(Rectifier(camera).pinhole().cx, camera.pinhole.cx);
  camera.distortion = Distortion::radtan;
  camera.coefficients = {0, 0, 0, 0};
  EXPECT_TRUE(Rectifier(camera).identity());
}

TEST(Rectifier, DepthIsNeverMixed) {
  const Rectifier rectifier(distortedCameras()[0]);
  cv::Mat depth(480, 752, CV_32FC1);
  for (int y = 0; y < depth.rows; ++y)
    for (int x = 0; x < depth.cols; ++x) depth.at<float>(y, x) = (x / 8 + y / 8) % 2 ? 1.f : 5.f;
  const cv::Mat out = rectifier.rectifyDepth(depth);
  for (int y = 0; y < out.rows; ++y)
    for (int x = 0; x < out.cols; ++x)
      ASSERT_TRUE(out.at<float>(y, x) == 1.f || out.at<float>(y, x) == 5.f);
}

}  // namespace
}  // namespace svoscope
