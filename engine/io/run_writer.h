// SPDX-License-Identifier: MIT
// Writes the files of `svoscope run` while the run goes on (docs/commands.md).
#pragma once

#include <filesystem>
#include <string>
#include <unordered_map>
#include <vector>

#include "engine/base/result.h"
#include "engine/base/stopwatch.h"
#include "engine/eval/run_metrics.h"
#include "engine/io/text_output.h"
#include "engine/snapshot/snapshot.h"

namespace svoscope {

class RunWriter {
 public:
  /// Makes the folder, removes result files of an earlier run, opens the streamed files and writes
  /// config.yaml. Output error if any of this fails: call it before the engine starts.
  Status begin(const std::filesystem::path& folder, const RunInfo& info,
               const std::string& config_yaml);

  /// Appends a frame to frames.csv and, if its pose is good, to trajectory.txt; both are on disk
  /// when this returns. With the first pose of another map trajectory.txt begins anew, and what it
  /// held is moved to trajectory-mapN.txt.
  Status frame(const FrameRecord& record);

  /// Notes the seeds that converged in this snapshot; statistics only, snapshots may be left out.
  void observe(const Snapshot& snapshot);

  /// Writes keyframes.txt, map.ply and metrics.json from the last snapshot (null: empty map), and
  /// puts the poses of the map with most of them into trajectory.txt. `frames` is the number of
  /// frames that went through the engine.
  Result<RunMetrics> finish(SnapshotPtr last, int frames, const EvalOptions& evaluation = {});

  const std::filesystem::path& folder() const { return folder_; }
  const std::vector<FrameRecord>& records() const { return records_; }

 private:
  RunMetrics metrics(const SnapshotPtr& last, int frames, const EvalOptions& evaluation) const;
  Status writeKeyframes(const SnapshotPtr& last) const;
  std::filesystem::path trajectoryOf(int map_id) const;
  Status beginTrajectory();
  Status beginMap(int map_id);
  Status putMainMapFirst();

  std::filesystem::path folder_;
  RunInfo info_;
  Stopwatch watch_;
  LineFile trajectory_file_, frames_file_;
  std::vector<FrameRecord> records_;
  int map_id_ = -1;  ///< of the poses in trajectory.txt; -1: none yet
  std::unordered_map<std::int64_t, int> updates_of_converged_;  ///< by seed id
};

}  // namespace svoscope
