// SPDX-License-Identifier: MIT
// Calibration files of other tools.
#include "engine/dataset/calibration/calibration.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/dataset/calibration/layouts.h"
#include "tests/support/support.h"

namespace svoscope {
namespace {

using namespace test;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

Result<Calibration> readText(const std::string& text, ImageSize images = {}) {
  TemporaryFolder folder;
  writeText(folder / "camera.yaml", text);
  return readCalibration(folder / "camera.yaml", images);
}

Calibration good(const std::string& text, ImageSize images = {}) {
  const auto read = readText(text, images);
  EXPECT_TRUE(read.ok()) << (read.ok() ? "" : read.error().message());
  return read.ok() ? read.value() : Calibration{};
}

std::string problem(const std::string& text) {
  const auto read = readText(text);
  return read.ok() ? "read" : read.error().message();
}

void expectPinhole(const Calibration& c, const Pinhole& want) {
  const Pinhole& p = c.camera.pinhole;
  EXPECT_EQ(p.width, want.width);
  EXPECT_EQ(p.height, want.height);
  EXPECT_NEAR(p.fx, want.fx, 1e-9);
  EXPECT_NEAR(p.fy, want.fy, 1e-9);
  EXPECT_NEAR(p.cx, want.cx, 1e-9);
  EXPECT_NEAR(p.cy, want.cy, 1e-9);
}

const Pinhole kVga{640, 480, 500, 510, 320, 240};

const char* const kKalibr =
    "cam0:\n  camera_model: pinhole\n  intrinsics: [500, 510, 320, 240]\n"
    "  distortion_model: equi\n  distortion_coeffs: [0.01, 0.02, 0.03, 0.04]\n"
    "  resolution: [640, 480]\n"
    "  T_cam_imu:\n  - [0, 1, 0, 0.5]\n  - [-1, 0, 0, 0]\n  - [0, 0, 1, 0]\n  - [0, 0, 0, 1]\n";
const char* const kRos =
    "image_width: 640\nimage_height: 480\ncamera_name: c\ncamera_matrix:\n  rows: 3\n  cols: 3\n"
    "  data: [500, 0, 320, 0, 510, 240, 0, 0, 1]\ndistortion_model: rational_polynomial\n"
    "distortion_coefficients:\n  rows: 1\n  cols: 8\n"
    "  data: [0.1, 0.2, 0.001, 0.002, 0.3, 0.4, 0.5, 0.6]\n";
const char* const kOpenCv =
    "%YAML:1.0\n---\nimage_width: 640\nimage_height: 480\ncamera_matrix: !!opencv-matrix\n"
    "   rows: 3\n   cols: 3\n   dt: d\n   data: [ 500., 0., 320., 0., 510., 240., 0., 0., 1. ]\n"
    "distortion_coefficients: !!opencv-matrix\n   rows: 5\n   cols: 1\n   dt: d\n"
    "   data: [ 0.1, -0.2, 0.001, 0.002, 0. ]\n";
const char* const kOrb3 =
    "%YAML:1.0\nFile.version: \"1.0\"\nCamera.type: \"KannalaBrandt8\"\nCamera1.fx: 500\n"
    "Camera1.fy: 510\nCamera1.cx: 320\nCamera1.cy: 240\nCamera1.k1: 0.1\nCamera1.k2: 0.2\n"
    "Camera1.k3: 0.3\nCamera1.k4: 0.4\nCamera.width: 640\nCamera.height: 480\nCamera.fps: 20\n";
const char* const kAtan =
    "cam_model: ATAN\ncam_width: 640\ncam_height: 480\ncam_fx: 0.5\ncam_fy: 0.75\ncam_cx: 0.5\n"
    "cam_cy: 0.5\ncam_d0: 0.9\n";
const char* const kSvoPro =
    "cameras:\n- camera:\n    type: pinhole\n    image_width: 640\n    image_height: 480\n"
    "    intrinsics:\n      cols: 1\n      rows: 4\n      data: [500, 510, 320, 240]\n"
    "    distortion:\n      type: radial-tangential\n      parameters:\n        cols: 1\n"
    "        rows: 4\n        data: [0.1, 0.2, 0.003, 0.004]\n  T_B_C:\n    cols: 4\n    rows: 4\n"
    "    data: [1, 0, 0, 0.1, 0, 1, 0, 0.2, 0, 0, 1, 0.3, 0, 0, 0, 1]\nlabel: x\n";
const char* const kVins =
    "%YAML:1.0\n---\nmodel_type: PINHOLE\ncamera_name: camera\nimage_width: 640\n"
    "image_height: 480\ndistortion_parameters:\n   k1: -0.2\n   k2: 0.08\n   p1: 0.001\n"
    "   p2: 0.002\nprojection_parameters:\n   fx: 500\n   fy: 510\n   cx: 320\n   cy: 240\n";
const char* const kBasalt =
    "{\"value0\": {\"T_imu_cam\": [{\"px\": 1, \"py\": 2, \"pz\": 3, \"qx\": 0, \"qy\": 0, "
    "\"qz\": 0, \"qw\": 1}], \"intrinsics\": [{\"camera_type\": \"kb4\", \"intrinsics\": "
    "{\"fx\": 500, \"fy\": 510, \"cx\": 320, \"cy\": 240, \"k1\": 0.1, \"k2\": 0.2, "
    "\"k3\": 0.3, \"k4\": 0.4}}], \"resolution\": [[640, 480]]}}";
const char* const kColmap =
    "# Camera list\n#   CAMERA_ID, MODEL, WIDTH, HEIGHT, PARAMS[]\n"
    "1 SIMPLE_RADIAL 640 480 500 320.5 240.5 0.05\n";

TEST(Calibration, Kalibr) {
  const Calibration c = good(kKalibr);
  EXPECT_EQ(c.format, "Kalibr camchain");
  expectPinhole(c, kVga);
  EXPECT_EQ(c.camera.distortion, Distortion::equidistant);
  EXPECT_THAT(c.camera.coefficients, ElementsAre(0.01, 0.02, 0.03, 0.04));
  ASSERT_TRUE(c.has_body);
  // T_cam_imu takes the body's origin to (0.5, 0, 0) of the camera; T_body_cam is its inverse.
  EXPECT_LT((c.T_body_cam * Vec3(0.5, 0, 0)).norm(), 1e-12);
  EXPECT_LT((c.T_body_cam * Vec3(0.5, -1, 0) - Vec3(1, 0, 0)).norm(), 1e-12);
}

TEST(Calibration, Ros) {
  const Calibration c = good(kRos);
  EXPECT_EQ(c.format, "ROS camera_info");
  expectPinhole(c, kVga);
  EXPECT_EQ(c.camera.distortion, Distortion::radtan);
  EXPECT_THAT(c.camera.coefficients, ElementsAre(0.1, 0.2, 0.001, 0.002, 0.3, 0.4, 0.5, 0.6));
}

TEST(Calibration, OpenCv) {
  const Calibration c = good(kOpenCv);
  EXPECT_EQ(c.format, "OpenCV FileStorage");
  expectPinhole(c, kVga);
  EXPECT_THAT(c.camera.coefficients, ElementsAre(0.1, -0.2, 0.001, 0.002));
}

TEST(Calibration, OrbSlam) {
  const Calibration c = good(kOrb3);
  EXPECT_EQ(c.format, "ORB-SLAM settings");
  expectPinhole(c, kVga);
  EXPECT_EQ(c.camera.distortion, Distortion::equidistant);
  EXPECT_EQ(c.camera.rate_hz, 20);
  const char* const kOrb2 =
      "%YAML:1.0\nCamera.fx: 500\nCamera.fy: 510\nCamera.cx: 320\nCamera.cy: 240\n"
      "Camera.k1: 0\nCamera.k2: 0\nCamera.p1: 0\nCamera.p2: 0\nCamera.fps: 30.0\n";
  // ORB-SLAM2 files may leave the size to the images.
  const Calibration two = good(kOrb2, {640, 480});
  expectPinhole(two, kVga);
  EXPECT_EQ(two.camera.distortion, Distortion::none);
  EXPECT_THAT(two.notes, ElementsAre(HasSubstr("no resolution")));
  EXPECT_THAT(problem(kOrb2), HasSubstr("resolution"));
}

TEST(Calibration, SvoAndSvoPro) {
  const Calibration atan = good(kAtan);
  expectPinhole(atan, {640, 480, 320, 360, 319.5, 239.5});
  EXPECT_EQ(atan.camera.distortion, Distortion::fov);
  const Calibration pro = good(kSvoPro);
  EXPECT_EQ(pro.format, "SVO Pro");
  expectPinhole(pro, kVga);
  EXPECT_LT((pro.T_body_cam.translation() - Vec3(0.1, 0.2, 0.3)).norm(), 1e-12);
}

TEST(Calibration, VinsAndBasalt) {
  const Calibration vins = good(kVins);
  EXPECT_EQ(vins.format, "VINS");
  expectPinhole(vins, kVga);
  EXPECT_THAT(vins.camera.coefficients, ElementsAre(-0.2, 0.08, 0.001, 0.002));
  const Calibration basalt = good(kBasalt);
  EXPECT_EQ(basalt.format, "basalt");
  expectPinhole(basalt, kVga);
  EXPECT_LT((basalt.T_body_cam.translation() - Vec3(1, 2, 3)).norm(), 1e-12);
}

TEST(Calibration, DsoAndColmap) {
  const Calibration pinhole = good("Pinhole 500 510 320 240 0\n640 480\ncrop\n640 480\n");
  EXPECT_EQ(pinhole.format, "DSO");
  expectPinhole(pinhole, kVga);
  const Calibration relative = good("0.5 0.75 0.5 0.5 0.9\n640 480\ncrop\n640 480\n");
  expectPinhole(relative, {640, 480, 320, 360, 319.5, 239.5});
  EXPECT_THAT(relative.camera.coefficients, ElementsAre(0.9));
  const Calibration colmap = good(kColmap);
  EXPECT_EQ(colmap.format, "COLMAP cameras.txt");
  expectPinhole(colmap, {640, 480, 500, 500, 320, 240});
  EXPECT_THAT(colmap.camera.coefficients, ElementsAre(0.05, 0, 0, 0));
}

TEST(Calibration, ModelsThatAreNotSupportedSayWhatToDo) {
  EXPECT_THAT(problem("cam0:\n  camera_model: omni\n  intrinsics: [1, 500, 500, 320, 240]\n"),
              HasSubstr("pinhole-equi"));
  EXPECT_THAT(problem("1 THIN_PRISM_FISHEYE 640 480 1 2 3 4 5 6 7 8 9 10 11 12\n"),
              HasSubstr("not THIN_PRISM_FISHEYE"));
  EXPECT_THAT(problem("model_type: MEI\nimage_width: 640\nimage_height: 480\n"
                      "projection_parameters: {gamma1: 1}\n"),
              HasSubstr("MEI"));
}

TEST(Calibration, IntrinsicsThatAreNoPixelsAreRefusedWithThePixels) {
  const std::string head =
      "cam0:\n  camera_model: pinhole\n  distortion_model: none\n"
      "  resolution: [200, 100]\n  intrinsics: ";
  const std::string relative = problem(head + "[0.5, 0.9, 0.5, 0.5]\n");
  EXPECT_THAT(relative, HasSubstr("relative to the image"));
  EXPECT_THAT(relative, HasSubstr("[100.000, 90.000, 99.500, 49.500]"));
  EXPECT_THAT(problem(head + "[4.2, 4.2, 3.1, 2.2]\n"), HasSubstr("millimetres"));
  EXPECT_THAT(problem(head + "[150, 150, 320, 50]\n"), HasSubstr("principal point"));
  EXPECT_EQ(problem(head + "[150, 150, 90, 50]\n"), "read");
}

/// Every layout cut off at any place is read or refused with a message that names the file.
TEST(Calibration, DamagedFilesAreErrors) {
  for (const char* text : {kKalibr, kRos, kOpenCv, kOrb3, kAtan, kSvoPro, kVins, kBasalt, kColmap,
                           "Pinhole 500 510 320 240 0\n640 480\n"}) {
    const std::string whole(text);
    for (std::size_t cut = 0; cut < whole.size(); cut += 3) {
      const auto read = readText(whole.substr(0, cut));
      if (read.ok()) {
        EXPECT_TRUE(read.value().camera.check().ok()) << whole.substr(0, cut);
      } else {
        EXPECT_THAT(read.error().message(), HasSubstr("camera.yaml")) << cut;
      }
    }
    std::string noise = whole;
    for (std::size_t i = 0; i < noise.size(); i += 7) noise[i] = static_cast<char>(i % 96 + 32);
    const auto read = readText(noise);
    if (!read.ok()) {
      EXPECT_THAT(read.error().message(), HasSubstr("camera.yaml"));
    }
  }
  EXPECT_THAT(problem("cam0:\n  intrinsics: [500, 500, .nan, 240]\n  resolution: [640, 480]\n"
                      "  distortion_model: none\n"),
              HasSubstr("not finite"));
}

TEST(Calibration, EveryLayoutHasANameAndAForm) {
  for (const CalibrationLayout* layout : calibrationLayouts()) {
    EXPECT_GT(std::string(layout->name).size(), 2u);
    EXPECT_GT(std::string(layout->form).size(), 20u) << layout->name;
  }
}

}  // namespace
}  // namespace svoscope
