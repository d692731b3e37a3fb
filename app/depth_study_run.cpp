// SPDX-License-Identifier: MIT
#include "app/depth_study_run.h"

#include <fmt/format.h>

#include "app/command.h"
#include "app/interrupt.h"
#include "app/progress.h"
#include "engine/io/depth_study_writer.h"

namespace svoscope {

Status checkDepthStudy(const RunSettings& run) {
  auto sequence = openSequence(run.sequence, run.input);
  return sequence.ok() ? depthStudyPossible(*sequence.value()) : sequence.error();
}

int runDepthStudyCommand(const RunSettings& run, const std::string& poses_from,
                         const std::string& out, const std::vector<FrameRecord>& records) {
  auto sequence = openSequence(run.sequence, run.input);
  if (!sequence.ok()) return reportError(sequence.error());
  const Result<Parameters> parameters = run.parameters();
  if (!parameters.ok()) return reportError(parameters.error());
  DepthStudyOptions options;
  options.mapping = parameters.value().tracker.mapping;
  options.start = run.start;
  options.max_frames = run.max_frames;
  options.poses_from = poses_from;
  if (poses_from == "groundtruth") {
    options.poses = groundTruthPoses(*sequence.value());
  } else {
    auto poses = alignedPoses(*sequence.value(), records);
    if (!poses.ok()) return reportError(poses.error());
    options.poses = std::move(poses).value();
  }
  const InterruptGuard guard;
  Result<DepthStudyResult> result = DepthStudyResult();
  {
    Progress progress;
    options.progress = [&](int done, int total) {
      progress.show(fmt::format("depth study {}/{}", done, total));
      return !guard.flag();
    };
    result = runDepthStudy(*sequence.value(), options);
  }
  if (!result.ok()) return reportError(result.error());
  const Status written = writeDepthStudy(out, result.value());
  if (!written.ok()) return reportError(written.error());
  if (guard.flag()) {
    reportWarning("interrupted; what was done is written");
    return kExitInterrupted;
  }
  fmt::print("{}", depthStudyText(result.value()));
  return kExitDone;
}

}  // namespace svoscope
