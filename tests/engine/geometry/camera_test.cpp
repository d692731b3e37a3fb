// SPDX-License-Identifier: MIT
#include "engine/geometry/camera.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace svoscope {
namespace {

using ::testing::HasSubstr;

struct Model {
  const char* label;
  Camera camera;
};

std::vector<Model> models() {
  const Pinhole euroc{752, 480, 458.654, 457.296, 367.215, 248.375};
  const Pinhole fisheye{752, 480, 380, 381, 370, 245};
  return {{"none", {euroc, Distortion::none, {}, 20}},
          {"radtan", {euroc, Distortion::radtan, {-0.2834, 0.0740, 1.9e-4, 1.8e-5}, 20}},
          {"rational",
           {euroc, Distortion::radtan, {0.35, 0.05, 4e-4, -2e-4, 0.001, 0.55, 0.12, 0.002}, 20}},
          {"tum-fr1", cameraPreset("tum-fr1").value()},
          {"tum-fr2", cameraPreset("tum-fr2").value()},
          {"tum-fr3", cameraPreset("tum-fr3").value()},
          {"equidistant", {fisheye, Distortion::equidistant, {-0.01, 0.02, -0.015, 0.004}, 0}},
          {"fov", {fisheye, Distortion::fov, {0.93}, 0}}};
}

TEST(Camera, ProjectInvertsUnprojectFromCornerToCorner) {
  for (const Model& m : models()) {
    ASSERT_TRUE(m.camera.check().ok()) << m.label;
    const Pinhole& p = m.camera.pinhole;
    for (int i = 0; i <= 20; ++i) {
      for (int j = 0; j <= 20; ++j) {
        const Vec2 px(i / 20.0 * (p.width - 1), j / 20.0 * (p.height - 1));
        const Vec3 ray = m.camera.unproject(px);
        ASSERT_TRUE(ray.allFinite()) << m.label << " at " << px.transpose();
        EXPECT_LT((m.camera.project(ray * 3.7) - px).norm(), 1e-6) << m.label;
      }
    }
  }
}

TEST(Camera, UnprojectInvertsProjectNearTheAxis) {
  for (const Model& m : models()) {
    for (double x : {-0.3, -1e-9, 0.0, 0.2}) {
      const Vec3 p(x, 0.25 * x, 1.0);
      EXPECT_LT((m.camera.unproject(m.camera.project(p)) - p).norm(), 1e-7) << m.label;
    }
  }
}

TEST(Camera, RadtanMatchesTheFormulaByHand) {
  const Camera c{{100, 100, 1, 1, 0, 0}, Distortion::radtan, {0.1, 0.01, 0.002, 0.003, 0.001}, 0};
  const double x = 0.5, y = -0.25, r2 = x * x + y * y;
  const double radial = 1 + 0.1 * r2 + 0.01 * r2 * r2 + 0.001 * r2 * r2 * r2;
  const Vec2 expected(x * radial + 2 * 0.002 * x * y + 0.003 * (r2 + 2 * x * x),
                      y * radial + 0.002 * (r2 + 2 * y * y) + 2 * 0.003 * x * y);
  EXPECT_LT((c.project({2 * x, 2 * y, 2}) - expected).norm(), 1e-14);
}

TEST(Camera, NoInverseIsNotFinite) {
  // k1 = -0.4 folds back at r = sqrt(1 / 1.2): radii beyond 0.609 are never reached.
  const Camera folding{{640, 480, 300, 300, 320, 240}, Distortion::radtan, {-0.4, 0, 0, 0}, 0};
  EXPECT_TRUE(folding.unproject({320 + 300 * 0.60, 240}).allFinite());
  EXPECT_FALSE(folding.unproject({320 + 300 * 0.62, 240}).allFinite());
  // A polynomial that falls and rises again: the far branch is no inverse.
  const Camera wavy{{640, 480, 300, 300, 320, 240}, Distortion::radtan, {-0.8, 0.2, 0, 0}, 0};
  EXPECT_FALSE(wavy.unproject({320 + 300 * 0.9, 240}).allFinite());
  const Camera fisheye{{900, 900, 280, 280, 450, 450}, Distortion::equidistant, {0, 0, 0, 0}, 0};
  EXPECT_FALSE(fisheye.unproject({0, 0}).allFinite()) << "130 degrees off the axis";
  const Camera fov{{900, 900, 280, 280, 450, 450}, Distortion::fov, {1.2}, 0};
  EXPECT_FALSE(fov.unproject({0, 0}).allFinite());
}

TEST(Camera, CheckNamesTheFieldThatIsWrong) {
  const Camera good = cameraPreset("tum-fr1").value();
  const auto complaint = [](const Camera& c) {
    const Status status = c.check();
    return status.ok() ? std::string("accepted") : status.error().message();
  };
  EXPECT_EQ(complaint(good), "accepted");
  Camera c = good;
  c.pinhole.height = 0;
  EXPECT_THAT(complaint(c), HasSubstr("resolution 640 x 0"));
  c = good;
  c.pinhole.fy = -1;
  EXPECT_THAT(complaint(c), HasSubstr("focal length"));
  c = good;
  c.pinhole.cx = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(complaint(c), HasSubstr("principal point"));
  c = good;
  c.coefficients.resize(3);
  EXPECT_THAT(complaint(c), HasSubstr("3 distortion coefficients"));
  c = good;
  c.coefficients[1] = std::numeric_limits<double>::infinity();
  EXPECT_THAT(complaint(c), HasSubstr("coefficient is not finite"));
  c = good;
  c.distortion = Distortion::fov;
  c.coefficients = {4.0};
  EXPECT_THAT(complaint(c), HasSubstr("angle w"));
}

TEST(Camera, NamesRoundTripAndUnknownNamesListTheKnown) {
  for (const char* name : {"none", "radtan", "equidistant", "fov"})
    EXPECT_STREQ(distortionName(parseDistortion(name).value()), name);
  EXPECT_EQ(parseDistortion("plumb_bob").value(), Distortion::radtan);
  EXPECT_THAT(parseDistortion("fisheye62").error().message(), HasSubstr("equidistant"));
  EXPECT_THAT(cameraPreset("tum-fr9").error().message(), HasSubstr("tum-fr3"));
}

}  // namespace
}  // namespace svoscope
