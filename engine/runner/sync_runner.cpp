// SPDX-License-Identifier: MIT
#include "engine/runner/sync_runner.h"

#include "engine/base/stopwatch.h"

namespace svoscope {

SyncRunner::SyncRunner(std::unique_ptr<Sequence> sequence, const RunnerOptions& o)
    : engine_(std::move(sequence), o.parameters, o.start, o.max_frames, o.method),
      log_(o.history_budget, o.observer),
      publish_(o.publish_snapshots) {
  engine_.setInspected(publish_);
  engine_.setPlaced(o.place_seeds);
  log_.begin(engine_.info());
  log_.parameters(listParameters(engine_.parameters()), engine_.nextFrame());
}

void SyncRunner::processFrame() {
  Stopwatch watch;
  engine_.step();
  if (const auto job = engine_.takeMappingJob())
    engine_.applyMapping(runMappingJob(*job, engine_.mappingParameters()));
  publishFrame(parts());
  rate_.add(watch.ms());
}

bool SyncRunner::pump() {
  while (!commands_.empty()) {
    const Command command = commands_.front();
    commands_.pop_front();
    applyCommand(parts(), command);
    // A step asked for by one command must not be swallowed by the next.
    if (command.kind == Command::Kind::step) break;
  }
  if (!playback_.wantsFrame()) return false;
  if (engine_.finished()) {
    playback_.finish();
    return false;
  }
  processFrame();
  return true;
}

RunnerStatus SyncRunner::status() const {
  RunnerStatus status;
  status.playing = playback_.playing();
  status.finished = engine_.finished();
  status.next_frame = engine_.nextFrame();
  status.fps = rate_.fps();
  log_.describe(status);
  return status;
}

}  // namespace svoscope
