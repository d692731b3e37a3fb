// SPDX-License-Identifier: MIT
#include "engine/runner/make_runner.h"

#include "engine/runner/sync_runner.h"
#include "engine/runner/threaded_runner.h"

namespace svoscope {

Result<std::unique_ptr<Runner>> makeRunner(std::unique_ptr<Sequence> sequence, const RunnerOptions& options) {
  if (options.method != "svo" && options.method != "pl-svo" && options.method != "it-svo")
    return usageError("method '" + options.method + "' is not available", "--method", "use svo, pl-svo or it-svo");
  if (sequence->size() == 0)
    return inputError("the sequence has no frames", sequence->name(), "check the list of images");
  if (options.start >= sequence->size())
    return usageError("the first frame lies behind the end of the sequence", "--start",
                      "the sequence has " + std::to_string(sequence->size()) + " frames");
  const Status camera = sequence->camera().check();
  if (!camera.ok()) return camera.error();
  RunnerOptions o = options;
  o.parameters.tracker.mapping.segments.enabled = options.method != "svo";
  if (o.threaded) return std::unique_ptr<Runner>(new ThreadedRunner(std::move(sequence), o));
  return std::unique_ptr<Runner>(new SyncRunner(std::move(sequence), o));
}

}  // namespace svoscope
