// SPDX-License-Identifier: MIT
#include "engine/io/frames_csv.h"

#include <fmt/format.h>

#include <functional>
#include <vector>

namespace svoscope {

namespace {

std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"') result += '"';
    result += c == '\n' || c == '\r' ? ' ' : c;
  }
  return result + "\"";
}

std::string number(double value) { return fmt::format("{:.9g}", value); }
std::string number(int value) { return fmt::format("{}", value); }
std::string number(bool value) { return value ? "1" : "0"; }

struct Column {
  std::string name;
  std::function<std::string(const FrameRecord&)> text;
};

void addFunnel(std::vector<Column>& columns) {
  const auto add = [&](const char* name, int Funnel::*count) {
    columns.push_back({name, [count](const FrameRecord& r) { return number(r.funnel.*count); }});
  };
  add("aligned_sparse", &Funnel::aligned_sparse);
  add("candidates", &Funnel::candidates);
  add("projected", &Funnel::projected);
  add("tried", &Funnel::tried);
  add("matched", &Funnel::matched);
  add("inliers", &Funnel::inliers);
  add("inlier_landmarks", &Funnel::inlier_landmarks);
  add("inlier_seeds", &Funnel::inlier_seeds);
  add("inlier_edgelets", &Funnel::inlier_edgelets);
  add("inlier_segments", &Funnel::inlier_segments);
  add("followed_segments", &Funnel::followed_segments);
  add("required", &Funnel::required);
}

void addPose(std::vector<Column>& columns) {
  static constexpr const char* kNames[] = {"tx", "ty", "tz", "qx", "qy", "qz", "qw"};
  for (int i = 0; i < 7; ++i) {
    columns.push_back({kNames[i], [i](const FrameRecord& r) {
                         if (!r.pose_good) return std::string();
                         const SE3& T = r.T_world_cam;
                         return number(i < 3 ? T.translation()[i] : T.quaternion().coeffs()[i - 3]);
                       }});
  }
}

/// One list for header and rows, so that they cannot come apart.
std::vector<Column> makeColumns() {
  std::vector<Column> columns;
  const auto add = [&](const char* name, auto FrameRecord::*field) {
    columns.push_back({name, [field](const FrameRecord& r) { return number(r.*field); }});
  };
  const auto text = [&](const char* name, std::string FrameRecord::*field) {
    columns.push_back({name, [field](const FrameRecord& r) { return quoted(r.*field); }});
  };
  add("index", &FrameRecord::index);
  columns.push_back(
      {"timestamp", [](const FrameRecord& r) { return fmt::format("{:.6f}", r.timestamp); }});
  columns.push_back(
      {"state", [](const FrameRecord& r) { return std::string(stateName(r.state)); }});
  add("pose_good", &FrameRecord::pose_good);
  add("map", &FrameRecord::map_id);
  add("is_keyframe", &FrameRecord::is_keyframe);
  add("keyframe_id", &FrameRecord::keyframe_id);
  add("relocalized", &FrameRecord::relocalized);
  text("reason", &FrameRecord::reason);
  text("keyframe_reason", &FrameRecord::keyframe_reason);
  addPose(columns);
  addFunnel(columns);
  add("align_rmse", &FrameRecord::align_rmse);
  add("reprojection_px", &FrameRecord::reprojection_px);
  add("gain", &FrameRecord::gain);
  add("offset", &FrameRecord::offset);
  add("median_depth", &FrameRecord::median_depth);
  add("disparity_tracks", &FrameRecord::disparity_tracks);
  add("disparity_px", &FrameRecord::disparity_px);
  add("landmarks", &FrameRecord::landmarks);
  add("seeds", &FrameRecord::seeds);
  add("keyframes", &FrameRecord::keyframes);
  add("seeds_converged", &FrameRecord::seeds_converged);
  add("seeds_rejected", &FrameRecord::seeds_rejected);
  add("seed_updates", &FrameRecord::seed_updates);
  for (int i = 0; i < kStageCount; ++i) {
    const auto stage = static_cast<Stage>(i);
    columns.push_back({std::string("ms_") + stageName(stage), [stage](const FrameRecord& r) {
                         return fmt::format("{:.4f}", r.ms(stage));
                       }});
  }
  return columns;
}

const std::vector<Column>& columns() {
  static const std::vector<Column> kColumns = makeColumns();
  return kColumns;
}

}  // namespace

std::string framesCsvHeader() {
  std::string header;
  for (const Column& column : columns()) header += (header.empty() ? "" : ",") + column.name;
  return header;
}

std::string framesCsvRow(const FrameRecord& record) {
  std::string row;
  bool first = true;
  for (const Column& column : columns()) {
    if (!first) row += ',';
    first = false;
    row += column.text(record);
  }
  return row;
}

}  // namespace svoscope
