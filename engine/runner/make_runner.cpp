// SPDX-License-Identifier: MIT
#include "engine/runner/make_runner.h"

#include "engine/base/methods.h"
#include "engine/runner/sync_runner.h"
#include "engine/runner/threaded_runner.h"

namespace svoscope {

Status applyMethod(Parameters& parameters, const std::string& id) {
  const MethodInfo* method = findMethod(id);
  if (!method)
    return usageError("method '" + id + "' is not available", "--method", "use " + methodList());
  parameters.tracker.mapping.filter.rule = method->rule;
  parameters.tracker.mapping.segments.enabled = method->segments;
  return Done{};
}

Result<std::unique_ptr<Runner>> makeRunner(std::unique_ptr<Sequence> sequence,
                                           const RunnerOptions& asked) {
  RunnerOptions options = asked;
  const Status known = applyMethod(options.parameters, asked.method);
  if (!known.ok()) return known.error();
  const Status bounded = checkParameters(options.parameters);
  if (!bounded.ok()) return bounded.error();
  if (sequence->size() == 0)
    return inputError("the sequence has no frames", sequence->name(), "check the list of images");
  if (options.start >= sequence->size())
    return usageError("the first frame lies behind the end of the sequence", "--start",
                      "the sequence has " + std::to_string(sequence->size()) + " frames");
  const Status camera = sequence->camera().check();
  if (!camera.ok()) return camera.error();
  if (options.threaded)
    return std::unique_ptr<Runner>(new ThreadedRunner(std::move(sequence), options));
  return std::unique_ptr<Runner>(new SyncRunner(std::move(sequence), options));
}

}  // namespace svoscope
