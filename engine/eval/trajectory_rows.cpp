// SPDX-License-Identifier: MIT
#include "engine/eval/trajectory_rows.h"

#include <fmt/format.h>

#include <cmath>

namespace svoscope {

namespace {

// Published files carry as few as four decimals, so unit length is met only roughly.
constexpr double kRotationTolerance = 0.1;

void setQuaternion(const Eigen::Quaterniond& q, const Vec3& t, RowPose& row) {
  const double norm = q.norm();
  row.oriented = std::isfinite(norm) && std::abs(norm - 1.0) <= kRotationTolerance;
  if (row.oriented) {
    row.pose = SE3(q, t);
    return;
  }
  row.pose = SE3(Eigen::Quaterniond::Identity(), t);
  row.problem = !std::isfinite(norm) ? "the quaternion is not a finite number"
                : norm < 1e-9        ? "the quaternion is zero"
                                     : fmt::format("the quaternion has length {:.4g}, not 1", norm);
}

void setMatrix(const std::vector<double>& n, RowPose& row) {
  Mat3 R;
  R << n[0], n[1], n[2], n[4], n[5], n[6], n[8], n[9], n[10];
  const double deviation = (R * R.transpose() - Mat3::Identity()).norm();
  row.oriented = deviation <= kRotationTolerance && R.determinant() > 0;
  if (row.oriented) {
    row.pose = SE3(R, Vec3(n[3], n[7], n[11]));
  } else {
    row.problem = "the 3x3 part is not a rotation";
  }
}

}  // namespace

const char* const kTrajectoryLayouts =
    "rows are 'timestamp tx ty tz [qx qy qz qw]' (TUM), EuRoC CSV or 12 numbers (KITTI), sorted by "
    "time";

std::optional<RowForm> recogniseForm(const TextRow& row, bool commas) {
  RowForm form;
  form.columns = row.fields.size();
  const auto ends = [&](std::size_t i, const char* digit) {
    return row.fields[form.columns - i].rfind(digit, 0) == 0;
  };
  const bool whole_matrix =
      form.columns == 16 && ends(4, "0") && ends(3, "0") && ends(2, "0") && ends(1, "1");
  if (!commas && (form.columns == 12 || whole_matrix)) {
    form.format = TrajectoryFormat::kitti;
    return form;
  }
  const bool whole_stamp = parseNanoseconds(row.fields[0]).has_value();
  form.orientation = form.columns >= 8;
  if (form.columns != 4 && form.columns < 8) return std::nullopt;
  const bool euroc = commas && (whole_stamp || form.columns > 8);
  form.format = euroc ? TrajectoryFormat::euroc : TrajectoryFormat::tum;
  return form;
}

Result<RowPose> poseOfRow(const TextRow& row, const RowForm& form, const std::string& where) {
  const bool kitti = form.format == TrajectoryFormat::kitti;
  const std::size_t first = kitti ? 0 : 1, count = kitti ? 12 : form.orientation ? 7 : 3;
  if (form.format != TrajectoryFormat::euroc ? row.fields.size() != form.columns
                                             : row.fields.size() < first + count) {
    return inputError(fmt::format("{} fields instead of {}", row.fields.size(), form.columns),
                      where, kTrajectoryLayouts);
  }
  std::vector<double> n;
  RowPose result;
  for (std::size_t i = first; i < first + count; ++i) {
    const auto value = parseNumber(row.fields[i]);
    if (!value) {
      return inputError("'" + row.fields[i] + "' is not a finite number", where,
                        kTrajectoryLayouts);
    }
    const bool of_position = kitti || i < first + 3;
    if (!std::isfinite(*value) && of_position && result.finite) {
      result.finite = false;
      result.problem = "'" + row.fields[i] + "' is not a finite number";
    }
    n.push_back(*value);
  }
  if (!result.finite) return result;
  if (kitti) {
    setMatrix(n, result);
    return result;
  }
  const Vec3 t(n[0], n[1], n[2]);
  if (!form.orientation) {
    result.pose = SE3(Eigen::Quaterniond::Identity(), t);
    return result;
  }
  const bool w_first =
      form.format == TrajectoryFormat::euroc || form.quaternion == QuaternionOrder::wxyz;
  setQuaternion(w_first ? Eigen::Quaterniond(n[3], n[4], n[5], n[6])
                        : Eigen::Quaterniond(n[6], n[3], n[4], n[5]),
                t, result);
  return result;
}

}  // namespace svoscope
