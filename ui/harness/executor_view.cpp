// SPDX-License-Identifier: MIT
// Commands that act on what is on screen: mouse, keyboard, window, pictures, expectations.
#include <cstdio>

#include "ui/harness/engine_values.h"
#include "ui/harness/executor_commands.h"

namespace svoscope::ui {
namespace {

constexpr int kSettlingFrames = 3;  // automatic sizes and hover need as many

}  // namespace

Status Executor::clickWidget(const ScriptCommand& c, int button, int times) {
  const Result<ProbeRect> rect = gestures_.find(joined(c.arguments));
  if (!rect) return rect.error();
  gestures_.click(rect.value().center(), button, times);
  return Done{};
}

Status Executor::hover(const ScriptCommand& c) {
  const Result<ProbeRect> rect = gestures_.find(joined(c.arguments));
  if (!rect) return rect.error();
  gestures_.hover(rect.value().center());
  return Done{};
}

Status Executor::drag(const ScriptCommand& c) {
  const Result<double> x = toNumber(c.arguments[1]), y = toNumber(c.arguments[2]);
  if (!x) return x.error();
  if (!y) return y.error();
  const Result<ProbeRect> rect = gestures_.find(c.arguments[0]);
  if (!rect) return rect.error();
  gestures_.drag(rect.value().center(),
                 {static_cast<float>(x.value()), static_cast<float>(y.value())});
  return Done{};
}

Status Executor::wheel(const ScriptCommand& c) {
  const Result<double> notches = toNumber(c.arguments[1]);
  if (!notches) return notches.error();
  const Result<ProbeRect> rect = gestures_.find(c.arguments[0]);
  if (!rect) return rect.error();
  gestures_.wheel(rect.value().center(), static_cast<float>(notches.value()));
  return Done{};
}

Status Executor::key(const ScriptCommand& c) {
  const std::optional<KeyChord> chord = parseKey(c.arguments.front());
  if (!chord) {
    return usageError("no key is called '" + c.arguments.front() + "'", "",
                      "a character, or: " + joined(keyNames()));
  }
  gestures_.key(*chord);
  return Done{};
}

Status Executor::type(const ScriptCommand& c) {
  gestures_.type(joined(c.arguments));
  return Done{};
}

Status Executor::wait(const ScriptCommand& c) {
  const Result<int> count = toCount(c.arguments, 1);
  if (!count) return count.error();
  gestures_.tick(count.value());
  return Done{};
}

Status Executor::scale(const ScriptCommand& c) {
  const Result<double> value = toNumber(c.arguments.front());
  if (!value) return value.error();
  if (value.value() < 0.25 || value.value() > 4)
    return usageError("scale " + c.arguments.front() + " is out of range", "", "0.25 to 4");
  stage_.host.setScale(static_cast<float>(value.value()));
  gestures_.tick();
  return Done{};
}

Status Executor::size(const ScriptCommand& c) {
  SurfaceSize size;
  char rest = 0;
  const char* text = c.arguments.front().c_str();
  const bool read = std::sscanf(text, "%dx%d%c", &size.width, &size.height, &rest) == 2;
  if (!read || size.width < 64 || size.height < 64 || size.width > 8192 || size.height > 8192)
    return usageError("'" + c.arguments.front() + "' is not a size", "", "1280x800, 64 to 8192");
  stage_.host.resize(size);
  gestures_.tick();
  return Done{};
}

Status Executor::shot(const ScriptCommand& c) {
  std::filesystem::path file = stage_.output / c.arguments.front();
  if (!file.has_extension()) file += ".png";
  return picture(file, joined(Words(c.arguments.begin() + 1, c.arguments.end())));
}

Status Executor::exportPanel(const ScriptCommand& c) {
  const std::filesystem::path file = stage_.output / c.arguments.back();
  const std::string panel = joined(Words(c.arguments.begin(), c.arguments.end() - 1));
  const std::string kind = file.extension().string();
  if (kind == ".png") return picture(file, panel);
  if (kind != ".csv" && kind != ".svg") {
    return usageError("'" + c.arguments.back() + "' is no kind of file to export", "",
                      "end it in .csv, .svg or .png");
  }
  gestures_.tick(kSettlingFrames - 1);
  Status status = stage_.target.requestExport(panel, file.string());
  if (!status) return status;
  gestures_.tick(2);
  status = stage_.target.exportResult();
  if (status) report.pictures.push_back(file);
  return status;
}

Status Executor::picture(const std::filesystem::path& file, const std::string& panel) {
  gestures_.tick(kSettlingFrames - 1);
  std::optional<ProbeRect> part;
  if (!panel.empty()) {
    const Result<ProbeRect> rect = gestures_.find("panel:" + panel);
    if (!rect) {
      const Status hidden = stage_.target.panelOnScreen(panel);
      return hidden ? rect.error() : hidden.error();
    }
    part = rect.value();
  }
  if (!stage_.host.hasPixels()) {
    report.notes.push_back(file.string() + " left out: the null surface has no pixels");
    return Done{};
  }
  gestures_.render();
  const Status status = stage_.host.screenshot(file, part);
  if (status) report.pictures.push_back(file);
  return status;
}

std::optional<ScriptValue> Executor::value(const std::string& name) const {
  if (name == "labels") return ScriptValue(Probe::labels());
  if (name == "width") return ScriptValue(double(stage_.host.surface().size().width));
  if (name == "height") return ScriptValue(double(stage_.host.surface().size().height));
  if (const auto at = name.find('@'); at != std::string::npos) {
    const RunView* run = stage_.target.findRun(name.substr(at + 1));
    return run ? engineValue(*run, shownFrame(), name.substr(0, at)) : std::nullopt;
  }
  if (const std::optional<ScriptValue> known = stage_.target.value(name)) return known;
  if (!stage_.runner) return std::nullopt;
  return engineValue(*stage_.runner, shownFrame(), name);
}

Status Executor::expect(const ScriptCommand& c) {
  gestures_.tick();
  const ScriptValues values = [this](const std::string& name) { return value(name); };
  Status status = checkExpectation(c.arguments, values);
  if (status || value(c.arguments.front())) return status;
  Error unknown = status.error();
  unknown.remedy = "known: " + engineValueNames();
  return unknown;
}

}  // namespace svoscope::ui
