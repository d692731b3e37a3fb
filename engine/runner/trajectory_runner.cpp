// SPDX-License-Identifier: MIT
#include "engine/runner/trajectory_runner.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace svoscope {

namespace {

std::vector<FrameRecord> emptyRows(const FrameTimes& frames) {
  std::vector<FrameRecord> rows(frames.timestamps.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    rows[i].index = frames.first + static_cast<int>(i);
    rows[i].timestamp = frames.timestamps[i];
    rows[i].reason = "no pose in the file";
  }
  return rows;
}

void put(FrameRecord& row, const SE3& T_world_cam) {
  row.T_world_cam = T_world_cam;
  row.pose_good = true;
  row.state = TrackingState::tracking;
  row.reason = "pose from the file";
}

std::size_t nearest(const std::vector<double>& times, double t) {
  const auto after = std::lower_bound(times.begin(), times.end(), t);
  if (after == times.begin()) return 0;
  const auto i = static_cast<std::size_t>(after - times.begin());
  return i == times.size() || t - times[i - 1] <= times[i] - t ? i - 1 : i;
}

/// Each pose to its frame; of several poses the nearest stays. Number of rows filled.
int placeByTime(const Trajectory& poses, const FrameTimes& frames, std::vector<FrameRecord>& rows) {
  std::vector<double> distance(rows.size(), std::numeric_limits<double>::infinity());
  int filled = 0;
  for (const StampedPose& pose : poses) {
    const std::size_t i = nearest(frames.timestamps, pose.timestamp);
    const double dt = std::abs(frames.timestamps[i] - pose.timestamp);
    if (dt > kPoseFrameMaxDt || dt >= distance[i]) continue;
    filled += std::isinf(distance[i]);
    distance[i] = dt;
    put(rows[i], pose.T_world_cam);
  }
  return filled;
}

int placeByRow(const Trajectory& poses, const FrameTimes& frames, std::vector<FrameRecord>& rows) {
  int filled = 0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const std::size_t row = i + static_cast<std::size_t>(frames.first);
    if (row >= poses.size()) break;
    put(rows[i], poses[row].T_world_cam);
    ++filled;
  }
  return filled;
}

}  // namespace

Result<std::unique_ptr<Runner>> TrajectoryRunner::make(const TrajectoryFile& file,
                                                       const FrameTimes& frames, RunInfo info,
                                                       const std::string& where) {
  if (frames.timestamps.empty())
    return inputError("the sequence has no frames", where, "check the sequence");
  std::vector<FrameRecord> rows = emptyRows(frames);
  const bool by_row = file.format == TrajectoryFormat::kitti;
  const int filled =
      by_row ? placeByRow(file.poses, frames, rows) : placeByTime(file.poses, frames, rows);
  if (filled == 0) {
    return inputError("no pose belongs to a frame of the sequence", where,
                      by_row ? "it has fewer rows than frames lie before the first one"
                             : "timestamps must be those of the images within 20 ms");
  }
  return std::unique_ptr<Runner>(new TrajectoryRunner(std::move(rows), std::move(info)));
}

TrajectoryRunner::TrajectoryRunner(std::vector<FrameRecord> rows, RunInfo info)
    : rows_(std::move(rows)),
      info_(std::move(info)),
      log_(std::numeric_limits<std::size_t>::max()) {}

bool TrajectoryRunner::pump() {
  while (!commands_.empty()) {
    const Command command = commands_.front();
    commands_.pop_front();
    playback_.handle(command);
    if (command.kind == Command::Kind::reset) {
      log_.clear();
      next_ = 0;
    }
    if (command.kind == Command::Kind::step) break;
  }
  if (!playback_.wantsFrame()) return false;
  if (next_ == rows_.size()) {
    playback_.finish();
    return false;
  }
  auto snapshot = std::make_shared<Snapshot>();
  snapshot->sequence_number = ++published_;
  snapshot->record = rows_[next_++];
  snapshot->bytes = sizeof(Snapshot);
  const bool first_pose = snapshot->record.pose_good && (next_ < 2 || !rows_[next_ - 2].pose_good);
  playback_.processed(snapshot->record, first_pose);
  log_.addSnapshot(snapshot);
  log_.addRecord(snapshot->record);
  return true;
}

RunnerStatus TrajectoryRunner::status() const {
  RunnerStatus status;
  status.playing = playback_.playing();
  status.finished = next_ == rows_.size();
  status.next_frame = rows_.front().index + static_cast<int>(next_);
  log_.describe(status);
  status.history_budget = 0;  // poses only: not of the budget of snapshots
  return status;
}

}  // namespace svoscope
