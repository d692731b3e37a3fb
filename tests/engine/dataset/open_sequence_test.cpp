// SPDX-License-Identifier: MIT
// The other layouts: EuRoC/ASL, KITTI odometry, image folder, video.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <opencv2/videoio.hpp>

#include "engine/dataset/list_sequence.h"
#include "tests/engine/dataset/tiny_sequence.h"

namespace svoscope {
namespace {

using namespace test;
using ::testing::AllOf;
using ::testing::HasSubstr;

const char* const kSensor =
    "# camera\nsensor_type: camera\nT_BS:\n  cols: 4\n  rows: 4\n"
    "  data: [0, -1, 0, 0.5, 1, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]\n"
    "rate_hz: 20\nresolution: [32, 24]\ncamera_model: pinhole\nintrinsics: [40, 40, 16, 12]\n"
    "distortion_model: radial-tangential\ndistortion_coefficients: [-0.1, 0.01, 0, 0]\n";

void writeAsl(const std::filesystem::path& mav) {
  writeTinyImage(mav / "cam0/data/1000000000500000000.png", 60);
  writeTinyImage(mav / "cam0/data/1000000000550000000.png", 90);
  writeFile(mav / "cam0/data.csv",
            "#timestamp [ns],filename\r\n1000000000500000000,1000000000500000000.png\r\n"
            "1000000000550000000,1000000000550000000.png\r\n");
  writeFile(mav / "cam0/sensor.yaml", kSensor);
  writeFile(mav / "state_groundtruth_estimate0/data.csv",
            "#timestamp,p,q\n1000000000500000000,1,2,3,0,0,0,1,0,0,0\n");
}

TEST(EurocSequence, TurnsBodyPosesIntoCameraPoses) {
  TemporaryFolder folder;
  writeAsl(folder / "V1/mav0");
  for (const auto& spec : {folder / "V1", folder / "V1/mav0"}) {
    auto opened = openSequence(spec.string());
    ASSERT_TRUE(opened.ok()) << opened.error().message();
    Sequence& s = *opened.value();
    EXPECT_EQ(s.name(), "V1");
    ASSERT_EQ(s.size(), 2);
    EXPECT_NEAR(s.timestamp(1), 1000000000.55, 1e-6);
    EXPECT_EQ(grayOf(s, 1), 90);
    EXPECT_EQ(s.camera().distortion, Distortion::radtan);
    // Body turned by 180 degrees about z at (1, 2, 3), camera 0.5 m along the body's x axis.
    ASSERT_EQ(s.groundTruth().size(), 1u);
    const SE3& T = s.groundTruth()[0].T_world_cam;
    EXPECT_LT((T.translation() - Vec3(0.5, 2, 3)).norm(), 1e-9);
    EXPECT_LT((T * Vec3(1, 0, 0) - Vec3(0.5, 1, 3)).norm(), 1e-9);
  }
}

TEST(EurocSequence, ErrorsNameTheFile) {
  TemporaryFolder folder;
  const auto mav = folder / "V1" / "mav0";
  writeAsl(mav);
  writeText(mav / "cam0/data.csv", "5,a.png\n4,b.png\n");
  EXPECT_THAT(openingError(folder / "V1"), HasSubstr("data.csv:2: time does not increase"));
  writeText(mav / "cam0/data.csv", "0.5,a.png\n");
  EXPECT_THAT(openingError(folder / "V1"), HasSubstr("data.csv:1: not a line"));
  writeAsl(mav);
  std::filesystem::remove(mav / "cam0/sensor.yaml");
  EXPECT_THAT(openingError(folder / "V1"), HasSubstr("sensor.yaml is missing"));
  std::filesystem::remove(mav / "cam0/data.csv");
  EXPECT_THAT(openingError(folder / "V1"),
              AllOf(HasSubstr("data.csv is missing"), HasSubstr("ASL")));
}

void writeKitti(const std::filesystem::path& root) {
  for (int i = 0; i < 3; ++i)
    writeTinyImage(root / "sequences/00/image_0" / ("00000" + std::to_string(i) + ".png"), 40 + i);
  writeFile(root / "sequences/00/calib.txt",
            "P0: 7.1e1 0 16 0 0 7.2e1 12 0 0 0 1 0\nP1: 71 0 16 -38 0 72 12 0 0 0 1 0\n");
  writeFile(root / "sequences/00/times.txt", "0.0\n1.0e-01\n2.0e-01\n");
  writeFile(root / "poses/00.txt",
            "1 0 0 0 0 1 0 0 0 0 1 0\n1 0 0 0 0 1 0 0 0 0 1 0.8\n1 0 0 0 0 1 0 0 0 0 1 1.6\n");
}

TEST(KittiSequence, ReadsCalibrationTimesAndPoses) {
  TemporaryFolder folder;
  writeKitti(folder.path());
  auto opened = openSequence((folder / "sequences/00").string());
  ASSERT_TRUE(opened.ok()) << opened.error().message();
  Sequence& s = *opened.value();
  EXPECT_EQ(s.name(), "00");
  ASSERT_EQ(s.size(), 3);
  EXPECT_EQ(s.camera().pinhole.fx, 71.0);
  EXPECT_EQ(s.camera().pinhole.width, 32);
  EXPECT_NEAR(s.camera().rate_hz, 10, 1e-9);
  EXPECT_EQ(grayOf(s, 2), 42);
  ASSERT_EQ(s.groundTruth().size(), 3u);
  EXPECT_EQ(s.groundTruth()[1].timestamp, 0.1);
  EXPECT_EQ(s.groundTruth()[1].T_world_cam.translation().z(), 0.8);
}

TEST(KittiSequence, AMissingImageShiftsNothing) {
  TemporaryFolder folder;
  writeKitti(folder.path());
  std::filesystem::remove(folder / "sequences/00/image_0/000001.png");
  auto opened = openSequence((folder / "sequences/00").string());
  ASSERT_TRUE(opened.ok()) << opened.error().message();
  Sequence& s = *opened.value();
  ASSERT_EQ(s.size(), 2);
  EXPECT_EQ(s.timestamp(1), 0.2);
  ASSERT_EQ(s.groundTruth().size(), 2u);
  EXPECT_EQ(s.groundTruth()[1].T_world_cam.translation().z(), 1.6);
}

TEST(KittiSequence, CountsThatDifferAreAnError) {
  TemporaryFolder folder;
  writeKitti(folder.path());
  writeFile(folder / "poses/00.txt", "1 0 0 0 0 1 0 0 0 0 1 0\n1 0 0 0 0 1 0 0 0 0 1 0.8\n");
  EXPECT_THAT(openingError(folder / "sequences/00"),
              AllOf(HasSubstr("2 poses for 3 times"), HasSubstr("move the poses away")));
}

TEST(KittiSequence, TheColourCameraIsBesideTheGreyOne) {
  TemporaryFolder folder;
  writeKitti(folder.path());
  const auto drive = folder / "sequences/00";
  std::filesystem::rename(drive / "image_0", drive / "image_2");
  writeFile(drive / "calib.txt", "P2: 50 0 16 -5 0 50 12 0 0 0 1 0\n");
  auto opened = openSequence(drive.string());
  ASSERT_TRUE(opened.ok()) << opened.error().message();
  EXPECT_EQ(opened.value()->camera().pinhole.fx, 50);
  EXPECT_NEAR(opened.value()->groundTruth()[0].T_world_cam.translation().x(), 0.1, 1e-12);
}

TEST(KittiSequence, ErrorsNameTheFile) {
  TemporaryFolder folder;
  writeKitti(folder.path());
  const auto drive = folder / "sequences/00";
  writeText(drive / "times.txt", "0.0\n");
  EXPECT_THAT(openingError(drive),
              AllOf(HasSubstr("times.txt"), HasSubstr("1 times for 3 images")));
  writeText(drive / "times.txt", "0.0\n0.2\n0.1\n");
  EXPECT_THAT(openingError(drive), HasSubstr("times.txt:3: time does not increase"));
  writeKitti(folder.path());
  writeText(drive / "calib.txt", "P1: 1 2 3\n");
  EXPECT_THAT(openingError(drive), AllOf(HasSubstr("calib.txt"), HasSubstr("no line P0")));
  std::filesystem::remove_all(drive / "image_0");
  EXPECT_THAT(openingError(drive), AllOf(HasSubstr("image_0"), HasSubstr("no images")));
}

TEST(ImageFolder, SortsNumbersAsNumbers) {
  TemporaryFolder folder;
  for (int i : {1, 2, 10}) writeTinyImage(folder / ("img" + std::to_string(i) + ".png"), i * 10);
  EXPECT_THAT(openingError(folder.path()), HasSubstr("camera.yaml is missing"));
  writeText(folder / "camera.yaml", kTinyCamera);
  auto opened = openSequence(folder.path().string());
  ASSERT_TRUE(opened.ok()) << opened.error().message();
  EXPECT_EQ(grayOf(*opened.value(), 1), 20);
  EXPECT_EQ(grayOf(*opened.value(), 2), 100);
  EXPECT_NEAR(opened.value()->timestamp(2), 0.1, 1e-12) << "rate_hz is 20";
  EXPECT_EQ(opened.value()->timeSource(), TimeSource::rate);
}

std::string cameraWithoutRate() {
  const std::string text = kTinyCamera;
  return text.substr(0, text.find("  rate_hz"));
}

TEST(ImageFolder, UnknownTimesAreAssumedAndSaidSo) {
  TemporaryFolder folder;
  for (int i : {0, 1}) writeTinyImage(folder / ("00000" + std::to_string(i) + ".png"), 50);
  writeText(folder / "camera.yaml", cameraWithoutRate());
  auto opened = openSequence(folder.path().string());
  ASSERT_TRUE(opened.ok()) << opened.error().message();
  EXPECT_EQ(opened.value()->timeSource(), TimeSource::assumed);
  ASSERT_EQ(opened.value()->notes().size(), 1u);
  EXPECT_THAT(opened.value()->notes()[0], AllOf(HasSubstr("30 Hz"), HasSubstr("--rate")));
  OpenOptions options;
  options.rate_hz = 50;
  auto rated = openSequence(folder.path().string(), options);
  ASSERT_TRUE(rated.ok());
  EXPECT_EQ(rated.value()->timeSource(), TimeSource::rate);
  EXPECT_NEAR(rated.value()->timestamp(1), 0.02, 1e-12);
  EXPECT_TRUE(rated.value()->notes().empty());
}

TEST(ImageFolder, NamesThatAreTimesAreUsed) {
  TemporaryFolder folder;
  for (const char* name : {"1403715273262142976.png", "1403715273312142976.png"})
    writeTinyImage(folder / "images" / name, 50);
  writeText(folder / "camchain-cam0.yaml", kTinyCamera);
  auto opened = openSequence(folder.path().string());
  ASSERT_TRUE(opened.ok()) << opened.error().message();
  Sequence& s = *opened.value();
  EXPECT_EQ(s.timeSource(), TimeSource::file_names);
  EXPECT_NEAR(s.timestamp(1) - s.timestamp(0), 0.05, 1e-6);
}

TEST(TumMono, TimesBelongToTheNamesOfTheImages) {
  TemporaryFolder folder;
  for (int i : {0, 1, 2})
    writeTinyImage(folder / "images" / ("0000" + std::to_string(i) + ".png"), 50);
  writeText(folder / "times.txt", "00000 10.0 0.9\n00001 10.05 0.9\n00002 10.1 0.9\n");
  writeText(folder / "camera.txt", "Pinhole 40 41 15.5 11.5 0\n32 24\ncrop\n32 24\n");
  writeText(folder / "groundtruthSync.txt",
            "10 0 0 0 0 0 0 1\n10.05 nan nan nan nan nan nan nan\n");
  auto opened = openSequence(folder.path().string());
  ASSERT_TRUE(opened.ok()) << opened.error().message();
  EXPECT_EQ(opened.value()->timestamp(2), 10.1);
  EXPECT_EQ(opened.value()->groundTruth().size(), 1u);
  writeText(folder / "times.txt", "00000 10.0 0.9\n");
  EXPECT_THAT(openingError(folder.path()), HasSubstr("no time for the image"));
}

TEST(VideoSequence, ReadsForwardAndBackward) {
  TemporaryFolder folder;
  const std::string file = (folder / "flight.avi").string();
  cv::VideoWriter writer(file, cv::CAP_OPENCV_MJPEG, cv::VideoWriter::fourcc('M', 'J', 'P', 'G'),
                         25, {32, 24});
  if (!writer.isOpened()) GTEST_SKIP() << "this OpenCV writes no videos";
  for (int i = 0; i < 6; ++i) writer.write(cv::Mat(24, 32, CV_8UC3, cv::Scalar::all(30 + 30 * i)));
  writer.release();
  EXPECT_THAT(openingError(file), HasSubstr("a video needs its calibration beside it"));
  writeText(folder / "flight.yaml", kTinyCamera);
  auto opened = openSequence(file);
  ASSERT_TRUE(opened.ok()) << opened.error().message();
  Sequence& s = *opened.value();
  EXPECT_EQ(s.size(), 6);
  for (int i : {0, 1, 4, 4, 2, 5, 0}) EXPECT_NEAR(grayOf(s, i), 30 + 30 * i, 3) << i;
  // The container says 25 Hz, the calibration 20.
  EXPECT_NEAR(s.timestamp(2), 0.08, 1e-9);
  ASSERT_EQ(s.notes().size(), 1u);
  EXPECT_THAT(s.notes()[0], AllOf(HasSubstr("20 Hz"), HasSubstr("25 Hz")));
  EXPECT_TRUE(s.groundTruth().empty());
}

TEST(OpenSequence, UnknownThingsListTheKnownKinds) {
  TemporaryFolder folder;
  EXPECT_THAT(openingError(folder / "nowhere"),
              AllOf(HasSubstr("nowhere"), HasSubstr("TUM RGB-D")));
  EXPECT_THAT(openingError(folder.path()), HasSubstr("no known sequence layout"));
  EXPECT_THAT(openingError(""), HasSubstr("no such file"));
  writeText(folder / "notes.avi", "no video");
  writeText(folder / "camera.yaml", kTinyCamera);
  EXPECT_THAT(openingError(folder / "notes.avi"), HasSubstr("cannot be opened"));
  EXPECT_THAT(openingError("synthetic:nothing"), HasSubstr("presets are room"));
}

TEST(OpenSequence, TheRemedyNamesEveryLayout) {
  EXPECT_THAT(openingError("/nonexistent"),
              HasSubstr("a sequence is synthetic:PRESET, a folder with rgb.txt (TUM RGB-D), mav0/ "
                        "(EuRoC/ASL), image_0/ (KITTI odometry), images/ and times.txt (TUM-mono, "
                        "DSO), images and camera.yaml or one video and its calibration, or a video "
                        "with its calibration beside"));
  TemporaryFolder folder;
  writeText(folder / "rgb.txt", "1 a.png\n");
  writeText(folder / "x.bag", "#ROSBAG V2.0");
  EXPECT_THAT(openingError(folder / "rgb.txt"), HasSubstr("give the folder"));
  EXPECT_THAT(openingError(folder / "x.bag"), HasSubstr("bags are not read"));
}

TEST(OpenSequence, APartOfALayoutIsToldWhatIsMissing) {
  TemporaryFolder folder;
  writeTinyImage(folder / "rgb/1.png", 60);
  EXPECT_THAT(openingError(folder.path()), HasSubstr("rgb.txt is missing"));
  writeTinyImage(folder / "1.png", 60);
  EXPECT_THAT(openingError(folder.path()), HasSubstr("camera.yaml"))
      << "now it is a folder of images";
}

TEST(OpenSequence, RealSequencesOpen) {
  SVOSCOPE_SKIP_WITHOUT_DATA(data);
  for (const auto& item : std::filesystem::directory_iterator(*data)) {
    if (!std::filesystem::exists(item.path() / "rgb.txt")) continue;
    const auto opened = openSequence(item.path().string());
    ASSERT_TRUE(opened.ok()) << opened.error().message();
    Sequence& s = *opened.value();
    EXPECT_FALSE(s.groundTruth().empty()) << s.name();
    EXPECT_TRUE(s.read(s.size() - 1).ok()) << s.name();
  }
}

}  // namespace
}  // namespace svoscope
