// SPDX-License-Identifier: MIT
#include "engine/study/stress.h"

#include <fmt/format.h>

#include "engine/dataset/synthetic/spec.h"
#include "engine/eval/estimate.h"
#include "engine/eval/evaluate.h"
#include "engine/runner/make_runner.h"
#include "engine/study/kept_sequence.h"

namespace svoscope {

namespace {

constexpr double kHeldTracked = 0.98, kHeldError = 0.005;
constexpr double kShakyTracked = 0.90, kShakyError = 0.02;

Command play() {
  Command command;
  command.kind = Command::Kind::play;
  return command;
}

double pathLength(const Trajectory& truth, double from_s) {
  double length = 0;
  for (std::size_t i = 1; i < truth.size(); ++i) {
    if (truth[i - 1].timestamp < from_s) continue;
    length += (truth[i].T_world_cam.translation() - truth[i - 1].T_world_cam.translation()).norm();
  }
  return length;
}

/// First and one past the last black frame.
struct Blackout {
  int first = -1, end = -1;
  bool covers(int index) const { return index >= first && index < end; }
};

Blackout blackoutOf(const std::string& sequence) {
  const auto spec = parseSyntheticSpec(sequence);
  if (!spec.ok() || spec.value().blackout_count == 0) return {};
  const int first = spec.value().blackout_first;
  return {first, first + spec.value().blackout_count};
}

void countFrames(const std::vector<FrameRecord>& records, const Blackout& black, StressRow& row) {
  const int map_id = mainMap(records);
  int since_start = 0, tracked = 0;
  bool lost = false;
  for (const FrameRecord& r : records) {
    if (r.state == TrackingState::lost && !lost) ++row.losses;
    lost = r.state == TrackingState::lost;
    if (r.pose_good && !row.start_s) {
      row.start_s = r.timestamp - records.front().timestamp;
      row.blackout = r.index < black.first;
    }
    if (black.covers(r.index)) continue;
    ++row.visible;
    if (!row.start_s) continue;
    ++since_start;
    tracked += hasPoseIn(r, map_id);
  }
  if (since_start > 0) row.tracked_fraction = tracked / static_cast<double>(since_start);
}

void timeRecovery(const std::vector<FrameRecord>& records, const Blackout& black, StressRow& row) {
  if (!row.blackout) return;
  std::optional<double> seen_again_s;
  for (const FrameRecord& r : records) {
    if (r.index < black.end) continue;
    if (!seen_again_s) seen_again_s = r.timestamp;
    if (!r.pose_good) continue;
    row.recovery_s = r.timestamp - *seen_again_s;
    return;
  }
}

void measureError(const std::vector<FrameRecord>& records, const Trajectory& truth,
                  StressRow& row) {
  const Trajectory estimate = estimateOf(records);
  if (estimate.empty()) return;
  const auto evaluated = evaluate(truth, estimate);
  const double length = pathLength(truth, estimate.front().timestamp);
  if (evaluated.ok() && length > 0) row.relative_ate = evaluated.value().ate.rmse / length;
}

StressOutcome judge(const StressRow& row) {
  if (!row.tracked_fraction || !row.relative_ate) return StressOutcome::broken;
  const double tracked = *row.tracked_fraction, error = *row.relative_ate;
  if (tracked >= kHeldTracked && error <= kHeldError) return StressOutcome::held;
  if (tracked >= kShakyTracked && error <= kShakyError) return StressOutcome::shaky;
  return StressOutcome::broken;
}

/// Completes a row that says already what was run.
StressRow rowOf(const std::vector<FrameRecord>& records, const Trajectory& truth, StressRow row) {
  const Blackout black = blackoutOf(row.sequence);
  countFrames(records, black, row);
  timeRecovery(records, black, row);
  measureError(records, truth, row);
  row.outcome = judge(row);
  return row;
}

bool stopped(const StressOptions& options) { return options.stop && *options.stop; }

/// Every frame of one sequence through one method; fewer if stopped.
Result<std::vector<FrameRecord>> recordsOf(const KeptSequence& sequence, const std::string& method,
                                           const StressOptions& options) {
  RunnerOptions run;
  run.method = method;
  run.threaded = false;
  run.publish_snapshots = false;
  run.parameters = options.parameters;
  auto runner = makeRunner(std::make_unique<KeptSequence>(sequence), run);
  if (!runner.ok()) return runner.error();
  runner.value()->send(play());
  while (!stopped(options) && runner.value()->pump()) {
  }
  return runner.value()->records(0);
}

}  // namespace

const char* stressOutcomeName(StressOutcome outcome) {
  switch (outcome) {
    case StressOutcome::held:
      return "held";
    case StressOutcome::shaky:
      return "shaky";
    case StressOutcome::broken:
      return "broken";
  }
  return "";
}

Result<std::vector<StressRow>> runStresses(const std::vector<Stress>& stresses,
                                           const StressOptions& options) {
  std::vector<StressRow> rows;
  for (const Stress& stress : stresses) {
    for (const StressLevel& level : stress.levels) {
      auto opened = openSequence(level.sequence);
      if (!opened.ok()) return opened.error();
      const KeptSequence sequence(std::move(opened).value());
      for (const std::string& method : options.methods) {
        if (options.progress)
          options.progress(fmt::format("{} {}: {}", stress.name, level.strength, method));
        const auto records = recordsOf(sequence, method, options);
        if (!records.ok()) return records.error();
        if (stopped(options)) return rows;
        StressRow row;
        row.stress = stress.name;
        row.strength = level.strength;
        row.sequence = level.sequence;
        row.method = method;
        rows.push_back(rowOf(records.value(), sequence.groundTruth(), std::move(row)));
        const Status status = options.finished ? options.finished(rows.back()) : Status(Done{});
        if (!status.ok()) return status.error();
      }
    }
  }
  return rows;
}

}  // namespace svoscope
