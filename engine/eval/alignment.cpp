// SPDX-License-Identifier: MIT
#include "engine/eval/alignment.h"

#include <fmt/format.h>

#include <Eigen/SVD>
#include <cmath>

namespace svoscope {

namespace {
// The covariance of a line has one singular value that is not rounding noise.
constexpr double kRankTolerance = 1e-12;

Error degenerate(const std::string& what) {
  return inputError(what, "alignment", "needs three or more matched positions that move");
}

Vec3 mean(const std::vector<Vec3>& points) {
  Vec3 sum = Vec3::Zero();
  for (const Vec3& p : points) sum += p;
  return sum / static_cast<double>(points.size());
}
}  // namespace

const char* alignmentName(Alignment alignment) {
  switch (alignment) {
    case Alignment::none:
      return "none";
    case Alignment::se3:
      return "se3";
    case Alignment::sim3:
      return "sim3";
  }
  return "unknown";
}

Result<Alignment> parseAlignment(const std::string& name) {
  for (const Alignment a : {Alignment::none, Alignment::se3, Alignment::sim3}) {
    if (name == alignmentName(a)) return a;
  }
  return usageError(fmt::format("'{}' is not an alignment", name), "--align",
                    "one of none, se3, sim3");
}

Result<Sim3> alignPoints(const std::vector<Vec3>& source, const std::vector<Vec3>& target,
                         Alignment alignment, bool* straight) {
  if (straight) *straight = false;
  if (alignment == Alignment::none) return Sim3();
  if (source.size() != target.size() || source.size() < 3) {
    return degenerate(fmt::format("only {} matched positions", source.size()));
  }
  const double n = static_cast<double>(source.size());
  const Vec3 mean_source = mean(source), mean_target = mean(target);
  double variance_source = 0, variance_target = 0;
  Mat3 covariance = Mat3::Zero();  // eq. 38
  for (std::size_t i = 0; i < source.size(); ++i) {
    const Vec3 ds = source[i] - mean_source, dt = target[i] - mean_target;
    variance_source += ds.squaredNorm() / n;
    variance_target += dt.squaredNorm() / n;
    covariance += dt * ds.transpose() / n;
  }
  const Eigen::JacobiSVD<Mat3> svd(covariance, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const Vec3 d = svd.singularValues();
  // Against the spread of both sets: if one of them stays in place everything is rounding noise.
  const double spread = std::sqrt(variance_source * variance_target);
  if (!(d[0] > kRankTolerance * spread) || !(d[0] > 0)) return degenerate("no common motion");
  if (straight) *straight = d[1] <= kRankTolerance * d[0];

  Vec3 sign(1, 1, 1);  // eq. 39: a rotation, not a reflection
  if (svd.matrixU().determinant() * svd.matrixV().determinant() < 0) sign[2] = -1;
  const Mat3 R = svd.matrixU() * sign.asDiagonal() * svd.matrixV().transpose();
  Sim3 result;
  if (alignment == Alignment::sim3) result.scale = d.dot(sign) / variance_source;  // eq. 42
  result.T = SE3(R, Vec3(mean_target - result.scale * (R * mean_source)));
  return result;
}

}  // namespace svoscope
