// SPDX-License-Identifier: MIT
// Three fake runs and a trajectory in lockstep, driven by a script.
#pragma once

#include <gtest/gtest.h>

#include <fstream>
#include <memory>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "engine/runner/lockstep_runner.h"
#include "engine/runner/trajectory_runner.h"
#include "tests/support/fake_runner.h"
#include "tests/support/support.h"
#include "tests/ui/render/render_fixture.h"
#include "ui/harness/executor.h"
#include "ui/harness/inspector_target.h"
#include "ui/inspector.h"

namespace svoscope::ui {

inline FakeOptions fakeRun(const std::string& method, int start, double bend) {
  FakeOptions options;
  options.method = method;
  options.start = start;
  options.bend = bend;
  options.frames = 120;
  options.width = 320;
  options.height = 240;
  options.landmarks = 200;
  options.seeds = 60;
  options.lost_from = 60;
  options.lost_to = 64;
  return options;
}

class Compare : public testing::TestWithParam<SurfaceKind> {
 protected:
  void SetUp() override {
    host = openHost(GetParam(), 1280, 720);
    if (!host) GTEST_SKIP() << "OSMesa is absent: install libosmesa6";
  }

  void open(bool truth = true) {
    add("svo", fakeRun("svo", 12, 4e-5), truth);
    add("pl-svo", fakeRun("pl-svo", 5, 2e-5), truth);
    FakeOptions never = fakeRun("it-svo", 1000, 0);
    never.lost_to = 0;
    add("it-svo", never, truth);
    members.push_back(trajectory());
    runs = std::make_unique<LockstepRunner>(std::move(members), LockstepRunner::Drive::by_pump);
    inspector = std::make_unique<Inspector>(*runs, host->graphics());
  }

  void add(const std::string& label, FakeOptions options, bool truth) {
    options.ground_truth = truth;
    members.push_back({std::make_unique<FakeRunner>(options), label, false});
  }

  /// Poses of frames 20 to 79 on the ground truth itself.
  LockstepMember trajectory() {
    const RunInfo of_run = FakeRunner(fakeRun("svo", 5, 0)).info();
    TrajectoryFile file;
    FrameTimes frames;
    for (int i = 0; i < 120; ++i) {
      const StampedPose& pose = of_run.ground_truth[static_cast<std::size_t>(i)];
      frames.timestamps.push_back(pose.timestamp);
      if (i >= 20 && i < 80) file.poses.push_back(pose);
    }
    RunInfo info = members.front().runner->info();
    info.method = "orb";
    return {TrajectoryRunner::make(file, frames, info, "orb.txt").value(), "orb", true};
  }

  std::string run(const std::string& text) {
    const Result<Script> script = parseScript(text, "test.script");
    if (!script) return script.error().message();
    InspectorTarget target(*runs, inspector->state());
    const auto result =
        runScript(script.value(), {*host, *inspector, target, runs.get(), folder.path()});
    return result ? "" : result.error().message();
  }

  std::string written(const std::string& name) {
    std::ifstream in(folder.path() / name);
    std::ostringstream text;
    text << in.rdbuf();
    return text.str();
  }

  test::TemporaryFolder folder;
  std::vector<LockstepMember> members;
  std::unique_ptr<Host> host;
  std::unique_ptr<LockstepRunner> runs;
  std::unique_ptr<Inspector> inspector;
};

}  // namespace svoscope::ui
