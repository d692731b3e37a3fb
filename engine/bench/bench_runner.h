// SPDX-License-Identifier: MIT
// Runs the cells of a benchmark as child processes of the program.
#pragma once

#include <atomic>
#include <functional>
#include <string>

#include "engine/bench/bench_plan.h"

namespace svoscope {

struct BenchOptions {
  std::filesystem::path out;      ///< DIR
  std::filesystem::path program;  ///< svoscope itself
  std::string version;
  int jobs = 1;                             ///< cells at a time
  int shard = 1, shards = 1;                ///< only every shards-th cell
  bool retry_failed = false;                ///< cells that have a reason, too
  bool any_build = false;                   ///< cells of another build of the program still count
  const std::atomic<bool>* stop = nullptr;  ///< set from outside to end early
  std::function<void(const std::string&)> say;  ///< a line of progress
  std::function<void(const std::string&)> warn;
};

struct BenchOutcome {
  int cells = 0;  ///< of this shard
  int kept = 0;   ///< were finished before
  int ran = 0;
  int failed = 0;  ///< of those run: without a result
  bool interrupted = false;
};

/// Each cell runs into a temporary folder that is renamed once it is complete: whatever ends this
/// process, finished cells stay and half ones do not look finished. Finished cells of the same
/// configuration and build are kept. A cell that fails is a result with a reason. Input error if no
/// sequence at all can be opened, output error if DIR cannot be written.
Result<BenchOutcome> runBench(const BenchConfig& config, const BenchOptions& options);

/// Takes the finished cells of `dirs` together in `out`; cells that are there already stay. Input
/// error unless all are benchmarks of the same plan.
Status mergeBench(const std::vector<std::filesystem::path>& dirs, const std::filesystem::path& out);

/// Moves a complete folder to its place, over what was there.
Status moveIntoPlace(const std::filesystem::path& from, const std::filesystem::path& to);

}  // namespace svoscope
