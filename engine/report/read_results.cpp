// SPDX-License-Identifier: MIT
#include "engine/report/read_results.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

#include "engine/base/text_rows.h"
#include "engine/eval/trajectory_file.h"

namespace svoscope {

namespace fs = std::filesystem;

namespace {

using Json = nlohmann::json;

std::optional<double> numberAt(const Json& json, const char* pointer) {
  const Json::json_pointer at(pointer);
  if (!json.contains(at) || !json.at(at).is_number()) return std::nullopt;
  return json.at(at).get<double>();
}

void readMetrics(const fs::path& folder, RunFigures& f) {
  std::ifstream in(folder / "metrics.json");
  const Json json = Json::parse(in, nullptr, false);
  if (!json.is_object()) return;
  f.frames = numberAt(json, "/frames");
  f.tracked = numberAt(json, "/tracked_fraction_after_init");
  f.init_frame = numberAt(json, "/init_frame");
  f.init_time_s = numberAt(json, "/init_time_s");
  f.keyframes = numberAt(json, "/keyframes");
  f.losses = numberAt(json, "/losses");
  f.relocalisations = numberAt(json, "/relocalisations");
  f.relocalisation_time_s = numberAt(json, "/relocalisation_time_s");
  f.fps = numberAt(json, "/fps");
  f.tracking_ms = numberAt(json, "/time_ms/tracking/median");
  f.mapping_ms = numberAt(json, "/time_ms/mapping/median");
  f.points = numberAt(json, "/points");
  f.segments = numberAt(json, "/segments");
  f.memory_mb = numberAt(json, "/peak_rss_mb");
}

/// Times of the rows of frames.csv (index, timestamp, state, ...) in which tracking was lost.
std::vector<double> lostTimes(const fs::path& folder) {
  std::vector<double> times;
  std::ifstream in(folder / "frames.csv");
  std::string line;
  while (std::getline(in, line)) {
    const std::size_t first = line.find(','), second = line.find(',', first + 1),
                      third = line.find(',', second + 1);
    if (first == std::string::npos || second == std::string::npos || third == std::string::npos)
      continue;
    const auto time = parseNumber(line.substr(first + 1, second - first - 1));
    if (time && line.substr(second + 1, third - second - 1).find("lost") != std::string::npos)
      times.push_back(*time);
  }
  return times;
}

void evaluateInto(RunResult& run, const Trajectory& truth, const Trajectory& estimate,
                  const EvalOptions& options) {
  if (truth.empty()) return;  // then there are no errors, but all else
  if (estimate.empty()) {
    run.why = "no pose";
    return;
  }
  auto result = evaluate(truth, estimate, options);
  if (!result.ok()) {
    run.why = result.error().what;
    return;
  }
  RunFigures& f = run.figures;
  f.ate_m = result.value().ate.rmse;
  f.ate_median_m = result.value().ate.median;
  f.ate_max_m = result.value().ate.max;
  f.scale = result.value().scale;
  if (result.value().rpe) {
    f.rpe_trans_m = result.value().rpe->trans_rmse_m;
    f.rpe_rot_rad = result.value().rpe->rot_rmse_rad;
  }
  run.evaluation = std::move(result).value();
}

void judge(RunResult& run, double least_tracked) {
  if (!run.why.empty()) return;
  if (run.figures.tracked.value_or(0) < least_tracked) {
    run.why = fmt::format("only {:.0f} % tracked", 100 * run.figures.tracked.value_or(0));
    return;
  }
  run.good = true;
}

RunResult readRun(const fs::path& folder, int number, const SequenceFacts& facts,
                  const BenchConfig& config) {
  RunResult run;
  run.run = number;
  const auto record = readCellRecord(folder);
  if (!record) {
    run.why = "not run";
    return run;
  }
  run.present = true;
  run.record = *record;
  run.why = record->reason;
  readMetrics(folder, run.figures);
  if (run.why.empty() && !run.figures.tracked) run.why = "metrics.json is missing or damaged";
  run.lost = lostTimes(folder);
  const auto trajectory = loadTrajectory(folder / "trajectory.txt");
  if (trajectory.ok() && run.why.empty())
    evaluateInto(run, facts.ground_truth, trajectory.value().poses, config.evaluation);
  if (!trajectory.ok() && run.why.empty()) run.why = "no trajectory";
  judge(run, config.least_tracked);
  return run;
}

/// Frames of the sequence, from the first pose on, that have a pose.
std::optional<double> coverage(const std::vector<double>& times, const Trajectory& poses,
                               double max_dt) {
  int frames = 0, covered = 0;
  std::size_t j = 0;
  for (const double t : times) {
    if (t < poses.front().timestamp - max_dt) continue;
    ++frames;
    while (j + 1 < poses.size() &&
           std::abs(poses[j + 1].timestamp - t) <= std::abs(poses[j].timestamp - t))
      ++j;
    covered += std::abs(poses[j].timestamp - t) <= max_dt;
  }
  if (frames == 0) return std::nullopt;
  return static_cast<double>(covered) / frames;
}

/// The poses between the first and the last frame: a peer may have seen more of the sequence.
Trajectory within(const std::vector<double>& times, const Trajectory& poses, double max_dt) {
  if (times.empty()) return poses;
  Trajectory inside;
  for (const StampedPose& pose : poses) {
    if (pose.timestamp >= times.front() - max_dt && pose.timestamp <= times.back() + max_dt)
      inside.push_back(pose);
  }
  return inside;
}

RunResult readPeer(const fs::path& file, const SequenceFacts& facts, const BenchConfig& config) {
  RunResult run;
  std::error_code ec;
  if (!fs::exists(file, ec)) {
    run.why = "no file";
    return run;
  }
  run.present = true;
  const auto trajectory = loadTrajectory(file);
  if (!trajectory.ok()) {
    run.why = trajectory.error().what;
    return run;
  }
  const Trajectory poses = within(facts.times, trajectory.value().poses, config.evaluation.max_dt);
  if (poses.empty()) {
    run.why = "no pose within the sequence";
    return run;
  }
  // Frames are told apart by less than half a frame.
  const double half =
      facts.times.size() > 1 ? 0.5 * (facts.times[1] - facts.times[0]) : config.evaluation.max_dt;
  run.figures.tracked = coverage(facts.times, poses, std::min(half, config.evaluation.max_dt));
  if (!facts.times.empty())
    run.figures.init_time_s = std::max(0.0, poses.front().timestamp - facts.times.front());
  evaluateInto(run, facts.ground_truth, poses, config.evaluation);
  judge(run, config.least_tracked);
  return run;
}

}  // namespace

Result<BenchResults> readBenchResults(const fs::path& dir) {
  auto config = loadBenchConfig(dir / "bench.yaml", BenchConfigUse::report);
  if (!config.ok()) return config.error();
  BenchResults results;
  results.config = std::move(config).value();
  const BenchConfig& c = results.config;
  for (const BenchSystem& system : c.systems()) results.systems.push_back({system, false});
  results.own = static_cast<int>(results.systems.size());
  for (const BenchPeer& peer : c.peers)
    results.systems.push_back({{peer.label, peer.label, "", 0}, true});
  for (const BenchSequence& sequence : c.sequences) {
    results.facts.push_back(readFacts(dir, sequence));
    results.runs.emplace_back(results.systems.size());
    for (std::size_t p = 0; p < c.peers.size(); ++p)
      results.runs.back()[static_cast<std::size_t>(results.own) + p].push_back(readPeer(
          dir / "peers" / c.peers[p].label / (sequence.name + ".txt"), results.facts.back(), c));
  }
  std::set<std::string> machines, builds;
  for (const BenchCell& cell : cellsOf(c)) {
    const auto s = static_cast<std::size_t>(cell.sequence);
    RunResult run = readRun(dir / cell.folder, cell.run, results.facts[s], c);
    results.missing += !run.present;
    if (run.present) {
      machines.insert(run.record.machine);
      builds.insert(run.record.version + " " + run.record.build);
    }
    results.runs[s][static_cast<std::size_t>(cell.system)].push_back(std::move(run));
  }
  results.machines.assign(machines.begin(), machines.end());
  results.builds.assign(builds.begin(), builds.end());
  return results;
}

}  // namespace svoscope
