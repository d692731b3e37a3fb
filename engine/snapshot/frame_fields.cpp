// SPDX-License-Identifier: MIT
#include "engine/snapshot/frame_fields.h"

#include <limits>
#include <type_traits>

namespace svoscope {

namespace {

struct StageRow {
  const char *name, *column, *meaning;
};

constexpr StageRow kStages[kStageCount] = {
    {"read", "ms_read", "decode the image"},
    {"rectify", "ms_rectify", "remove lens distortion"},
    {"pyramid", "ms_pyramid", "image pyramid"},
    {"initialize", "ms_initialize", "two-view start; 0 once tracking"},
    {"sparse_align", "ms_sparse_align", "sparse image alignment"},
    {"reproject", "ms_reproject", "candidates, projection, feature alignment"},
    {"pose", "ms_pose", "pose refinement"},
    {"structure", "ms_structure", "landmark refinement"},
    {"keyframe", "ms_keyframe", "decision on a keyframe and bookkeeping"},
    {"relocalize", "ms_relocalize", "search for the pose after a loss"},
    {"tracking", "ms_tracking", "all steps of tracking: the above from `ms_pyramid` on"},
    {"mapping", "ms_mapping", "mapping job of this frame (a thread of its own unless `--sync`)"},
    {"snapshot", "ms_snapshot", "build and publish the snapshot"},
};

const StageRow& rowOf(Stage stage) { return kStages[static_cast<int>(stage)]; }

}  // namespace

const char* stageName(Stage stage) { return rowOf(stage).name; }
const char* stageColumn(Stage stage) { return rowOf(stage).column; }
const char* stageMeaning(Stage stage) { return rowOf(stage).meaning; }

std::vector<double> frameNumbers(const FrameRecord& record) {
  std::vector<double> numbers;
  visitFrameFields(record, [&](const FrameField& field, const auto& value) {
    double number = std::numeric_limits<double>::quiet_NaN();
    if constexpr (std::is_arithmetic_v<std::decay_t<decltype(value)>>) {
      if (field.applies) number = static_cast<double>(value);
    }
    numbers.push_back(number);
  });
  return numbers;
}

std::optional<std::size_t> frameFieldIndex(std::string_view name) {
  std::optional<std::size_t> found;
  std::size_t i = 0;
  const FrameRecord record;
  visitFrameFields(record, [&](const FrameField& field, const auto&) {
    if (field.name == name) found = i;
    ++i;
  });
  return found;
}

}  // namespace svoscope
