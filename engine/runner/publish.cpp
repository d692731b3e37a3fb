// SPDX-License-Identifier: MIT
#include "engine/runner/publish.h"

#include <algorithm>

namespace svoscope {

namespace {

bool isStart(const std::vector<Event>& events) {
  return std::any_of(events.begin(), events.end(),
                     [](const Event& e) { return e.kind == EventKind::initialized; });
}

}  // namespace

void applyCommand(const RunParts& run, const Command& command) {
  run.playback.handle(command);
  if (command.kind == Command::Kind::reset) {
    run.engine.reset();
    run.log.clear();
    run.log.parameters(listParameters(run.engine.parameters()), run.engine.nextFrame());
  } else if (command.kind == Command::Kind::pause && !run.publish &&
             run.engine.record().index >= 0) {
    run.log.addSnapshot(run.engine.snapshot());
  } else if (command.kind == Command::Kind::set_parameter) {
    const Status status = run.engine.setParameter(command.key, command.value);
    if (!status.ok())
      run.log.addNote({run.engine.nextFrame(), EventKind::warning, status.error().message()});
    run.log.parameters(listParameters(run.engine.parameters()), run.engine.nextFrame());
  }
}

void publishFrame(const RunParts& run) {
  Engine& engine = run.engine;
  engine.refreshRecord();
  run.playback.processed(engine.record(), isStart(engine.events()));
  // Before the row: the snapshot's cost is part of it.
  if (run.publish || engine.finished() || !run.playback.wantsFrame())
    run.log.addSnapshot(engine.snapshot());
  run.log.addRecord(engine.record());
  run.log.addEvents(engine.events());
  if (!engine.finished()) return;
  run.playback.finish();
  run.log.addNote({engine.record().index, EventKind::finished, "end of the sequence"});
}

}  // namespace svoscope
