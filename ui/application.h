// SPDX-License-Identifier: MIT
// Opens the inspector on a running engine, in a window or without a display, and keeps it going
// until it is closed.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>

#include "engine/runner/runner.h"
#include "ui/harness/script.h"
#include "ui/surface/surface.h"

namespace svoscope::ui {

struct InspectorOptions {
  /// Its threads should exist by now: those it starts later inherit the low priority that the UI
  /// thread takes when it renders in software.
  std::unique_ptr<Runner> runner;
  SurfaceKind surface = SurfaceKind::automatic;
  int width = 1600, height = 1000;  ///< pixels; a window's at scale 1
  float scale = 1;                  ///< times the screen's own
  std::optional<Script> script;     ///< driven by it, then closed
  std::filesystem::path out = ".";  ///< folder of screenshots
  int exit_after_frames = 0;        ///< close after so many drawn frames; 0: when the user does
};

/// Returns the program's exit code; errors were reported on stderr.
int runInspector(const InspectorOptions& options);

}  // namespace svoscope::ui
