// SPDX-License-Identifier: MIT
// A runner without an engine: hands out the frames a test gives it, one per pump().
#pragma once

#include <algorithm>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "engine/runner/runner.h"

namespace svoscope::test {

class ScriptedRunner : public Runner {
 public:
  /// Rows to hand out; further fields may be changed by the test before the run.
  explicit ScriptedRunner(std::vector<FrameRecord> rows) : rows_(std::move(rows)) {
    info_.sequence = "fake";
    info_.method = "it-svo";
    info_.frames = static_cast<int>(rows_.size());
  }

  RunInfo info_;
  std::vector<Event> events_;
  SnapshotPtr last_;                          ///< what latest() gives once frames were handed out
  int stop_after = -1;                        ///< pauses by itself after so many frames
  int unreadable = 0;                         ///< frames at the end that have no row
  std::function<void(int done)> after_frame;  ///< called in pump()

  void send(const Command& command) override {
    if (command.kind == Command::Kind::play) playing_ = true;
    if (command.kind == Command::Kind::pause) playing_ = false;
  }
  bool pump() override {
    if (!playing_ || finished()) return false;
    ++done_;
    if (after_frame) after_frame(done_);
    if (done_ == stop_after || finished()) playing_ = false;
    return true;
  }
  const RunInfo& info() const override { return info_; }
  RunnerStatus status() const override {
    RunnerStatus status;
    status.playing = playing_;
    status.finished = finished();
    const int first = rows_.empty() ? 0 : rows_.front().index;
    status.next_frame = first + done_ + (finished() ? unreadable : 0);
    return status;
  }
  SnapshotPtr latest() const override { return done_ > 0 ? last_ : nullptr; }
  SnapshotPtr at(int frame_index) const override {
    return last_ && last_->record.index == frame_index ? last_ : nullptr;
  }
  std::vector<FrameRecord> records(int first) const override {
    return {rows_.begin() + std::min(first, done_), rows_.begin() + done_};
  }
  std::vector<Event> events(int first) const override {
    const auto size = static_cast<int>(events_.size());
    return {events_.begin() + std::min(first, size), events_.end()};
  }
  std::vector<ParameterView> parameters() const override { return {}; }
  int generation() const override { return 0; }

 private:
  bool finished() const { return done_ == static_cast<int>(rows_.size()); }

  std::vector<FrameRecord> rows_;
  int done_ = 0;
  bool playing_ = false;
};

/// `count` frames at 10 Hz on a curve in space. The first two are the start; frames 10 and 11 are
/// lost and frame 12 is found again, if there are that many.
inline std::vector<FrameRecord> fakeRecords(int count) {
  std::vector<FrameRecord> rows;
  for (int i = 0; i < count; ++i) {
    FrameRecord row;
    row.index = i;
    row.timestamp = 100 + 0.1 * i;
    const bool lost = i == 10 || i == 11;
    row.state = i < 2  ? TrackingState::initializing
                : lost ? TrackingState::lost
                       : TrackingState::tracking;
    row.pose_good = i >= 2 && !lost;
    row.relocalized = i == 12;
    row.is_keyframe = i % 5 == 2;
    row.reason = lost ? "3 inliers < 40 required" : "tracking, \"good\"";
    row.T_world_cam =
        SE3(so3Exp(Vec3(0, 0.01 * i, 0)), Vec3(0.1 * i, 0.01 * i * i, 0.001 * i * i * i));
    row.keyframes = 1 + i / 5;
    row.seeds_converged = 2;
    row.seeds_rejected = 1;
    row.time_ms[static_cast<int>(Stage::tracking)] = 10 + i;
    rows.push_back(row);
  }
  return rows;
}

/// A snapshot with a small map: three points, one segment, two keyframes, two converged seeds.
inline SnapshotPtr fakeSnapshot(const FrameRecord& record) {
  auto snapshot = std::make_shared<Snapshot>();
  snapshot->record = record;
  std::vector<MapPointView> points(4);
  for (int i = 0; i < 4; ++i) {
    points[i].id = i;
    points[i].position = Vec3f(1.5f * static_cast<float>(i), -1, 4);
    points[i].type = i < 3 ? FeatureType::corner : FeatureType::segment;
    points[i].observations = i;
  }
  points[3].position_end = Vec3f(6, -1, 4);
  snapshot->points = std::make_shared<const std::vector<MapPointView>>(points);
  std::vector<KeyframeView> keyframes = {{0, 2, SE3(), nullptr, true},
                                         {1, 7, SE3(), nullptr, true}};
  snapshot->keyframes = std::make_shared<const std::vector<KeyframeView>>(keyframes);
  std::vector<SeedView> seeds(3);
  for (int i = 0; i < 3; ++i) {
    seeds[i].id = i;
    seeds[i].updates = 10 + 2 * i;
    seeds[i].status = i < 2 ? SeedStatus::converged : SeedStatus::active;
  }
  snapshot->seeds = std::make_shared<const std::vector<SeedView>>(seeds);
  return snapshot;
}

}  // namespace svoscope::test
