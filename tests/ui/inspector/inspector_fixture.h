// SPDX-License-Identifier: MIT
// The inspector on a host without pixels, driven by mouse and keys.
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "tests/support/fake_runner.h"
#include "ui/host.h"
#include "ui/inspector.h"

namespace svoscope::ui {

class InspectorTest : public ::testing::Test {
 protected:
  void open(const FakeOptions& options = {}, int width = 1280, int height = 800, float scale = 1) {
    HostOptions host_options;
    host_options.surface = SurfaceKind::null;
    host_options.size = {width, height};
    host_options.scale = scale;
    auto host = Host::open(host_options);
    ASSERT_TRUE(host.ok());
    host_ = std::move(host).value();
    runner_ = std::make_unique<FakeRunner>(options);
    inspector_ = std::make_unique<Inspector>(*runner_, host_->graphics());
    frames(3);
  }

  void frames(int count = 1) {
    for (int i = 0; i < count; ++i) host_->frame(*inspector_, false);
  }

  void clickAt(ImVec2 at) {
    InputState& input = host_->scriptInput();
    input.mouse = at;
    frames();
    input.setButton(0, true);
    frames();
    input.setButton(0, false);
    frames(2);
    input.mouse = InputState::nowhere();
    host_->skipTime(1);  // the next click is not the second of a double click
    frames();
  }

  void click(const std::string& label) {
    const auto rect = Probe::find(label);
    ASSERT_TRUE(rect) << label << " was not drawn";
    clickAt(rect->center());
  }

  void press(Key key, bool shift = false) {
    InputState& input = host_->scriptInput();
    input.shift = shift;
    input.setKey(key, true);
    frames();
    input.setKey(key, false);
    input.shift = false;
    frames(2);
  }

  bool sent(Command::Kind kind) const {
    for (const Command& c : runner_->sent()) {
      if (c.kind == kind) return true;
    }
    return false;
  }

  UiState& state() { return inspector_->state(); }

  std::unique_ptr<Host> host_;
  std::unique_ptr<FakeRunner> runner_;
  std::unique_ptr<Inspector> inspector_;
};

}  // namespace svoscope::ui
