// SPDX-License-Identifier: MIT
// Rows of trajectory files: which format they are, and the pose of each.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/base/text_rows.h"
#include "engine/eval/trajectory_file.h"

namespace svoscope {

/// What every row of the file has.
struct RowForm {
  TrajectoryFormat format = TrajectoryFormat::tum;
  std::size_t columns = 8;  ///< of the first row
  bool orientation = true;  ///< rows have a quaternion or matrix
  QuaternionOrder quaternion = QuaternionOrder::xyzw;
};

/// The form by the first row; empty if it is none that is known.
std::optional<RowForm> recogniseForm(const TextRow& row, bool commas);

struct RowPose {
  SE3 pose;
  bool finite = true;    ///< the position is
  bool oriented = true;  ///< the orientation is a rotation
  std::string problem;   ///< why not, for a message
};

/// The pose of a row; input error naming the line where a field is no number, or one is missing.
Result<RowPose> poseOfRow(const TextRow& row, const RowForm& form, const std::string& where);

extern const char* const kTrajectoryLayouts;  ///< remedy of errors

}  // namespace svoscope
