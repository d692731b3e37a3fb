// SPDX-License-Identifier: MIT
#include "ui/harness/executor.h"

#include <cstdlib>
#include <limits>
#include <utility>

#include "ui/harness/engine_driver.h"
#include "ui/harness/executor_commands.h"

namespace svoscope::ui {

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : " ") + word;
  return text;
}

Result<double> toNumber(const std::string& text) {
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  if (text.empty() || *end != '\0') return usageError("'" + text + "' is not a number", "", "");
  return value;
}

Result<int> toCount(const std::vector<std::string>& words, int otherwise) {
  if (words.empty()) return otherwise;
  const Result<double> value = toNumber(words.front());
  if (!value) return value.error();
  const double limit = std::numeric_limits<int>::max();
  if (value.value() < 0 || value.value() > limit ||
      value.value() != static_cast<int>(value.value()))
    return usageError("'" + words.front() + "' is not a count", "", "a whole number, not negative");
  return static_cast<int>(value.value());
}

const std::map<std::string, Executor::Action>& Executor::actions() {
  static const std::map<std::string, Action> table = {{"open", &Executor::open},
                                                      {"step", &Executor::step},
                                                      {"run-to", &Executor::runTo},
                                                      {"reset", &Executor::reset},
                                                      {"back", &Executor::back},
                                                      {"goto", &Executor::gotoFrame},
                                                      {"run", &Executor::showRun},
                                                      {"select", &Executor::select},
                                                      {"panel", &Executor::panel},
                                                      {"layout", &Executor::layout},
                                                      {"click", &Executor::click},
                                                      {"hover", &Executor::hover},
                                                      {"double-click", &Executor::doubleClick},
                                                      {"drag", &Executor::drag},
                                                      {"right-click", &Executor::rightClick},
                                                      {"wheel", &Executor::wheel},
                                                      {"key", &Executor::key},
                                                      {"type", &Executor::type},
                                                      {"wait", &Executor::wait},
                                                      {"set", &Executor::set},
                                                      {"scale", &Executor::scale},
                                                      {"size", &Executor::size},
                                                      {"shot", &Executor::shot},
                                                      {"export", &Executor::exportPanel},
                                                      {"expect", &Executor::expect}};
  return table;
}

Status Executor::run(const ScriptCommand& command) {
  const auto action = actions().find(command.name);
  if (action == actions().end()) return usageError("'" + command.name + "' cannot be run", "", "");
  const Status status = (this->*action->second)(command);
  if (status) ++report.commands;
  return status;
}

Status Executor::needRunner() const {
  if (stage_.runner) return Done{};
  return usageError("no sequence is open", "", "begin with `open SEQUENCE`");
}

int Executor::shownFrame() const {
  const int shown = stage_.target.shownFrame();
  if (shown >= 0 || !stage_.runner) return shown;
  const SnapshotPtr latest = stage_.runner->latest();
  return latest ? latest->record.index : -1;
}

Status Executor::step(const ScriptCommand& c) {
  const Result<int> count = toCount(c.arguments, 1);
  if (!count) return count.error();
  Status status = needRunner();
  if (status) status = stepFrames(*stage_.runner, count.value());
  gestures_.tick();
  return status;
}

Status Executor::runTo(const ScriptCommand& c) {
  Status status = needRunner();
  if (status) status = runUntil(*stage_.runner, c.arguments.front());
  gestures_.tick();
  return status;
}

Status Executor::reset(const ScriptCommand&) {
  Status status = needRunner();
  if (status) status = resetRun(*stage_.runner);
  gestures_.tick();
  return status;
}

Status Executor::back(const ScriptCommand& c) {
  const Result<int> count = toCount(c.arguments, 1);
  if (!count) return count.error();
  const int frame = shownFrame() - count.value();
  if (frame < 0) return usageError("there is no frame " + std::to_string(frame), "", "");
  const Status status = stage_.target.showFrame(frame);
  gestures_.tick();
  return status;
}

Status Executor::gotoFrame(const ScriptCommand& c) {
  const bool live = c.arguments.front() == "live";
  const Result<int> frame = live ? Result<int>(-1) : toCount(c.arguments, 0);
  if (!frame) return frame.error();
  const Status status = stage_.target.showFrame(frame.value());
  gestures_.tick();
  return status;
}

Status Executor::showRun(const ScriptCommand& c) {
  const Status status = stage_.target.showRun(joined(c.arguments));
  gestures_.tick();
  return status;
}

Status Executor::select(const ScriptCommand& c) {
  Words words = c.arguments;
  if (words.size() == 4 && words[1] == "any" && words[2] == "or" && words[3] == "none") {
    words.resize(2);
    const Status found = selectOne(words, c);
    return found ? found : stage_.target.selectNothing();
  }
  return selectOne(words, c);
}

Status Executor::selectOne(const Words& words, const ScriptCommand& c) {
  std::vector<double> numbers;
  for (std::size_t i = 1; i < words.size(); ++i) {
    const Result<double> number = words[i] == "any" ? Result<double>(-1) : toNumber(words[i]);
    if (!number) return number.error();
    numbers.push_back(number.value());
  }
  if (words[0] == "none" && numbers.empty()) return stage_.target.selectNothing();
  if (words[0] == "feature" && numbers.size() == 1)
    return stage_.target.selectFeature(static_cast<std::int64_t>(numbers[0]));
  if (words[0] == "seed" && numbers.size() == 1)
    return stage_.target.selectSeed(static_cast<std::int64_t>(numbers[0]));
  if (words[0] != "at" || numbers.size() != 2)
    return usageError("cannot select '" + c.rest + "'", "",
                      "write: select feature ID, seed ID, at X Y, or none");
  gestures_.tick();
  const std::optional<ImVec2> place =
      stage_.target.screenPosition(static_cast<float>(numbers[0]), static_cast<float>(numbers[1]));
  if (!place) return usageError("that pixel is not on screen", "", "show the panel Image first");
  gestures_.click(*place);
  return Done{};
}

Status Executor::set(const ScriptCommand& c) {
  const std::string &name = c.arguments[0], &text = c.arguments[1];
  if (stage_.runner) {
    for (const ParameterView& parameter : stage_.runner->parameters()) {
      if (parameter.key != name) continue;
      Command command;
      command.kind = Command::Kind::set_parameter;
      command.key = name;
      command.value = text;
      stage_.runner->send(command);
      gestures_.tick();
      return Done{};
    }
  }
  const Status status = stage_.target.set(name, text);
  gestures_.tick();
  return status;
}

Result<ScriptReport> runScript(const Script& script, const ScriptStage& stage) {
  stage.host.driveByScript();
  Executor executor(stage);
  for (const ScriptCommand& command : script.commands) {
    const Status status = executor.run(command);
    if (status) continue;
    Error error = status.error();
    error.where = script.source + ":" + std::to_string(command.line) +
                  (error.where.empty() ? "" : ": " + error.where);
    return error;
  }
  return std::move(executor.report);
}

}  // namespace svoscope::ui
