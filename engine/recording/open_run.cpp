// SPDX-License-Identifier: MIT
#include "engine/recording/open_run.h"

#include "engine/recording/recording_runner.h"

namespace svoscope {

bool looksLikeRecording(const std::filesystem::path& file) {
  std::error_code ec;
  return std::filesystem::is_regular_file(file, ec) &&
         (file.extension() == ".svoscope" || isSqliteFile(file));
}

Result<std::unique_ptr<Runner>> openRun(const std::string& spec, const RunnerOptions& options) {
  if (looksLikeRecording(spec)) {
    auto file = RecordingFile::open(spec);
    if (!file.ok()) return file.error();
    return std::unique_ptr<Runner>(new RecordingRunner(std::move(file).value()));
  }
  auto sequence = openSequence(spec);
  if (!sequence.ok()) return sequence.error();
  return makeRunner(std::move(sequence).value(), options);
}

}  // namespace svoscope
