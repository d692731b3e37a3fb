// SPDX-License-Identifier: MIT
#include "engine/bench/bench_runner.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <set>
#include <thread>

#include "engine/base/stopwatch.h"
#include "engine/bench/cell_queue.h"
#include "engine/bench/cell_record.h"
#include "engine/bench/cell_text.h"
#include "engine/io/text_output.h"

namespace svoscope {

namespace fs = std::filesystem;

namespace {

bool isSynthetic(const BenchSequence& sequence) {
  return sequence.path.rfind("synthetic:", 0) == 0;
}

std::string readFile(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return std::string(std::istreambuf_iterator<char>(in), {});
}

std::string duration(double s) {
  if (s < 10) return fmt::format("{:.1f} s", s);
  if (s < 90) return fmt::format("{:.0f} s", s);
  if (s < 5400) return fmt::format("{:.0f} min", s / 60);
  return fmt::format("{:.1f} h", s / 3600);
}

class Bench {
 public:
  Bench(const BenchConfig& config, const BenchOptions& options)
      : config_(config), options_(options) {}

  Result<BenchOutcome> run() {
    build_ = fileFingerprint(options_.program);
    Status status = prepare();
    if (!status.ok()) return status.error();
    choose();
    auto finished = render();
    if (finished.ok() && finished.value()) finished = runCells();
    if (!finished.ok()) return finished.error();
    outcome_.interrupted = !finished.value();
    return outcome_;
  }

 private:
  const BenchSequence& sequenceOf(const BenchCell& cell) const {
    return config_.sequences[static_cast<std::size_t>(cell.sequence)];
  }
  const SequenceFacts& factsOf(const BenchCell& cell) const {
    return facts_[static_cast<std::size_t>(cell.sequence)];
  }
  void say(const std::string& line) const {
    if (options_.say) options_.say(line);
  }

  Status prepare() {
    Status status = makeFolder(options_.out);
    std::string first_error;
    int opened = 0;
    for (const BenchSequence& sequence : config_.sequences) {
      facts_.push_back(probeSequence(sequence));
      const SequenceFacts& facts = facts_.back();
      opened += facts.error.empty();
      if (!facts.error.empty()) {
        if (first_error.empty()) first_error = facts.error;
        if (options_.warn) options_.warn(sequence.name + ": " + facts.error);
      } else if (status.ok()) {
        status = writeFacts(options_.out, sequence, facts);
      }
    }
    if (!status.ok()) return status;
    if (opened == 0)
      return inputError("no sequence can be opened", first_error,
                        "correct 'sequences' of the configuration");
    removeAbandoned(options_.out);
    status = writeWhole(options_.out / "bench.yaml", config_.text);
    return status.ok() ? copyPeers() : status;
  }

  /// The report works from DIR alone.
  Status copyPeers() {
    for (const BenchPeer& peer : config_.peers) {
      int found = 0;
      for (const BenchSequence& sequence : config_.sequences) {
        std::string file = peer.files;
        const std::string mark = "{sequence}";
        for (std::size_t at; (at = file.find(mark)) != std::string::npos;)
          file.replace(at, mark.size(), sequence.name);
        std::error_code ec;
        if (!fs::is_regular_file(file, ec)) continue;
        ++found;
        const Status made = makeFolder(options_.out / "peers" / peer.label);
        if (!made.ok()) return made;
        const Status written = writeWhole(
            options_.out / "peers" / peer.label / (sequence.name + ".txt"), readFile(file));
        if (!written.ok()) return written;
      }
      if (found == 0 && options_.warn)
        options_.warn(fmt::format("peer {}: no sequence has a file {}", peer.label, peer.files));
    }
    return Done{};
  }

  bool counts(const BenchCell& cell) const {
    const auto record = readCellRecord(options_.out / cell.folder);
    if (!record || !record->finished()) return false;
    if (record->configuration != cellFingerprint(config_, cell, factsOf(cell))) return false;
    if (!options_.any_build && record->build != build_) return false;
    return !(options_.retry_failed && !record->reason.empty());
  }

  /// The cells of this shard that are still to be run.
  void choose() {
    const std::vector<BenchCell> all = cellsOf(config_);
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (static_cast<int>(i % static_cast<std::size_t>(options_.shards)) != options_.shard - 1)
        continue;
      ++outcome_.cells;
      if (counts(all[i])) {
        ++outcome_.kept;
      } else {
        // Until it is run again, what lies there must not stand in a report as its result.
        std::error_code ec;
        const fs::path record = options_.out / all[i].folder / "cell.json";
        if (fs::exists(record, ec))
          fs::rename(record, options_.out / all[i].folder / "cell.outdated.json", ec);
        pending_.push_back(all[i]);
        frames_left_ += static_cast<double>(factsOf(all[i]).times.size());
      }
    }
    say(fmt::format("{} cells, {} finished before, {} to run", outcome_.cells, outcome_.kept,
                    pending_.size()));
  }

  fs::path renderedFolder(const BenchSequence& sequence) const {
    return options_.out / "synth" / sequence.name;
  }
  std::string renderedMark(const BenchSequence& sequence) const {
    return sequence.path + "\n" + (options_.any_build ? "" : build_) + "\n";
  }

  /// Rendered once, read often: the time of a run is then that of the odometry.
  Result<bool> render() {
    std::vector<QueuedRun> runs;
    std::vector<const BenchSequence*> sequences;
    std::set<std::string> seen;
    for (const BenchCell& cell : pending_) {
      const BenchSequence& sequence = sequenceOf(cell);
      const fs::path folder = renderedFolder(sequence);
      if (!isSynthetic(sequence) || !seen.insert(sequence.name).second) continue;
      const std::string mark = readFile(folder / "spec.txt");
      if (mark == renderedMark(sequence) ||
          (options_.any_build && mark.rfind(sequence.path + "\n", 0) == 0))
        continue;
      const Status made = makeFolder(folder.parent_path());
      if (!made.ok()) return made.error();
      runs.push_back(
          {{options_.program.string(), "synth", sequence.path}, folder, temporaryBeside(folder)});
      sequences.push_back(&sequence);
    }
    // No times are taken here: all processors.
    const int jobs = std::max(options_.jobs, static_cast<int>(std::thread::hardware_concurrency()));
    return runQueue(
        runs, {jobs, 0, options_.stop}, [&](std::size_t i, const RunEnd& end) -> Status {
          if (end.end.exit_code != 0)
            return outputError("cannot be rendered: " + lastError(runs[i].temporary / "log.txt"),
                               sequences[i]->path, "is the disk full?");
          const Status marked =
              writeWhole(runs[i].temporary / "spec.txt", renderedMark(*sequences[i]));
          if (!marked.ok()) return marked;
          // Another shard may have been faster, and may be reading already.
          if (readFile(runs[i].folder / "spec.txt") == renderedMark(*sequences[i])) return Done{};
          say(fmt::format("rendered {} ({})", sequences[i]->name, duration(end.wall_s)));
          return moveIntoPlace(runs[i].temporary, runs[i].folder);
        });
  }

  Result<bool> runCells() {
    std::vector<QueuedRun> runs;
    for (const BenchCell& cell : pending_) {
      const BenchSequence& sequence = sequenceOf(cell);
      const std::string path =
          isSynthetic(sequence) ? renderedFolder(sequence).string() : sequence.path;
      std::vector<std::string> argv = cellArguments(config_, cell, path);
      argv.insert(argv.begin(), options_.program.string());
      const fs::path folder = options_.out / cell.folder;
      runs.push_back({std::move(argv), folder, temporaryBeside(folder)});
    }
    watch_ = Stopwatch();
    return runQueue(
        runs, {options_.jobs, config_.timeout_s, options_.stop},
        [&](std::size_t i, const RunEnd& end) { return finishCell(pending_[i], runs[i], end); });
  }

  Status finishCell(const BenchCell& cell, const QueuedRun& run, const RunEnd& end) {
    CellRecord record;
    record.configuration = cellFingerprint(config_, cell, factsOf(cell));
    record.build = build_;
    record.version = options_.version;
    record.machine = machineName();
    record.exit_code = end.end.exit_code;
    record.timed_out = end.timed_out;
    // An interrupt that was not ours came from outside, as a signal does. A timeout is our own.
    record.signal = end.timed_out ? 0 : end.end.exit_code == 130 ? 2 : end.end.signal;
    record.wall_s = end.wall_s;
    const bool absent = !factsOf(cell).error.empty() && record.exit_code == 3;
    record.reason = absent ? "the sequence cannot be opened"
                           : reasonOf(record, run.temporary, config_.timeout_s);
    Status status = writeCellRecord(run.temporary, record);
    if (status.ok()) status = moveIntoPlace(run.temporary, run.folder);
    ++outcome_.ran;
    outcome_.failed += !record.reason.empty();
    report(cell, record);
    return status;
  }

  void report(const BenchCell& cell, const CellRecord& record) {
    const auto frames = static_cast<double>(factsOf(cell).times.size());
    frames_left_ -= frames;
    frames_done_ += frames;
    const double left_s = frames_done_ > 0 ? watch_.ms() * 1e-3 / frames_done_ * frames_left_ : 0;
    say(fmt::format("[{}/{}] {} {} run {}: {}, {}{}", outcome_.kept + outcome_.ran, outcome_.cells,
                    sequenceOf(cell).name,
                    config_.systems()[static_cast<std::size_t>(cell.system)].label, cell.run,
                    record.reason.empty() ? headline(options_.out / cell.folder) : record.reason,
                    duration(record.wall_s),
                    frames_left_ > 0 ? "; about " + duration(left_s) + " left" : std::string()));
  }

  const BenchConfig& config_;
  const BenchOptions& options_;
  BenchOutcome outcome_;
  std::string build_;
  std::vector<SequenceFacts> facts_;
  std::vector<BenchCell> pending_;
  double frames_left_ = 0, frames_done_ = 0;
  Stopwatch watch_;
};

}  // namespace

Result<BenchOutcome> runBench(const BenchConfig& config, const BenchOptions& options) {
  return Bench(config, options).run();
}

Status moveIntoPlace(const fs::path& from, const fs::path& to) {
  std::error_code ec;
  const fs::path old = to.parent_path() / ("." + to.filename().string() + ".old");
  if (fs::exists(to, ec)) {
    fs::remove_all(old, ec);
    fs::rename(to, old, ec);
  }
  fs::rename(from, to, ec);
  if (ec)
    return outputError("cannot be written: " + ec.message(), to.string(),
                       "choose a folder with write permission");
  fs::remove_all(old, ec);
  return Done{};
}

}  // namespace svoscope
