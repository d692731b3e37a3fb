// SPDX-License-Identifier: MIT
#include "engine/eval/alignment.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace svoscope {
namespace {

class RandomPoints {
 public:
  explicit RandomPoints(unsigned seed) : random_(seed) {}
  Vec3 next(double sigma = 1) {
    return sigma * Vec3(normal_(random_), normal_(random_), normal_(random_));
  }
  std::vector<Vec3> cloud(int n) {
    std::vector<Vec3> points;
    for (int i = 0; i < n; ++i) points.push_back(next());
    return points;
  }

 private:
  std::mt19937 random_;
  std::normal_distribution<double> normal_;
};

std::vector<Vec3> moveAll(const Sim3& S, const std::vector<Vec3>& points) {
  std::vector<Vec3> result;
  for (const Vec3& p : points) result.push_back(S * p);
  return result;
}

double squaredError(const Sim3& S, const std::vector<Vec3>& source,
                    const std::vector<Vec3>& target) {
  double sum = 0;
  for (std::size_t i = 0; i < source.size(); ++i) sum += (S * source[i] - target[i]).squaredNorm();
  return sum;
}

TEST(Alignment, RecoversRandomSimilarities) {
  RandomPoints random(1);
  for (int trial = 0; trial < 200; ++trial) {
    Sim3 truth;
    truth.scale = std::exp(random.next().x());
    truth.T = SE3(so3Exp(random.next()), random.next(10));
    const auto source = random.cloud(3 + trial % 20);
    const auto result = alignPoints(source, moveAll(truth, source), Alignment::sim3);
    ASSERT_TRUE(result.ok()) << result.error().message();
    EXPECT_NEAR(result.value().scale, truth.scale, 1e-9 * truth.scale);
    EXPECT_LT((result.value().T.rotation() - truth.T.rotation()).norm(), 1e-7);
    EXPECT_LT((result.value().T.translation() - truth.T.translation()).norm(), 1e-7);
  }
}

TEST(Alignment, NoSmallChangeOfTheResultIsBetter) {
  RandomPoints random(2);
  for (const Alignment mode : {Alignment::se3, Alignment::sim3}) {
    const auto source = random.cloud(30);
    auto target = moveAll(Sim3{1.3, SE3(so3Exp(random.next()), random.next())}, source);
    for (Vec3& p : target) p += random.next(0.2);
    const Sim3 best = alignPoints(source, target, mode).value();
    EXPECT_TRUE(mode == Alignment::sim3 || best.scale == 1);
    const double error = squaredError(best, source, target);
    for (int i = 0; i < 100; ++i) {
      Vec6 twist;
      twist << random.next(1e-3), random.next(1e-3);
      Sim3 other = best;
      other.T = SE3::exp(twist) * best.T;
      if (mode == Alignment::sim3) other.scale *= 1 + 1e-3 * random.next().x();
      EXPECT_GE(squaredError(other, source, target), error);
    }
  }
}

TEST(Alignment, MirroredPointsGiveARotationNotAReflection) {
  RandomPoints random(3);
  const auto source = random.cloud(20);
  auto target = source;
  for (Vec3& p : target) p.x() = -p.x();
  const auto result = alignPoints(source, target, Alignment::sim3);
  ASSERT_TRUE(result.ok());
  EXPECT_NEAR(result.value().T.rotation().determinant(), 1, 1e-9);
}

TEST(Alignment, PlanarPointsAreEnough) {
  RandomPoints random(4);
  auto source = random.cloud(20);
  for (Vec3& p : source) p.z() = 0;
  const Sim3 truth{2, SE3(so3Exp(Vec3(1, 2, 0.5)), Vec3(1, 2, 3))};
  const auto result = alignPoints(source, moveAll(truth, source), Alignment::sim3);
  ASSERT_TRUE(result.ok());
  EXPECT_LT(squaredError(result.value(), source, moveAll(truth, source)), 1e-18);
}

TEST(Alignment, DegenerateCasesAreErrors) {
  RandomPoints random(5);
  const auto cloud = random.cloud(10);
  std::vector<Vec3> line, point(10, Vec3(0.1, 0.2, 0.3));
  for (int i = 0; i < 10; ++i) line.push_back(Vec3(0.1, 0.7, -0.3) * i + Vec3(5, 6, 7));
  for (const Alignment mode : {Alignment::se3, Alignment::sim3}) {
    EXPECT_FALSE(alignPoints(point, cloud, mode).ok());
    EXPECT_FALSE(alignPoints(cloud, point, mode).ok());
    EXPECT_FALSE(alignPoints({}, {}, mode).ok());
    EXPECT_FALSE(alignPoints({cloud[0], cloud[1]}, {cloud[0], cloud[1]}, mode).ok());
  }
  EXPECT_TRUE(alignPoints(line, line, Alignment::none).ok());
}

TEST(Alignment, OnALineTheTurnAboutItIsLeftOpen) {
  std::vector<Vec3> line, other;
  for (int i = 0; i < 10; ++i) {
    line.push_back(Vec3(0.1, 0.7, -0.3) * i + Vec3(5, 6, 7));
    other.push_back(Vec3(-0.2, 0.1, 0.4) * i + Vec3(1, 0, 2));
  }
  for (const Alignment mode : {Alignment::se3, Alignment::sim3}) {
    bool straight = false;
    const auto S = alignPoints(line, other, mode, &straight);
    ASSERT_TRUE(S.ok());
    EXPECT_TRUE(straight);
    for (int i = 0; i < 10 && mode == Alignment::sim3; ++i)
      EXPECT_LT((S.value() * line[static_cast<std::size_t>(i)] - other[static_cast<std::size_t>(i)])
                    .norm(),
                1e-9);
  }
  RandomPoints random(5);
  const auto cloud = random.cloud(10);
  bool straight = true;
  EXPECT_TRUE(alignPoints(cloud, cloud, Alignment::sim3, &straight).ok());
  EXPECT_FALSE(straight);
}

TEST(Alignment, NamesAreParsedBack) {
  EXPECT_EQ(parseAlignment("sim3").value(), Alignment::sim3);
  const auto wrong = parseAlignment("affine");
  ASSERT_FALSE(wrong.ok());
  EXPECT_EQ(wrong.error().exitCode(), 2);
}

}  // namespace
}  // namespace svoscope
