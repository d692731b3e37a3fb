// SPDX-License-Identifier: MIT
#include "engine/dataset/synthetic/renderer.h"

#include <gtest/gtest.h>

#include <cmath>

namespace svoscope::synthetic {
namespace {

const Pinhole kCamera{160, 120, 130, 132, 80.3, 58.9};

/// Grey rises along u from 20 to 220 and is constant along v.
cv::Mat ramp(int width) {
  cv::Mat image(64, width, CV_8UC1);
  for (int y = 0; y < image.rows; ++y)
    for (int x = 0; x < width; ++x)
      image.at<uchar>(y, x) = static_cast<uchar>(std::lround(20 + 200.0 * (x + 0.5) / width));
  return image;
}

TEST(Renderer, DepthOfASlantedPlaneIsExact) {
  Scene scene;
  const Vec3 corner(-8, -6, 4), u(16, 0, 3), v(0, 12, -1);
  scene.addQuad(corner, u, v, scene.addTexture(ramp(64)));
  const SE3 T_world_cam = SE3::exp((Vec6() << 0.2, -0.1, 0.3, 0.1, -0.2, 0.15).finished());
  const cv::Mat depth = renderDepth(scene, kCamera, T_world_cam);
  const Vec3 n = u.cross(v), eye = T_world_cam.translation();
  for (int y = 0; y < kCamera.height; ++y) {
    for (int x = 0; x < kCamera.width; ++x) {
      const Vec3 ray = T_world_cam.quaternion() * kCamera.unproject(Vec2(x, y));
      const double z = n.dot(corner - eye) / n.dot(ray);
      ASSERT_NEAR(depth.at<float>(y, x), z, 1e-5 * z);
    }
  }
}

TEST(Renderer, TextureIsPerspectivelyCorrect) {
  Scene scene;
  const Vec3 corner(-4, -6, 2.5), u(9, 0, 6), v(0, 12, 0);
  scene.addQuad(corner, u, v, scene.addTexture(ramp(512)));
  const View view = render(scene, kCamera, SE3());
  for (int x = 2; x < kCamera.width - 2; x += 3) {
    const Vec3 point = kCamera.unproject(Vec2(x, 60)) * view.depth.at<float>(60, x);
    const double s = (point - corner).x() / u.x();
    if (s > 0.02 && s < 0.98) {
      EXPECT_NEAR(view.gray.at<float>(60, x), 20 + 200 * s, 1.0) << x;
    }
  }
}

TEST(Renderer, NearerSurfaceHidesAndSilhouettesAreSmooth) {
  Scene scene;
  const int white = scene.addTexture(cv::Mat(8, 8, CV_8UC1, cv::Scalar(200)));
  const int black = scene.addTexture(cv::Mat(8, 8, CV_8UC1, cv::Scalar(20)));
  scene.addQuad({-9, -9, 6}, {18, 0, 0}, {0, 18, 0}, white);
  // The left edge falls at pixel 80.3 + 130 * 0.1 / 2 = 86.8: pixel 87 is 30 % white.
  scene.addQuad({0.1, -9, 2}, {18, 0, 0}, {0, 18, 0}, black);
  const View view = render(scene, kCamera, SE3());
  EXPECT_EQ(view.depth.at<float>(60, 86), 6.f);
  EXPECT_NEAR(view.depth.at<float>(60, 88), 2.f, 1e-6);
  EXPECT_NEAR(view.gray.at<float>(60, 85), 200, 1e-3);
  EXPECT_NEAR(view.gray.at<float>(60, 87), 20 + 0.3 * 180, 0.13 * 180);
  EXPECT_NEAR(view.gray.at<float>(60, 89), 20, 1e-3);
}

TEST(Renderer, ClosedRoomHasNoGaps) {
  Scene scene;
  const int texture = scene.addTexture(cv::Mat(8, 8, CV_8UC1, cv::Scalar(100)));
  for (double s : {-1.0, 1.0}) {
    scene.addQuad({s * 3, -3, -3}, {0, 6, 0}, {0, 0, 6}, texture);
    scene.addQuad({-3, s * 3, -3}, {6, 0, 0}, {0, 0, 6}, texture);
    scene.addQuad({-3, -3, s * 3}, {6, 0, 0}, {0, 6, 0}, texture);
  }
  for (int i = 0; i < 12; ++i) {
    Vec6 twist;
    twist << 0.3, 0.2 * i - 1, 0.5, 0.5 * i, 0.3, 0.2 * i;
    const View view = render(scene, kCamera, SE3::exp(twist));
    for (int y = 0; y < kCamera.height; ++y)
      for (int x = 0; x < kCamera.width; ++x)
        ASSERT_NEAR(view.gray.at<float>(y, x), 100, 0.01) << i << ": " << x << " " << y;
  }
}

TEST(Renderer, FineTexturesFarAwayFadeInsteadOfFlickering) {
  Scene scene;
  cv::Mat checks(1024, 1024, CV_8UC1);
  for (int y = 0; y < 1024; ++y)
    for (int x = 0; x < 1024; ++x) checks.at<uchar>(y, x) = (x + y) % 2 ? 255 : 0;
  scene.addQuad({-3, -3, 6}, {6, 0, 0}, {0, 6, 0}, scene.addTexture(checks));
  const View view = render(scene, kCamera, SE3());
  for (int y = 10; y < 110; y += 7)
    for (int x = 30; x < 130; x += 7) EXPECT_NEAR(view.gray.at<float>(y, x), 127.5, 3);
}

}  // namespace
}  // namespace svoscope::synthetic
