// SPDX-License-Identifier: MIT
#include "ui/panels/compare/compare_data.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "engine/eval/alignment.h"
#include "engine/eval/estimate.h"

namespace svoscope::ui {

namespace {

constexpr double kMaxDt = 0.02;  // s, as for the alignment
const Vec3f kNowhere = Vec3f::Constant(NAN);

std::size_t inlierColumn() {
  const auto& table = seriesTable();
  for (std::size_t i = 0; i < table.size(); ++i) {
    if (std::strcmp(table[i].label, "Inliers") == 0) return i;
  }
  return 0;
}

void takeRows(ComparedRun& out, const RunCache& rows) {
  const auto& records = rows.records();
  out.metrics = metricsOfRecords(records, static_cast<int>(records.size()));
  out.frames = rows.frames();
  if (out.style.poses_only) {
    out.inliers.assign(records.size(), NAN);
    out.time_ms = out.inliers;
    return;
  }
  out.inliers = rows.column(inlierColumn());
  out.time_ms = rows.stage(Stage::tracking);
  for (float& ms : out.time_ms) {
    if (ms <= 0) ms = NAN;  // an image that could not be read
  }
  bool lost = false;
  for (std::size_t i = 0; i < records.size(); ++i) {
    const bool now = records[i].state == TrackingState::lost;
    if (now && !lost) out.losses.push_back(static_cast<int>(i));
    lost = now;
  }
}

/// Moves the positions of a run by `move`.
template <typename Move>
void fillPath(ComparedRun& out, const RunCache& rows, const Move& move) {
  out.path.assign(rows.records().size(), kNowhere);
  const int map_id = mainMap(rows.records());
  for (std::size_t i = 0; i < out.path.size(); ++i) {
    const FrameRecord& r = rows.records()[i];
    if (hasPoseIn(r, map_id))
      out.path[i] = move(r.T_world_cam.translation()).template cast<float>();
  }
  out.aligned = true;
}

}  // namespace

int rowOf(const std::vector<float>& frames, int frame) {
  const auto at = std::lower_bound(frames.begin(), frames.end(), static_cast<float>(frame));
  return at != frames.end() && static_cast<int>(*at) == frame
             ? static_cast<int>(at - frames.begin())
             : -1;
}

void CompareData::update(const Runs& runs, const std::vector<CompareSource>& sources,
                         Alignment mode, bool settled) {
  Key key{runs.frame(), 0, runs.current(), mode};
  for (const CompareSource& s : sources) key.generations += s.rows->generation();
  const bool same = key.sameButFrame(key_) && runs_.size() == sources.size();
  const int added = key.frame - key_.frame;
  if (same && (added == 0 || (!settled && added > 0 && added < 10))) return;
  key_ = key;
  ++version_;
  runs_.assign(sources.size(), ComparedRun());
  const Trajectory& truth = runs.run(runs.current()).info().ground_truth;
  metric_ = !truth.empty();
  truth_path_.clear();
  for (std::size_t i = 0; i < sources.size(); ++i) {
    ComparedRun& run = runs_[i];
    run.style = runs.style(static_cast<int>(i));
    takeRows(run, *sources[i].rows);
    sources[i].truth->update(sources[i].rows->records(), truth, mode, sources[i].rows->generation(),
                             true);
    run.truth = sources[i].truth->state();
    run.error = run.truth.error;
    run.error.resize(run.frames.size(), NAN);
    run.path.assign(run.frames.size(), kNowhere);
    if (!metric_ || !run.truth.valid) continue;
    fillPath(run, *sources[i].rows, [&](const Vec3& p) {
      return Vec3(run.truth.scale * (run.truth.R * p) + run.truth.t);
    });
  }
  if (metric_)
    toTruth(sources, truth, key.current);
  else
    toCurrent(sources, key.current, mode);
  differences(key.current);
}

/// Turned so that down is where the current run, or the first that has a path, has it: ground truth
/// may have its axes anywhere.
void CompareData::toTruth(const std::vector<CompareSource>& sources, const Trajectory& truth,
                          int current) {
  const ComparedRun* reference = nullptr;
  double until = -1;
  for (std::size_t i = 0; i < runs_.size(); ++i) {
    ComparedRun& run = runs_[i];
    if (run.aligned && (!reference || static_cast<int>(i) == current)) reference = &run;
    if (!run.aligned && run.metrics.tracked > 0) {
      run.problem =
          run.truth.problem.empty() ? "needs three poses with ground truth" : run.truth.problem;
    }
    const auto& records = sources[i].rows->records();
    if (!records.empty()) until = std::max(until, records.back().timestamp);
  }
  if (!reference) return;
  const Mat3 R = reference->truth.R.transpose();
  const Vec3 t = reference->truth.t;
  const auto turn = [&](const Vec3& p) { return Vec3f((R * (p - t)).cast<float>()); };
  for (ComparedRun& run : runs_) {
    for (Vec3f& p : run.path) p = turn(p.cast<double>());
  }
  const std::size_t step = std::max<std::size_t>(1, truth.size() / 4000);
  for (std::size_t i = 0; i < truth.size() && truth[i].timestamp <= until + kMaxDt; i += step) {
    truth_path_.push_back(turn(truth[i].T_world_cam.translation()));
  }
}

/// Without ground truth: every run onto the current one, by the frames that both have.
void CompareData::toCurrent(const std::vector<CompareSource>& sources, int current,
                            Alignment mode) {
  const RunCache& onto = *sources[static_cast<std::size_t>(current)].rows;
  const int onto_map = mainMap(onto.records());
  fillPath(runs_[static_cast<std::size_t>(current)], onto, [](const Vec3& p) { return p; });
  for (std::size_t i = 0; i < runs_.size(); ++i) {
    if (static_cast<int>(i) == current) continue;
    std::vector<Vec3> from, to;
    const int own_map = mainMap(sources[i].rows->records());
    for (const FrameRecord& r : sources[i].rows->records()) {
      const FrameRecord* other = hasPoseIn(r, own_map) ? onto.find(r.index) : nullptr;
      if (!other || !hasPoseIn(*other, onto_map)) continue;
      from.push_back(r.T_world_cam.translation());
      to.push_back(other->T_world_cam.translation());
    }
    const auto T = alignPoints(from, to, mode);
    if (T.ok())
      fillPath(runs_[i], *sources[i].rows, [&](const Vec3& p) { return T.value() * p; });
    else if (runs_[i].metrics.tracked > 0)
      runs_[i].problem = T.error().what;
  }
}

void CompareData::differences(int current) {
  const ComparedRun& onto = runs_[static_cast<std::size_t>(current)];
  for (ComparedRun& run : runs_) {
    run.difference.assign(run.frames.size(), NAN);
    if (&run == &onto) continue;
    for (std::size_t i = 0; i < run.frames.size(); ++i) {
      const int row = rowOf(onto.frames, static_cast<int>(run.frames[i]));
      if (row >= 0)
        run.difference[i] = (run.path[i] - onto.path[static_cast<std::size_t>(row)]).norm();
    }
  }
}

}  // namespace svoscope::ui
