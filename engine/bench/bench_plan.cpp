// SPDX-License-Identifier: MIT
#include "engine/bench/bench_plan.h"

#include <fmt/format.h>

#include <cstdint>
#include <fstream>
#include <iterator>
#include <thread>

#include "engine/base/text_rows.h"
#include "engine/dataset/sequence.h"
#include "engine/eval/trajectory_file.h"
#include "engine/io/text_output.h"
#include "engine/io/trajectory_writer.h"
#include "engine/runner/parameters.h"

namespace svoscope {

namespace fs = std::filesystem;

namespace {

fs::path factsFolder(const fs::path& dir, const BenchSequence& sequence) {
  return dir / "sequences" / sequence.name;
}

}  // namespace

std::vector<BenchCell> cellsOf(const BenchConfig& config) {
  std::vector<BenchCell> cells;
  const std::vector<BenchSystem> systems = config.systems();
  const int runs = config.sync ? 1 : config.runs;
  for (int run = 1; run <= runs; ++run) {
    for (std::size_t s = 0; s < config.sequences.size(); ++s) {
      for (std::size_t m = 0; m < systems.size(); ++m) {
        cells.push_back({static_cast<int>(s), static_cast<int>(m), run,
                         fs::path("cells") / config.sequences[s].name / systems[m].folder /
                             fmt::format("run-{}", run)});
      }
    }
  }
  return cells;
}

std::string SequenceFacts::signature() const {
  if (!error.empty()) return "absent";
  return fmt::format("{} frames {:.6f} to {:.6f} s, {} x {}", times.size(),
                     times.empty() ? 0 : times.front(), times.empty() ? 0 : times.back(), width,
                     height);
}

SequenceFacts probeSequence(const BenchSequence& sequence) {
  SequenceFacts facts;
  const auto opened = openSequence(sequence.path);
  if (!opened.ok()) {
    facts.error = opened.error().message();
    return facts;
  }
  const Sequence& s = *opened.value();
  facts.width = s.camera().pinhole.width;
  facts.height = s.camera().pinhole.height;
  facts.ground_truth = s.groundTruth();
  const int end =
      sequence.max_frames > 0 ? std::min(s.size(), sequence.start + sequence.max_frames) : s.size();
  for (int i = sequence.start; i < end; ++i) facts.times.push_back(s.timestamp(i));
  return facts;
}

Status writeFacts(const fs::path& dir, const BenchSequence& sequence, const SequenceFacts& facts) {
  const fs::path folder = factsFolder(dir, sequence);
  Status status = makeFolder(folder);
  std::string times;
  for (const double t : facts.times) times += fmt::format("{:.6f}\n", t);
  if (status.ok() && !facts.ground_truth.empty())
    status = writeTumTrajectory(folder / "groundtruth.txt", facts.ground_truth);
  if (status.ok()) status = writeWhole(folder / "times.txt", times);
  return status;
}

SequenceFacts readFacts(const fs::path& dir, const BenchSequence& sequence) {
  SequenceFacts facts;
  const fs::path folder = factsFolder(dir, sequence);
  const auto rows = readTextRows(folder / "times.txt", "");
  if (!rows.ok()) {
    facts.error = "not opened yet";
    return facts;
  }
  for (const TextRow& row : rows.value())
    facts.times.push_back(parseNumber(row.fields[0]).value_or(0));
  const auto truth = loadTrajectory(folder / "groundtruth.txt");
  if (truth.ok()) facts.ground_truth = truth.value().poses;
  return facts;
}

std::vector<std::string> cellArguments(const BenchConfig& config, const BenchCell& cell,
                                       const std::string& path) {
  const BenchSequence& sequence = config.sequences[static_cast<std::size_t>(cell.sequence)];
  const BenchSystem system = config.systems()[static_cast<std::size_t>(cell.system)];
  std::vector<std::string> arguments = {"run", path, "--method", system.method};
  if (config.sync) arguments.push_back("--sync");
  if (sequence.start > 0)
    arguments.insert(arguments.end(), {"--start", std::to_string(sequence.start)});
  if (sequence.max_frames > 0)
    arguments.insert(arguments.end(), {"--max-frames", std::to_string(sequence.max_frames)});
  const auto add = [&](const Assignments& set) {
    for (const auto& [key, value] : set)
      arguments.insert(arguments.end(), {"--set", key + "=" + value});
  };
  add(config.parameters);
  add(config.variants[static_cast<std::size_t>(system.variant)].set);
  return arguments;
}

std::string cellFingerprint(const BenchConfig& config, const BenchCell& cell,
                            const SequenceFacts& facts) {
  const BenchSequence& sequence = config.sequences[static_cast<std::size_t>(cell.sequence)];
  const BenchSystem system = config.systems()[static_cast<std::size_t>(cell.system)];
  Parameters parameters;
  for (const auto& [key, value] : config.parameters)
    (void)setParameter(parameters, key, value).ok();
  for (const auto& [key, value] : config.variants[static_cast<std::size_t>(system.variant)].set)
    (void)setParameter(parameters, key, value).ok();
  // The text of a rendered sequence says what is in it, that of a folder only where it lies.
  const std::string scene = sequence.path.rfind("synthetic:", 0) == 0 ? sequence.path : "";
  return fingerprintOf(parametersYaml(parameters, system.method) +
                       (config.sync ? "sync" : "threaded") + scene +
                       std::to_string(sequence.start) + facts.signature());
}

std::string fingerprintOf(const std::string& bytes) {
  std::uint64_t hash = 14695981039346656037ull;
  for (const char c : bytes) {
    hash ^= static_cast<unsigned char>(c);
    hash *= 1099511628211ull;
  }
  return fmt::format("{:016x}", hash);
}

std::string fileFingerprint(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in) return "";
  return fingerprintOf(std::string(std::istreambuf_iterator<char>(in), {}));
}

std::string machineName() {
  std::ifstream in("/proc/cpuinfo");
  std::string line, model = "unknown processor";
  while (std::getline(in, line)) {
    const std::size_t colon = line.find(": ");
    if (line.rfind("model name", 0) != 0 || colon == std::string::npos) continue;
    model = line.substr(colon + 2);
    break;
  }
  return fmt::format("{}, {} threads", model, std::thread::hardware_concurrency());
}

}  // namespace svoscope
