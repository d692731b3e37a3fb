// SPDX-License-Identifier: MIT
// What a benchmark runs: sequences x methods x variants x runs, from a YAML file (docs/bench.md).
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "engine/base/result.h"
#include "engine/eval/evaluate.h"

namespace svoscope {

/// Parameters as "key" and text, in the order of the file.
using Assignments = std::vector<std::pair<std::string, std::string>>;

struct BenchSequence {
  std::string name;    ///< in tables and of folders; unique
  std::string path;    ///< as openSequence takes it
  std::string group;   ///< heading in the tables: "TUM RGB-D"
  int start = 0;       ///< first frame
  int max_frames = 0;  ///< 0: all
  bool still = false;  ///< the camera does not move: not to start is right
};

struct BenchVariant {
  std::string name;  ///< empty: the only one, all parameters as they are
  Assignments set;
};

/// Trajectories of another system, shown beside ours.
struct BenchPeer {
  std::string label;
  std::string files;  ///< path with {sequence} in place of the sequence's name
};

/// One column of the tables.
struct BenchSystem {
  std::string label;   ///< "it-svo", or "it-svo wide" with the variant
  std::string folder;  ///< "it-svo", "it-svo+wide"
  std::string method;  ///< empty for a peer
  int variant = 0;     ///< index into variants
};

struct BenchConfig {
  std::string title;
  std::vector<BenchSequence> sequences;
  std::vector<std::string> methods;
  std::vector<BenchVariant> variants;  ///< at least one
  Assignments parameters;              ///< of all cells, before those of the variant
  int runs = 4;
  bool sync = false;           ///< without threads
  double timeout_s = 1800;     ///< of a cell
  double least_tracked = 0.9;  ///< runs that track less of the frames after the start have failed
  EvalOptions evaluation;
  std::vector<BenchPeer> peers;
  std::string text;  ///< of the file

  /// Methods x variants, in this order.
  std::vector<BenchSystem> systems() const;
};

enum class BenchConfigUse {
  run,     ///< everything is checked
  report,  ///< only names are needed: variables of the environment may be missing
};

/// Reads and checks a configuration. "${NAME}" is replaced from the environment; relative paths
/// count from the folder of the file. Input errors name file, line, what is allowed: unknown keys,
/// methods, presets and parameters, values out of range, names that repeat or cannot be a folder's.
/// A folder that does not exist is no error here: its cells fail with that reason.
Result<BenchConfig> loadBenchConfig(const std::filesystem::path& file,
                                    BenchConfigUse use = BenchConfigUse::run);

}  // namespace svoscope
