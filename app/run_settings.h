// SPDX-License-Identifier: MIT
// What view, run and shot have in common: which sequence, which method, which parameters.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "engine/runner/make_runner.h"

namespace CLI {
class App;
}

namespace svoscope {

struct RunSettings {
  std::string sequence, method = "svo", config;
  std::vector<std::string> assignments;  ///< "key=value"
  int start = 0;
  int max_frames = -1;

  /// Adds SEQUENCE, --method, --config, --set, --start and --max-frames. `required`: SEQUENCE is.
  void addTo(CLI::App& command, bool required = true);
  /// Opens the sequence and makes its runner; `options` brings what is not on the command line.
  Result<std::unique_ptr<Runner>> open(RunnerOptions options) const;
  /// Parameters of --config and --set: input error for the file, usage error for the line.
  Result<Parameters> parameters() const;
};

}  // namespace svoscope
