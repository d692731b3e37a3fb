// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <fstream>
#include <iterator>

#include "engine/bench/bench_runner.h"
#include "engine/bench/cell_queue.h"
#include "engine/bench/cell_record.h"
#include "engine/io/text_output.h"

namespace svoscope {

namespace fs = std::filesystem;

namespace {

/// Which cells there are and with what parameters; not where the data lie.
std::string planOf(const BenchConfig& config) {
  std::string text;
  for (const BenchSequence& s : config.sequences)
    text += fmt::format("{} {} {}\n", s.name, s.start, s.max_frames);
  for (const BenchSystem& s : config.systems()) {
    text += s.folder;
    for (const auto& [key, value] : config.variants[static_cast<std::size_t>(s.variant)].set)
      text += fmt::format(" {}={}", key, value);
    text += "\n";
  }
  for (const auto& [key, value] : config.parameters) text += fmt::format("{}={}\n", key, value);
  return text + fmt::format("{} {}\n", config.runs, config.sync);
}

/// Copies a folder to a place that has none, whole or not at all.
Status copyWhole(const fs::path& from, const fs::path& to) {
  std::error_code ec;
  if (!fs::is_directory(from, ec) || fs::exists(to, ec)) return Done{};
  const Status made = makeFolder(to.parent_path());
  if (!made.ok()) return made;
  const fs::path temporary = temporaryBeside(to);
  fs::copy(from, temporary, fs::copy_options::recursive, ec);
  if (ec)
    return outputError("cannot be copied: " + ec.message(), to.string(),
                       "choose a folder with free space");
  return moveIntoPlace(temporary, to);
}

Status copyBench(const BenchConfig& config, const fs::path& from, const fs::path& out) {
  for (const BenchCell& cell : cellsOf(config)) {
    const auto theirs = readCellRecord(from / cell.folder);
    if (!theirs) continue;
    // A cell that was ended from outside gives way to one that was not.
    const auto ours = readCellRecord(out / cell.folder);
    std::error_code ec;
    if (ours && !ours->finished() && theirs->finished()) fs::remove_all(out / cell.folder, ec);
    const Status copied = copyWhole(from / cell.folder, out / cell.folder);
    if (!copied.ok()) return copied;
  }
  for (const BenchSequence& s : config.sequences) {
    const Status copied = copyWhole(from / "sequences" / s.name, out / "sequences" / s.name);
    if (!copied.ok()) return copied;
  }
  for (const BenchPeer& peer : config.peers) {
    const Status copied = copyWhole(from / "peers" / peer.label, out / "peers" / peer.label);
    if (!copied.ok()) return copied;
  }
  return Done{};
}

}  // namespace

Status mergeBench(const std::vector<fs::path>& dirs, const fs::path& out) {
  std::vector<BenchConfig> configs;
  for (const fs::path& dir : dirs) {
    auto config = loadBenchConfig(dir / "bench.yaml", BenchConfigUse::report);
    if (!config.ok()) return config.error();
    configs.push_back(std::move(config).value());
    if (planOf(configs.back()) != planOf(configs.front()))
      return inputError("is a benchmark of another configuration than " + dirs.front().string(),
                        dir.string(), "merge shards of one configuration");
  }
  std::error_code ec;
  if (fs::exists(out / "bench.yaml", ec)) {
    const auto there = loadBenchConfig(out / "bench.yaml", BenchConfigUse::report);
    if (!there.ok()) return there.error();
    if (planOf(there.value()) != planOf(configs.front()))
      return inputError("holds a benchmark of another configuration", out.string(),
                        "choose an empty folder");
  }
  Status status = makeFolder(out);
  for (std::size_t i = 0; i < dirs.size() && status.ok(); ++i) {
    if (!fs::equivalent(dirs[i], out, ec)) status = copyBench(configs[i], dirs[i], out);
  }
  if (status.ok()) status = writeWhole(out / "bench.yaml", configs.front().text);
  return status;
}

}  // namespace svoscope
