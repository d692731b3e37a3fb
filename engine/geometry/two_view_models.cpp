// SPDX-License-Identifier: MIT
#include "engine/geometry/two_view_models.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/SVD>
#include <cmath>
#include <limits>

#include "engine/geometry/triangulation.h"
#include "engine/geometry/two_view_sampling.h"

namespace svoscope {

namespace {

constexpr double kFar = 1e6;  // error of a correspondence that a model cannot produce

/// Cauchy weight of an error relative to the noise.
double robustWeight(double error, double sigma) {
  const double r = error / (2.0 * sigma);
  return 1.0 / (1.0 + r * r);
}

/// Rotation nearest to sum w b a^T (Kabsch 1976).
Eigen::Quaterniond nearestRotation(const Mat3& B) {
  const Eigen::JacobiSVD<Mat3> svd(B, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const Vec3 d(1, 1, (svd.matrixU() * svd.matrixV().transpose()).determinant());
  return Eigen::Quaterniond(Mat3(svd.matrixU() * d.asDiagonal() * svd.matrixV().transpose()));
}

Eigen::Quaterniond weightedRotation(const TwoViewData& data, const std::vector<double>& weights) {
  Mat3 B = Mat3::Zero();
  for (int i = 0; i < data.size(); ++i) {
    if (weights[i] <= 0) continue;
    B += weights[i] * data.x_cur[i].homogeneous().normalized() *
         data.x_ref[i].homogeneous().normalized().transpose();
  }
  return nearestRotation(B);
}

/// Weighted direct linear transform (Hartley and Zisserman, 4.1) through the normal equations.
Mat3 weightedHomography(const TwoViewData& data, const std::vector<double>& weights) {
  Eigen::Matrix<double, 9, 9> M = Eigen::Matrix<double, 9, 9>::Zero();
  for (int i = 0; i < data.size(); ++i) {
    if (weights[i] <= 0) continue;
    const Vec3 a = data.x_ref[i].homogeneous();
    Eigen::Matrix<double, 2, 9> row = Eigen::Matrix<double, 2, 9>::Zero();
    row.block<1, 3>(0, 0) = a.transpose();
    row.block<1, 3>(0, 6) = -data.x_cur[i].x() * a.transpose();
    row.block<1, 3>(1, 3) = a.transpose();
    row.block<1, 3>(1, 6) = -data.x_cur[i].y() * a.transpose();
    M += weights[i] * row.transpose() * row;
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 9, 9>> eigen(M);
  const Eigen::Matrix<double, 9, 1> h = eigen.eigenvectors().col(0);
  Mat3 H;
  H << h[0], h[1], h[2], h[3], h[4], h[5], h[6], h[7], h[8];
  return H;
}

Mat3 normalizedHomography(const Mat3& H) {
  const double middle = Eigen::JacobiSVD<Mat3>(H).singularValues()[1];
  if (!(middle > 0)) return Mat3::Identity();
  return H * ((H.determinant() < 0 ? -1.0 : 1.0) / middle);
}

std::vector<double> indicator(int size, const std::vector<int>& sample) {
  std::vector<double> weights(size, 0.0);
  for (int i : sample) weights[i] = 1;
  return weights;
}

/// Iteratively reweighted fit, the step from a minimal model to all of the data.
template <typename Model, typename Fit, typename Errors>
Model reweighted(Model model, const TwoViewData& data, int rounds, Fit fit, Errors errors) {
  double best = truncatedCost(errors(model, data), data.inlier);
  Model kept = model;
  for (int k = 0; k < rounds; ++k) {
    const std::vector<double> e = errors(model, data);
    std::vector<double> weights(e.size());
    for (std::size_t i = 0; i < e.size(); ++i) weights[i] = robustWeight(e[i], data.sigma);
    model = fit(data, weights);
    const double cost = truncatedCost(errors(model, data), data.inlier);
    if (cost < best) {
      best = cost;
      kept = model;
    }
  }
  return kept;
}

}  // namespace

double truncatedCost(const std::vector<double>& errors, double limit) {
  double sum = 0;
  for (double e : errors) sum += std::min(1.0, e * e / (limit * limit));
  return sum;
}

std::vector<double> rotationErrors(const Eigen::Quaterniond& q_cur_ref, const TwoViewData& data) {
  std::vector<double> errors(data.size(), kFar);
  const Mat3 R = q_cur_ref.toRotationMatrix();
  for (int i = 0; i < data.size(); ++i) {
    const Vec3 p = R * data.x_ref[i].homogeneous();
    if (p.z() > 0) errors[i] = (p.hnormalized() - data.x_cur[i]).norm();
  }
  return errors;
}

Eigen::Quaterniond fitRotation(const TwoViewData& data) {
  const auto minimal = [&](const std::vector<int>& sample) {
    return std::vector<Eigen::Quaterniond>{weightedRotation(data, indicator(data.size(), sample))};
  };
  const auto polish = [&](const Eigen::Quaterniond& q, int rounds) {
    return reweighted(q, data, rounds, weightedRotation, rotationErrors);
  };
  const auto cost = [&](const Eigen::Quaterniond& q) {
    return truncatedCost(rotationErrors(q, data), data.inlier);
  };
  const std::vector<double> all(data.size(), 1.0);
  return randomSearch<Eigen::Quaterniond>(data, 2, {weightedRotation(data, all)}, minimal, polish,
                                          cost);
}

std::vector<double> homographyErrors(const Mat3& H_cur_ref, const TwoViewData& data) {
  std::vector<double> errors(data.size(), kFar);
  const Mat3 back = H_cur_ref.inverse();
  for (int i = 0; i < data.size(); ++i) {
    const Vec3 p = H_cur_ref * data.x_ref[i].homogeneous();
    const Vec3 r = back * data.x_cur[i].homogeneous();
    if (p.z() <= 0 || r.z() <= 0) continue;
    // Mean of both directions, so that it is comparable with a one-image distance.
    errors[i] = std::sqrt(0.5 * ((p.hnormalized() - data.x_cur[i]).squaredNorm() +
                                 (r.hnormalized() - data.x_ref[i]).squaredNorm()));
  }
  return errors;
}

Mat3 fitHomography(const TwoViewData& data) {
  const auto fit = [](const TwoViewData& d, const std::vector<double>& weights) {
    return normalizedHomography(weightedHomography(d, weights));
  };
  const auto minimal = [&](const std::vector<int>& sample) {
    return std::vector<Mat3>{fit(data, indicator(data.size(), sample))};
  };
  const auto polish = [&](const Mat3& H, int rounds) {
    return reweighted(H, data, rounds, fit, homographyErrors);
  };
  const auto cost = [&](const Mat3& H) {
    return truncatedCost(homographyErrors(H, data), data.inlier);
  };
  const std::vector<double> all(data.size(), 1.0);
  return randomSearch<Mat3>(data, 4, {fit(data, all)}, minimal, polish, cost);
}

}  // namespace svoscope
