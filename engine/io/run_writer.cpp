// SPDX-License-Identifier: MIT
#include "engine/io/run_writer.h"

#include <sys/resource.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>
#include <utility>

#include "engine/base/quantile.h"
#include "engine/eval/estimate.h"
#include "engine/io/frames_csv.h"
#include "engine/io/map_ply.h"
#include "engine/io/metrics_writer.h"
#include "engine/io/trajectory_writer.h"

namespace svoscope {

namespace {

const std::vector<MapPointView>& pointsOf(const SnapshotPtr& snapshot) {
  static const std::vector<MapPointView> kNone;
  return snapshot && snapshot->points ? *snapshot->points : kNone;
}

double peakRssMb() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024.0;  // Linux counts in KiB
}

void countMap(const std::vector<MapPointView>& points, RunMetrics& metrics) {
  std::set<std::int64_t> segments;
  for (const MapPointView& point : points) {
    if (point.type == FeatureType::segment) {
      segments.insert(point.id);
    } else {
      ++metrics.points;
    }
  }
  metrics.segments = static_cast<int>(segments.size());
}

}  // namespace

Status RunWriter::begin(const std::filesystem::path& folder, const RunInfo& info,
                        const std::string& config_yaml) {
  *this = RunWriter();
  folder_ = folder;
  info_ = info;
  Status status = makeFolder(folder);
  if (!status.ok()) return status;
  // A run that is killed must not leave the results of the one before beside its own.
  for (const char* name : {"keyframes.txt", "map.ply", "metrics.json", "run.svoscope",
                           "run.svoscope-wal", "run.svoscope-shm"}) {
    std::error_code ec;
    std::filesystem::remove(folder / name, ec);
  }
  std::error_code ec;
  for (const auto& entry : std::filesystem::directory_iterator(folder, ec)) {
    if (entry.path().filename().string().rfind("trajectory-map", 0) == 0)
      std::filesystem::remove(entry.path(), ec);
  }
  status = beginTrajectory();
  if (status.ok()) status = frames_file_.open(folder / "frames.csv");
  if (status.ok()) status = frames_file_.write(framesCsvHeader());
  if (status.ok()) status = writeWhole(folder / "config.yaml", config_yaml);
  watch_ = Stopwatch();
  return status;
}

Status RunWriter::frame(const FrameRecord& record) {
  records_.push_back(record);
  if (record.pose_good) {
    Status status = record.map_id == map_id_ ? Status(Done{}) : beginMap(record.map_id);
    if (status.ok())
      status = trajectory_file_.write(tumLine({record.timestamp, record.T_world_cam}));
    if (!status.ok()) return status;
  }
  return frames_file_.write(framesCsvRow(record));
}

std::filesystem::path RunWriter::trajectoryOf(int map_id) const {
  return folder_ / ("trajectory-map" + std::to_string(map_id) + ".txt");
}

Status RunWriter::beginTrajectory() {
  const Status status = trajectory_file_.open(folder_ / "trajectory.txt");
  return status.ok() ? trajectory_file_.write(kTumHeader) : status;
}

/// Poses of two maps in one file would be taken for one trajectory.
Status RunWriter::beginMap(int map_id) {
  const int before = std::exchange(map_id_, map_id);
  if (before < 0) return Done{};
  const Status moved = renameFile(folder_ / "trajectory.txt", trajectoryOf(before));
  return moved.ok() ? beginTrajectory() : moved;
}

Status RunWriter::putMainMapFirst() {
  const int main_map = mainMap(records_);
  if (main_map < 0 || main_map == map_id_) return Done{};
  const Status moved = renameFile(folder_ / "trajectory.txt", trajectoryOf(map_id_));
  return moved.ok() ? renameFile(trajectoryOf(main_map), folder_ / "trajectory.txt") : moved;
}

void RunWriter::observe(const Snapshot& snapshot) {
  if (!snapshot.seeds) return;
  for (const SeedView& seed : *snapshot.seeds) {
    if (seed.status == SeedStatus::converged || seed.status == SeedStatus::promoted) {
      updates_of_converged_.emplace(seed.id, seed.updates);  // keeps the count at convergence
    }
  }
}

RunMetrics RunWriter::metrics(const SnapshotPtr& last, int frames,
                              const EvalOptions& evaluation) const {
  RunMetrics m = metricsOfRecords(records_, frames);
  m.method = info_.method;
  m.times = info_.times;
  const double wall_s = watch_.ms() * 1e-3;
  m.fps = wall_s > 0 ? m.frames / wall_s : 0;
  m.peak_rss_mb = peakRssMb();
  countMap(pointsOf(last), m);
  if (!updates_of_converged_.empty()) {
    std::vector<double> updates;
    for (const auto& [id, count] : updates_of_converged_) updates.push_back(count);
    m.seeds.updates_to_converge_median = interpolatedQuantile(std::move(updates), 0.5);
  }
  if (info_.ground_truth.empty()) {
    m.evaluation_note =
        info_.truth_note.empty() ? "the sequence has no ground truth" : info_.truth_note;
  } else if (m.maps == 0) {
    m.evaluation_note = "no pose was estimated";
  } else {
    auto result = evaluate(info_.ground_truth, estimateOf(records_), evaluation);
    if (result.ok()) {
      m.evaluation = std::move(result).value();
    } else {
      m.evaluation_note = result.error().message();
    }
  }
  return m;
}

Status RunWriter::writeKeyframes(const SnapshotPtr& last) const {
  Trajectory keyframes;
  if (last && last->keyframes) {
    for (const KeyframeView& keyframe : *last->keyframes) {
      const auto record = std::find_if(records_.begin(), records_.end(), [&](const FrameRecord& r) {
        return r.index == keyframe.frame_index;
      });
      if (record == records_.end()) continue;  // not read by us: no timestamp
      keyframes.push_back({record->timestamp, keyframe.T_world_cam});
    }
  }
  std::sort(keyframes.begin(), keyframes.end(),
            [](const StampedPose& a, const StampedPose& b) { return a.timestamp < b.timestamp; });
  return writeTumTrajectory(folder_ / "keyframes.txt", keyframes);
}

Result<RunMetrics> RunWriter::finish(SnapshotPtr last, int frames, const EvalOptions& evaluation) {
  if (last) observe(*last);
  const RunMetrics result = metrics(last, frames, evaluation);
  Status status = putMainMapFirst();
  if (status.ok()) status = writeKeyframes(last);
  if (status.ok()) {
    status = writeMapPly(folder_ / "map.ply", pointsOf(last), seedRule(info_.method));
  }
  if (status.ok()) {
    status = writeWhole(folder_ / "metrics.json", metricsJson(result).dump(2) + "\n");
  }
  if (!status.ok()) return status.error();
  return result;
}

}  // namespace svoscope
