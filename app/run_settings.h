// SPDX-License-Identifier: MIT
// What view, run and shot have in common: which sequence, which method, which parameters.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "engine/base/methods.h"
#include "engine/runner/make_runner.h"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace svoscope {

struct RunSettings {
  std::string sequence, method = kDefaultMethod, config;
  std::vector<std::string> methods{
      kDefaultMethod};  ///< as chosen by --method, "all" written out; `method` is the first
  std::vector<std::string> assignments;  ///< "key=value"
  int start = 0;
  int max_frames = -1;
  OpenOptions input;  ///< what the user says of the sequence: --camera, --rate

  /// Adds SEQUENCE, --method, --config, --set, --camera, --rate, --start and --max-frames.
  /// `required`: SEQUENCE is.
  void addTo(CLI::App& command, bool required = true,
             const char* what = "Sequence (folder, video, synthetic:PRESET) or recording");
  /// Opens the sequence, and prints what it has to say of itself.
  Result<std::unique_ptr<Sequence>> openInput() const;
  /// Opens the sequence or recording and makes its runner; `options` brings what is not on the
  /// command line. Usage error for options of the engine with a recording.
  Result<std::unique_ptr<Runner>> open(RunnerOptions options) const;
  /// The same on a sequence that is open already.
  Result<std::unique_ptr<Runner>> open(RunnerOptions options,
                                       std::unique_ptr<Sequence> opened) const;
  /// The same settings with another method.
  RunSettings with(const std::string& other_method) const;
  /// Parameters of --config and --set: input error for the file, usage error for the line.
  Result<Parameters> parameters() const;

 private:
  std::vector<const CLI::Option*> of_engine_;  ///< options that a recording has no use for
};

}  // namespace svoscope
