// SPDX-License-Identifier: MIT
// End to end on rendered frames: textured planes seen by a moving pinhole camera.
#include "engine/tracking/initializer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <opencv2/imgproc.hpp>
#include <random>

#include "engine/frame/pyramid.h"

namespace svoscope {
namespace {

Pinhole camera() {
  Pinhole c;
  c.width = 400;
  c.height = 300;
  c.fx = c.fy = 320;
  c.cx = 199.5;
  c.cy = 149.5;
  return c;
}

cv::Mat randomTexture(unsigned seed) {
  cv::Mat noise(512, 512, CV_8U);
  std::mt19937 rng(seed);
  for (int y = 0; y < noise.rows; ++y)
    for (int x = 0; x < noise.cols; ++x) noise.at<std::uint8_t>(y, x) = rng() % 256;
  cv::Mat smooth;
  cv::GaussianBlur(noise, smooth, {0, 0}, 2.5);
  cv::normalize(smooth, smooth, 0, 255, cv::NORM_MINMAX);
  return smooth;
}

/// Two planes z = far and, right of x = 0, z = near (far == near: one plane), world = reference.
struct World {
  double near = 2, far = 4;
  cv::Mat texture = randomTexture(3);

  double grey(const Vec3& origin, const Vec3& ray) const {
    for (const double z : {near, far}) {
      const Vec3 p = origin + ray * ((z - origin.z()) / ray.z());
      if (z == near && near < far && p.x() < 0) continue;
      const double u = p.x() / z * 230 + 256, v = p.y() / z * 230 + 256;
      const int x = std::clamp(static_cast<int>(u), 0, 510);
      const int y = std::clamp(static_cast<int>(v), 0, 510);
      const double a = u - x, b = v - y;
      const auto t = [&](int i, int j) { return double(texture.at<std::uint8_t>(y + j, x + i)); };
      return (1 - b) * ((1 - a) * t(0, 0) + a * t(1, 0)) + b * ((1 - a) * t(0, 1) + a * t(1, 1));
    }
    return 0;
  }

  cv::Mat render(const SE3& T_cam_world, double offset) const {
    const Pinhole c = camera();
    const SE3 T_world_cam = T_cam_world.inverse();
    cv::Mat image(c.height, c.width, CV_8U);
    for (int y = 0; y < c.height; ++y)
      for (int x = 0; x < c.width; ++x)
        image.at<std::uint8_t>(y, x) = cv::saturate_cast<std::uint8_t>(
            0.8 * grey(T_world_cam.translation(), T_world_cam.quaternion() * c.unproject({x, y})) +
            offset);
    return image;
  }
};

using Path = std::function<SE3(int)>;

/// Runs until the start or to the end; brightness drifts a little.
InitializerOutput run(const World& world, const Path& path, int frames,
                      const InitializerParameters& parameters = {}) {
  Initializer initializer(camera(), parameters);
  InitializerOutput out;
  for (int k = 0; k < frames && !out.initialized; ++k)
    out = initializer.process({k, 0.05 * k, buildPyramid(world.render(path(k), 10 + 0.5 * k), 4)});
  return out;
}

void expectAccurate(const InitializerOutput& out, const Path& path) {
  ASSERT_TRUE(out.initialized) << out.reason;
  const SE3 T = path(out.poses.back().frame_index) * path(out.poses.front().frame_index).inverse();
  EXPECT_LT(T.quaternion().angularDistance(out.T_cur_ref.quaternion()), 0.005);
  EXPECT_GT(T.translation().normalized().dot(out.T_cur_ref.translation().normalized()), 0.999);
  EXPECT_LT(out.rms_px, 0.5);
  EXPECT_EQ(out.poses.front().T_frame_ref.matrix(), Mat4::Identity());
  std::vector<double> depths;
  for (const InitializerPoint& p : out.points) {
    depths.push_back(p.p_ref.z());
    EXPECT_LT((camera().project(p.p_ref) - p.px_ref).norm(), 1e-6);
    EXPECT_LT((camera().project(out.T_cur_ref * p.p_ref) - p.px_cur).norm(), 3.0);
  }
  std::nth_element(depths.begin(), depths.begin() + depths.size() / 2, depths.end());
  EXPECT_NEAR(depths[depths.size() / 2], 1.0, 0.05);
}

SE3 sideways(int k) { return SE3(so3Exp(Vec3(0, 0.003 * k, 0.002 * k)), Vec3(-0.05 * k, 0, 0)); }
SE3 forward(int k) { return SE3(so3Exp(Vec3(0, 0.002 * k, 0)), Vec3(0, 0, -0.06 * k)); }
SE3 turning(int k) { return SE3(so3Exp(Vec3(0.01 * k, 0.015 * k, 0)), Vec3::Zero()); }

TEST(Initializer, StartsOnTwoPlanesMovingSideways) {
  expectAccurate(run(World{}, sideways, 25), sideways);
}

TEST(Initializer, StartsOnASinglePlane) {
  World world;
  world.near = world.far = 3;
  const Path path = [](int k) {
    return SE3(so3Exp(Vec3(0.004 * k, 0, 0.002 * k)), Vec3(-0.06 * k, 0.02 * k, 0.02 * k));
  };
  expectAccurate(run(world, path, 30), path);
}

TEST(Initializer, StartsMovingForward) { expectAccurate(run(World{}, forward, 30), forward); }

TEST(Initializer, WaitsWhileTurningAndStartsAfterwards) {
  const InitializerOutput waiting = run(World{}, turning, 15);
  EXPECT_FALSE(waiting.initialized);
  const Path path = [](int k) {
    return k < 10 ? turning(k) : SE3(turning(10).quaternion(), Vec3(-0.06 * (k - 10), 0, 0));
  };
  expectAccurate(run(World{}, path, 40), path);
}

TEST(Initializer, NeverStartsStandingStill) {
  World world;
  Initializer initializer(camera(), {});
  const cv::Mat clean = world.render(SE3(), 10);
  cv::RNG noise(7);
  for (int k = 0; k < 60; ++k) {
    cv::Mat grain(clean.size(), CV_16S), image;
    noise.fill(grain, cv::RNG::NORMAL, 0, 4);
    cv::add(clean, grain, image, cv::noArray(), CV_8U);
    const InitializerOutput out = initializer.process({k, 0.05 * k, buildPyramid(image, 4)});
    ASSERT_FALSE(out.initialized) << out.reason;
    if (k > 0) {
      EXPECT_GT(out.tracks.size(), 50u);
      EXPECT_THAT(out.reason, testing::HasSubstr("median disparity"));
    }
  }
}

TEST(Initializer, ABlankWallGivesAReasonAndNoStart) {
  Initializer initializer(camera(), {});
  const PyramidPtr blank = buildPyramid(cv::Mat(300, 400, CV_8U, cv::Scalar(128)), 4);
  for (int k = 0; k < 3; ++k) {
    const InitializerOutput out = initializer.process({k, 0.05 * k, blank});
    EXPECT_FALSE(out.initialized);
    EXPECT_THAT(out.reason, testing::HasSubstr("features"));
  }
}

TEST(Initializer, RunsAreBitIdentical) {
  const InitializerOutput a = run(World{}, sideways, 25), b = run(World{}, sideways, 25);
  ASSERT_EQ(a.points.size(), b.points.size());
  EXPECT_EQ(a.T_cur_ref.matrix(), b.T_cur_ref.matrix());
  for (std::size_t i = 0; i < a.points.size(); ++i) EXPECT_EQ(a.points[i].p_ref, b.points[i].p_ref);
}

}  // namespace
}  // namespace svoscope
