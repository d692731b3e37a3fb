// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/engine/dataset/tiny_sequence.h"

namespace svoscope {
namespace {

using namespace test;
using ::testing::AllOf;
using ::testing::HasSubstr;

TEST(TumSequence, ReadsImagesTruthAndDepth) {
  TemporaryFolder folder;
  writeTinyTum(folder / "walk");
  auto opened = openSequence((folder / "walk/").string());
  ASSERT_TRUE(opened.ok()) << opened.error().message();
  Sequence& s = *opened.value();
  EXPECT_EQ(s.name(), "walk");
  ASSERT_EQ(s.size(), 3);
  EXPECT_EQ(s.camera().distortion, Distortion::radtan);
  EXPECT_EQ(s.camera().pinhole.fy, 41.0);
  EXPECT_EQ(s.timestamp(1), 1.1);
  EXPECT_EQ(grayOf(s, 2), 150);
  EXPECT_EQ(grayOf(s, 0), 50);
  EXPECT_EQ(s.read(1).value().gray.type(), CV_8UC1);
  ASSERT_EQ(s.groundTruth().size(), 2u);
  EXPECT_EQ(s.groundTruth()[0].timestamp, 1.0);
  EXPECT_TRUE(s.readDepth(0).value().empty());
  EXPECT_FLOAT_EQ(s.readDepth(1).value().at<float>(5, 5), 1.5f);
}

TEST(TumSequence, KnowsTheBenchmarksCamerasByTheFolder) {
  TemporaryFolder folder;
  const auto walk = folder / "rgbd_dataset_freiburg2_desk";
  std::filesystem::create_directories(walk / "rgb");
  cv::imwrite((walk / "rgb/0.png").string(), cv::Mat(480, 640, CV_8UC1, cv::Scalar(9)));
  writeText(walk / "rgb.txt", "1.0 rgb/0.png\n");
  const auto opened = openSequence(walk.string());
  ASSERT_TRUE(opened.ok()) << opened.error().message();
  EXPECT_NEAR(opened.value()->camera().pinhole.fx, 520.908620, 1e-9);
  EXPECT_TRUE(opened.value()->groundTruth().empty());
}

TEST(TumSequence, DamagedListsNameFileAndLine) {
  TemporaryFolder folder;
  const auto walk = folder / "walk";
  writeTinyTum(walk);
  writeText(walk / "rgb.txt", "1.1 rgb/0.png\n1.1 rgb/1.png\n");
  EXPECT_THAT(openingError(walk), HasSubstr("rgb.txt:2: time does not increase"));
  writeText(walk / "rgb.txt", "nan rgb/0.png\n");
  EXPECT_THAT(openingError(walk), HasSubstr("rgb.txt:1: 'nan' is not a finite number"));
  writeText(walk / "rgb.txt", "1.0\n");
  EXPECT_THAT(openingError(walk), HasSubstr("rgb.txt:1: the file name is missing"));
  writeText(walk / "rgb.txt", "# timestamp filename\n");
  EXPECT_THAT(openingError(walk), HasSubstr("rgb.txt: the list is empty"));
  std::filesystem::remove(walk / "rgb.txt");
  EXPECT_THAT(openingError(walk), AllOf(HasSubstr("rgb.txt is missing"), HasSubstr("TUM folder")));
}

TEST(TumSequence, DamagedTruthNamesFileAndLine) {
  TemporaryFolder folder;
  writeTinyTum(folder / "walk");
  // A ground truth that cannot be read keeps nothing from opening.
  writeText(folder / "walk/groundtruth.txt", "1.0 0 0 x 0 0 0 1\n");
  const auto opened = openSequence((folder / "walk").string());
  ASSERT_TRUE(opened.ok()) << opened.error().message();
  EXPECT_TRUE(opened.value()->groundTruth().empty());
  ASSERT_EQ(opened.value()->notes().size(), 1u);
  EXPECT_THAT(opened.value()->notes()[0], HasSubstr("groundtruth.txt:1: 'x'"));
}

TEST(TumSequence, CameraFileErrorsNameTheKey) {
  TemporaryFolder folder;
  const auto walk = folder / "walk";
  writeTinyTum(walk);
  const auto with = [&](const std::string& text) {
    writeText(walk / "camera.yaml", text);
    return openingError(walk);
  };
  EXPECT_THAT(with("cam0:\n  intrinsics: [1, 2, 3]\n"), HasSubstr("intrinsics must hold 4"));
  EXPECT_THAT(with("cam0:\n  intrinsics: [1, 2, 3, 4]\n"), HasSubstr("resolution is missing"));
  EXPECT_THAT(with("cam0:\n  camera_model: omni\n"), HasSubstr("must be pinhole, not omni"));
  EXPECT_THAT(with("cam0:\n  intrinsics: [1, 2, 3, x]\n"), HasSubstr("intrinsics has the wrong"));
  EXPECT_THAT(with("cam0: ["), HasSubstr("not valid YAML"));
  EXPECT_THAT(with(""), HasSubstr("no calibration"));
  std::string text = kTinyCamera;
  text.replace(text.find("40.0"), 4, ".nan");
  EXPECT_THAT(with(text), AllOf(HasSubstr("camera.yaml"), HasSubstr("focal length")));
  std::filesystem::remove(walk / "camera.yaml");
  EXPECT_THAT(openingError(walk), HasSubstr("camera.yaml is missing"));
}

TEST(TumSequence, WrongResolutionNamesBothSizes) {
  TemporaryFolder folder;
  writeTinyTum(folder / "walk");
  writeTinyImage(folder / "walk/rgb/0.png", 50, 40);
  EXPECT_THAT(openingError(folder / "walk"),
              AllOf(HasSubstr("40 x 24"), HasSubstr("32 x 24"), HasSubstr("rgb/0.png"),
                    HasSubstr("camera.yaml")));
}

TEST(TumSequence, DamagedImagesAreErrorsOfTheirFrameOnly) {
  TemporaryFolder folder;
  const auto rgb = folder / "walk" / "rgb";
  writeTinyTum(folder / "walk");
  const std::string png = readText(rgb / "0.png");
  writeText(rgb / "0.png", png.substr(0, png.size() / 2));
  writeText(rgb / "1.png", "");
  auto opened = openSequence((folder / "walk").string());
  ASSERT_TRUE(opened.ok()) << opened.error().message();
  Sequence& s = *opened.value();
  EXPECT_THAT(s.read(0).error().message(), AllOf(HasSubstr("0.png"), HasSubstr("truncated")));
  EXPECT_THAT(s.read(1).error().message(), AllOf(HasSubstr("1.png"), HasSubstr("empty")));
  EXPECT_EQ(grayOf(s, 2), 150);
  writeText(rgb / "2.png", "no image at all");
  EXPECT_THAT(s.read(2).error().message(), HasSubstr("cannot be decoded"));
  std::filesystem::remove(rgb / "2.png");
  EXPECT_THAT(s.read(2).error().message(), HasSubstr("image is missing"));
  EXPECT_THAT(openingError(folder / "walk"), HasSubstr("2.png")) << "no readable image at all";
}

TEST(TumSequence, SixteenBitImagesKeepTheirSignificantBits) {
  TemporaryFolder folder;
  writeTinyTum(folder / "walk");
  for (int i = 0; i < 3; ++i) {
    cv::Mat image(24, 32, CV_16UC1, cv::Scalar(1000.0 * (i + 1)));
    image.at<std::uint16_t>(23, 31) =
        i == 2 ? 65535 : 4000;  // twelve bits, and later one that is saturated
    cv::imwrite((folder / "walk/rgb" / (std::to_string(i) + ".png")).string(), image);
  }
  auto opened = openSequence((folder / "walk").string());
  ASSERT_TRUE(opened.ok()) << opened.error().message();
  EXPECT_EQ(grayOf(*opened.value(), 2), 187) << "the scale of the first image holds for all";
  EXPECT_EQ(grayOf(*opened.value(), 0), 62);
  EXPECT_EQ(opened.value()->read(2).value().gray.at<std::uint8_t>(23, 31), 255);
}

TEST(TumSequence, TruncatedJpegIsNotMistakenForAnImage) {
  TemporaryFolder folder;
  writeTinyTum(folder / "walk");
  writeTinyImage(folder / "walk/rgb/1.jpg", 99);
  const std::string jpeg = readText(folder / "walk/rgb/1.jpg");
  writeText(folder / "walk/rgb/1.jpg", jpeg.substr(0, jpeg.size() - 40));
  writeText(folder / "walk/rgb.txt", "1.0 rgb/0.png\n1.1 rgb/1.jpg\n");
  auto opened = openSequence((folder / "walk").string());
  ASSERT_TRUE(opened.ok());
  EXPECT_THAT(opened.value()->read(1).error().message(), HasSubstr("truncated"));
}

}  // namespace
}  // namespace svoscope
