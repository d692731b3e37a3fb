// SPDX-License-Identifier: MIT
// The cells of a benchmark and where their results lie.
//
//   DIR/bench.yaml                    the configuration
//   DIR/sequences/NAME/               times.txt, groundtruth.txt: all a report needs
//   DIR/peers/LABEL/NAME.txt          external trajectories
//   DIR/synth/NAME/                   rendered sequences
//   DIR/cells/NAME/SYSTEM/run-N/      files of `svoscope run`, log.txt, cell.json
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "engine/bench/bench_config.h"

namespace svoscope {

/// One run.
struct BenchCell {
  int sequence = 0, system = 0;  ///< indices into config.sequences and config.systems()
  int run = 1;
  std::filesystem::path folder;  ///< relative to DIR
};

/// All cells, first runs before second ones, so that a report half-way has something of everything.
/// Synchronous runs are all the same: there is one.
std::vector<BenchCell> cellsOf(const BenchConfig& config);

/// What the frames of a cell are: decides, with the parameters, whether a finished cell still
/// counts.
struct SequenceFacts {
  std::string error;          ///< why it cannot be opened; the rest is empty then
  std::vector<double> times;  ///< s, of the frames that are run
  Trajectory ground_truth;
  int width = 0, height = 0;

  std::string signature() const;
};

/// Opens the sequence and looks at it.
SequenceFacts probeSequence(const BenchSequence& sequence);
/// Writes and reads DIR/sequences/NAME; reading gives an error text if there is nothing.
Status writeFacts(const std::filesystem::path& dir, const BenchSequence& sequence,
                  const SequenceFacts& facts);
SequenceFacts readFacts(const std::filesystem::path& dir, const BenchSequence& sequence);

/// Arguments of the program for a cell, without --out; `path` is where the sequence lies.
std::vector<std::string> cellArguments(const BenchConfig& config, const BenchCell& cell,
                                       const std::string& path);

/// Hash of method, every parameter as used, threads and frames. Not of paths: data may be moved.
std::string cellFingerprint(const BenchConfig& config, const BenchCell& cell,
                            const SequenceFacts& facts);

/// FNV-1a, 64 bits, as 16 digits.
std::string fingerprintOf(const std::string& bytes);
/// Of a file's content; empty if it cannot be read.
std::string fileFingerprint(const std::filesystem::path& file);

/// "model name, n threads" of this machine.
std::string machineName();

}  // namespace svoscope
