// SPDX-License-Identifier: MIT
// A benchmark's folder written by hand: results with known errors.
#pragma once

#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include "engine/bench/bench_plan.h"
#include "engine/bench/cell_record.h"
#include "engine/io/trajectory_writer.h"
#include "tests/support/support.h"

namespace svoscope::test {

inline Trajectory madePath(int count = 60) {
  Trajectory poses;
  for (int i = 0; i < count; ++i) {
    const double t = 0.1 * i;
    poses.push_back({t, SE3(so3Exp(Vec3(0, 0.1 * t, 0)), Vec3(std::cos(t), std::sin(t), 0.3 * t))});
  }
  return poses;
}

/// The path with an error of `size` metres that alignment cannot take away.
inline Trajectory disturbedPath(double size, int count = 60) {
  Trajectory poses = madePath(count);
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const Vec3 t = poses[i].T_world_cam.translation() + Vec3(0, 0, i % 2 ? size : -size);
    poses[i].T_world_cam = SE3(poses[i].T_world_cam.quaternion(), t);
  }
  return poses;
}

/// Writes bench.yaml and the facts of all sequences.
inline BenchConfig makeBench(const std::filesystem::path& dir, const std::string& yaml) {
  std::filesystem::create_directories(dir);
  writeText(dir / "bench.yaml", yaml);
  const BenchConfig config = loadBenchConfig(dir / "bench.yaml", BenchConfigUse::report).value();
  SequenceFacts facts;
  facts.ground_truth = madePath();
  for (const StampedPose& pose : facts.ground_truth) facts.times.push_back(pose.timestamp);
  for (const BenchSequence& sequence : config.sequences)
    (void)writeFacts(dir, sequence, facts).ok();
  return config;
}

/// A finished cell with an ATE of about `size` metres.
inline void makeCell(const std::filesystem::path& dir, const BenchCell& cell, double size,
                     double tracked = 1) {
  const std::filesystem::path folder = dir / cell.folder;
  std::filesystem::create_directories(folder);
  (void)writeTumTrajectory(folder / "trajectory.txt", disturbedPath(size)).ok();
  writeText(folder / "metrics.json",
            "{\"frames\": 60, \"tracked_fraction_after_init\": " + std::to_string(tracked) +
                ", \"init_time_s\": 0.5, \"keyframes\": 7, \"losses\": 1, \"fps\": 50, "
                "\"relocalisation_time_s\": 0.25, \"time_ms\": {\"tracking\": {\"median\": 2}}}");
  writeText(folder / "frames.csv",
            "index,timestamp,state,pose_good\n3,0.300000,\"tracking\",1\n4,0.400000,\"lost\",0\n");
  CellRecord record;
  record.version = "1";
  record.machine = "here";
  (void)writeCellRecord(folder, record).ok();
}

/// A finished cell without a result.
inline void makeFailedCell(const std::filesystem::path& dir, const BenchCell& cell, int code,
                           const std::string& reason) {
  std::filesystem::create_directories(dir / cell.folder);
  CellRecord record;
  record.exit_code = code;
  record.reason = reason;
  (void)writeCellRecord(dir / cell.folder, record).ok();
}

}  // namespace svoscope::test
