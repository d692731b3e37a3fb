// SPDX-License-Identifier: MIT
#include "engine/geometry/se3.h"

#include <gtest/gtest.h>

#include <random>

namespace svoscope {
namespace {

Vec6 randomTwist(std::mt19937& rng, double rotation) {
  std::uniform_real_distribution<double> u(-1, 1);
  Vec6 x;
  for (int i = 0; i < 6; ++i) x[i] = u(rng) * (i < 3 ? 2.0 : rotation);
  return x;
}

TEST(Se3, LogInvertsExpAtAllScales) {
  std::mt19937 rng(1);
  for (double rotation : {1e-9, 1e-5, 1e-3, 0.1, 1.5}) {
    for (int i = 0; i < 50; ++i) {
      const Vec6 x = randomTwist(rng, rotation);
      EXPECT_LT((SE3::exp(x).log() - x).norm(), 1e-9) << "rotation scale " << rotation;
    }
  }
}

TEST(Se3, ExpMatchesTheMatrixSeries) {
  std::mt19937 rng(2);
  for (int i = 0; i < 20; ++i) {
    const Vec6 x = randomTwist(rng, 0.8);
    Mat4 A = Mat4::Zero();
    A.topLeftCorner<3, 3>() = hat(x.tail<3>());
    A.topRightCorner<3, 1>() = x.head<3>();
    Mat4 sum = Mat4::Identity(), term = Mat4::Identity();
    for (int n = 1; n < 30; ++n) {
      term = term * A / n;
      sum += term;
    }
    EXPECT_LT((SE3::exp(x).matrix() - sum).norm(), 1e-10);
  }
}

TEST(Se3, InverseAndCompositionAgreeWithMatrices) {
  std::mt19937 rng(3);
  for (int i = 0; i < 20; ++i) {
    const SE3 A = SE3::exp(randomTwist(rng, 1.0)), B = SE3::exp(randomTwist(rng, 1.0));
    EXPECT_LT(((A * B).matrix() - A.matrix() * B.matrix()).norm(), 1e-12);
    EXPECT_LT(((A * A.inverse()).matrix() - Mat4::Identity()).norm(), 1e-12);
  }
}

}  // namespace
}  // namespace svoscope
