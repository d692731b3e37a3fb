// SPDX-License-Identifier: MIT
#include "engine/runner/sync_runner.h"

#include <algorithm>

#include "engine/base/stopwatch.h"

namespace svoscope {

bool isStart(const std::vector<Event>& events) {
  return std::any_of(events.begin(), events.end(), [](const Event& e) { return e.kind == EventKind::initialized; });
}

SyncRunner::SyncRunner(std::unique_ptr<Sequence> sequence, const RunnerOptions& o)
    : engine_(std::move(sequence), o.parameters, o.start, o.max_frames, o.method),
      log_(o.history_budget, o.observer),
      publish_(o.publish_snapshots) {
  engine_.setInspected(publish_);
  engine_.setPlaced(o.place_seeds);
  log_.begin(engine_.info());
  log_.parameters(listParameters(engine_.parameters()), engine_.nextFrame());
}

void SyncRunner::handle(const Command& command) {
  playback_.handle(command);
  if (command.kind == Command::Kind::reset) {
    engine_.reset();
    log_.clear();
    log_.parameters(listParameters(engine_.parameters()), engine_.nextFrame());
  } else if (command.kind == Command::Kind::pause && !publish_ && engine_.record().index >= 0) {
    log_.addSnapshot(engine_.snapshot());
  } else if (command.kind == Command::Kind::set_parameter) {
    const Status status = engine_.setParameter(command.key, command.value);
    if (!status.ok()) log_.addNote({engine_.nextFrame(), EventKind::warning, status.error().message()});
    log_.parameters(listParameters(engine_.parameters()), engine_.nextFrame());
  }
}

void SyncRunner::processFrame() {
  Stopwatch watch;
  engine_.step();
  if (const auto job = engine_.takeMappingJob()) engine_.applyMapping(runMappingJob(*job, engine_.mappingParameters()));
  engine_.refreshRecord();
  playback_.processed(engine_.record(), isStart(engine_.events()));
  if (publish_ || engine_.finished() || !playback_.wantsFrame()) log_.addSnapshot(engine_.snapshot());
  log_.addRecord(engine_.record());
  log_.addEvents(engine_.events());
  if (engine_.finished()) {
    playback_.finish();
    log_.addNote({engine_.record().index, EventKind::finished, "end of the sequence"});
  }
  const double ms = watch.ms();
  frame_ms_ = frame_ms_ > 0 ? 0.9 * frame_ms_ + 0.1 * ms : ms;
}

bool SyncRunner::pump() {
  while (!commands_.empty()) {
    const Command command = commands_.front();
    commands_.pop_front();
    handle(command);
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
  status.fps = frame_ms_ > 0 ? 1000.0 / frame_ms_ : 0;
  log_.describe(status);
  return status;
}

}  // namespace svoscope
