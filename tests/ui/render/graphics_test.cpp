// SPDX-License-Identifier: MIT
#include "ui/render/graphics.h"

#include <opencv2/core.hpp>

#include "tests/ui/render/render_fixture.h"

namespace svoscope::ui {
namespace {

/// Draws the texture 1:1 at the top left and returns what is seen.
cv::Mat shown(Host& host, const std::function<ImTextureID()>& texture, int width, int height) {
  DrawFunction content([&] {
    ImDrawList& list = *ImGui::GetForegroundDrawList();
    const ImVec2 size(static_cast<float>(width), static_cast<float>(height));
    list.AddImage(texture(), {0, 0}, size);
  });
  host.frame(content);
  return host.pixels().value()(cv::Rect(0, 0, width, height)).clone();
}

cv::Mat noise(int width, int height, int type) {
  cv::Mat image(height, width, type);
  cv::RNG rng(7);
  rng.fill(image, cv::RNG::UNIFORM, 0, 256);
  return image;
}

TEST(GlGraphics, GreyImagesOfOddWidthAndStepRoundTripExactly) {
  SVOSCOPE_OSMESA_HOST(host, 64, 48);
  const cv::Mat grey = noise(40, 23, CV_8UC1)(cv::Rect(0, 0, 37, 23));
  ASSERT_EQ(grey.step[0], 40u);
  const cv::Mat picture =
      shown(*host, [&] { return host->graphics().image(1, grey, 1, false); }, 37, 23);
  for (int y = 0; y < 23; ++y) {
    for (int x = 0; x < 37; ++x) {
      const uchar g = grey.at<uchar>(y, x);
      ASSERT_EQ(picture.at<cv::Vec3b>(y, x), cv::Vec3b(g, g, g)) << x << ", " << y;
    }
  }
}

TEST(GlGraphics, ColourPartsOfLargerImagesRoundTripExactly) {
  SVOSCOPE_OSMESA_HOST(host, 64, 48);
  const cv::Mat colour = noise(50, 40, CV_8UC3)(cv::Rect(5, 3, 33, 21));
  const cv::Mat picture =
      shown(*host, [&] { return host->graphics().image(1, colour, 1, true); }, 33, 21);
  EXPECT_EQ(cv::norm(picture, colour, cv::NORM_INF), 0);
}

TEST(GlGraphics, UploadsAgainForANewVersionSizeOrTypeOnly) {
  SVOSCOPE_OSMESA_HOST(host, 64, 48);
  cv::Mat grey(8, 8, CV_8UC1, cv::Scalar(50));
  const auto level = [&](std::uint64_t version) {
    return shown(*host, [&] { return host->graphics().image(1, grey, version, false); }, 8, 8)
        .at<cv::Vec3b>(4, 4)[0];
  };
  EXPECT_EQ(level(1), 50);
  grey.setTo(90);
  EXPECT_EQ(level(1), 50);
  EXPECT_EQ(level(2), 90);
  grey = cv::Mat(6, 5, CV_8UC1, cv::Scalar(120));
  EXPECT_EQ(level(2), 120);
  grey = cv::Mat();
  EXPECT_EQ(level(3), 0);
}

Eigen::Matrix4f perspective() {
  // Camera at the origin looking along +z, y down as in images, 90 degrees wide.
  Eigen::Matrix4f clip = Eigen::Matrix4f::Zero();
  const float near = 0.1f, far = 100;
  clip(0, 0) = 1;
  clip(1, 1) = -1;
  clip(2, 2) = (far + near) / (far - near);
  clip(2, 3) = -2 * far * near / (far - near);
  clip(3, 2) = 1;
  return clip;
}

/// Pixel at which a camera-frame position must appear in a square picture.
cv::Point expectedPixel(const Eigen::Vector3f& position, int side) {
  const float half = static_cast<float>(side) / 2;
  return {static_cast<int>(half + half * position.x() / position.z()),
          static_cast<int>(half + half * position.y() / position.z())};
}

TEST(GlGraphics, PointsLandWhereTheMatrixSays) {
  SVOSCOPE_OSMESA_HOST(host, 200, 200);
  const Eigen::Vector3f positions[] = {{0.52f, 0.22f, 1}, {-1.5f, 1.22f, 2}, {0.62f, -1.78f, 2}};
  Scene3 scene;
  scene.version = 1;
  scene.point_size_px = 7;
  scene.background = IM_COL32(0, 0, 40, 255);
  scene.clip_from_world = perspective();
  for (const auto& p : positions) scene.points.push_back({p, IM_COL32(250, 200, 0, 255)});
  scene.points.push_back({{0, 0, -1}, IM_COL32(255, 0, 255, 255)});  // behind: invisible
  const cv::Mat picture =
      shown(*host, [&] { return host->graphics().scene(1, scene, 200, 200); }, 200, 200);
  cv::Mat lit(200, 200, CV_8UC1);
  for (int i = 0; i < 200 * 200; ++i)
    lit.at<uchar>(i / 200, i % 200) = picture.at<cv::Vec3b>(i / 200, i % 200)[0] > 100;
  for (const auto& p : positions) {
    const cv::Point px = expectedPixel(p, 200);
    EXPECT_EQ(picture.at<cv::Vec3b>(px), cv::Vec3b(250, 200, 0)) << px;
    EXPECT_NEAR(cv::countNonZero(lit(cv::Rect(px.x - 6, px.y - 6, 13, 13))), 38, 8);  // pi 3.5^2
  }
  EXPECT_EQ(picture.at<cv::Vec3b>(100, 100), cv::Vec3b(0, 0, 40));
}

TEST(GlGraphics, LinesHaveTheirWidthOnScreenAndAreClippedBehindTheCamera) {
  SVOSCOPE_OSMESA_HOST(host, 200, 200);
  Scene3 scene;
  scene.version = 1;
  scene.line_width_px = 4;
  scene.background = IM_COL32(0, 0, 0, 255);
  scene.clip_from_world = perspective();
  const ImU32 white = IM_COL32(255, 255, 255, 255), green = IM_COL32(0, 255, 0, 255);
  // Level line at y = +0.5 (row 150), and one from far ahead to behind the camera, right of it.
  scene.lines = {{{-0.5f, 0.5f, 1}, white}, {{0.5f, 0.5f, 1}, white},
                 {{0.3f, 0, 50}, green},    {{0.3f, 0, -1}, green}};
  const cv::Mat picture =
      shown(*host, [&] { return host->graphics().scene(1, scene, 200, 200); }, 200, 200);
  int sum = 0;
  for (int y = 140; y < 160; ++y) sum += picture.at<cv::Vec3b>(y, 100)[0];
  EXPECT_NEAR(sum / 255.0, 4, 0.3);
  EXPECT_EQ(picture.at<cv::Vec3b>(150, 100), cv::Vec3b(255, 255, 255));
  EXPECT_EQ(picture.at<cv::Vec3b>(150, 30)[0], 0);
  EXPECT_EQ(picture.at<cv::Vec3b>(100, 150), cv::Vec3b(0, 255, 0));
  EXPECT_EQ(picture.at<cv::Vec3b>(100, 195), cv::Vec3b(0, 255, 0));
  EXPECT_EQ(picture.at<cv::Vec3b>(100, 40), cv::Vec3b(0, 0, 0)) << "no mirror image on the left";
}

TEST(GlGraphics, NearerPointsHideFartherOnesAndTheCameraMovesWithoutUpload) {
  SVOSCOPE_OSMESA_HOST(host, 100, 100);
  Scene3 scene;
  scene.version = 1;
  scene.point_size_px = 11;
  scene.clip_from_world = perspective();
  scene.points = {{{0, 0, 1}, IM_COL32(255, 0, 0, 255)}, {{0, 0, 3}, IM_COL32(0, 255, 0, 255)}};
  const auto picture = [&] {
    return shown(*host, [&] { return host->graphics().scene(1, scene, 100, 100); }, 100, 100);
  };
  EXPECT_EQ(picture().at<cv::Vec3b>(50, 50), cv::Vec3b(255, 0, 0));
  Eigen::Matrix4f shift = Eigen::Matrix4f::Identity();
  shift(0, 3) = 0.5f;
  scene.clip_from_world = perspective() * shift;
  EXPECT_EQ(picture().at<cv::Vec3b>(50, 75), cv::Vec3b(255, 0, 0));
  EXPECT_EQ(picture().at<cv::Vec3b>(50, 58), cv::Vec3b(0, 255, 0));
}

}  // namespace
}  // namespace svoscope::ui
