// SPDX-License-Identifier: MIT
#include "ui/application.h"

#include <spdlog/spdlog.h>

#include <cstdio>

#include "engine/base/stopwatch.h"
#include "ui/harness/executor.h"
#include "ui/harness/inspector_target.h"
#include "ui/host.h"
#include "ui/host_pacing.h"
#include "ui/inspector.h"

namespace svoscope::ui {
namespace {

int fail(const Error& error) {
  std::fprintf(stderr, "svoscope: error: %s\n", error.message().c_str());
  return error.exitCode();
}

void report(Host& host) {
  for (const std::string& warning : host.takeWarnings()) spdlog::warn("{}", warning);
}

bool save(Host& host, Inspector& inspector, const std::string& file,
          const std::optional<ProbeRect>& part) {
  const Status status = host.screenshot(file, part);
  if (status) {
    spdlog::info("saved {}", file);
  } else {
    inspector.state().toasts.add(status.error().message(), true);
    spdlog::error("{}", status.error().message());
  }
  return status.ok();
}

/// What the user asked for in the last frame: a picture of it, another scale.
void serveRequests(Host& host, Inspector& inspector) {
  if (const std::optional<float> scale = inspector.takeScaleRequest()) host.setScale(*scale);
  if (const std::optional<std::string> file = inspector.takeScreenshotRequest()) {
    save(host, inspector, *file, std::nullopt);
  }
  if (const std::optional<ExportRequest> picture = inspector.takePictureRequest()) {
    const bool saved = save(host, inspector, picture->file, Probe::find("panel:" + picture->panel));
    if (saved) inspector.state().toasts.add("Wrote " + picture->file);
  }
}

int runScripted(const InspectorOptions& options, Host& host, Inspector& inspector) {
  InspectorTarget target(*options.runner, inspector.state());
  const Result<ScriptReport> result =
      runScript(*options.script, {host, inspector, target, options.runner.get(), options.out});
  report(host);
  if (!result) return fail(result.error());
  for (const std::string& note : result.value().notes) std::printf("%s\n", note.c_str());
  for (const auto& picture : result.value().pictures) std::printf("%s\n", picture.c_str());
  return 0;
}

/// Draws when the pacer says so; in between sleeps, or lets a synchronous engine work.
int runLoop(const InspectorOptions& options, Host& host, Inspector& inspector) {
  Runner& runner = *options.runner;
  Surface& surface = host.surface();
  if (host.softwareRendering() && surface.kind() == SurfaceKind::window) yieldToEngine();
  FramePacer pacer(host.softwareRendering());
  const Stopwatch clock;
  const auto now = [&clock] { return clock.ms() / 1000; };
  std::uint64_t drawn_snapshot = 0;
  for (int frames = 0; !surface.shouldClose() && !inspector.wantsClose();) {
    const bool worked = runner.pump();
    surface.waitForInput(0);
    const SnapshotPtr latest = runner.latest();
    FramePacer::Situation situation;
    situation.input = surface.inputPending();
    situation.new_snapshot = latest && latest->sequence_number != drawn_snapshot;
    situation.playing = runner.status().playing;
    // A run of so many frames is a test or a benchmark: no reason to wait.
    if (options.exit_after_frames > 0 || pacer.due(situation, now())) {
      const double start = now();
      host.frame(inspector);
      pacer.drawn(situation, now(), now() - start);
      drawn_snapshot = latest ? latest->sequence_number : 0;
      serveRequests(host, inspector);
      if (++frames == options.exit_after_frames) break;
      if (frames == 1) report(host);
    } else if (!worked) {
      surface.waitForInput(pacer.patience(situation, now()));
    }
  }
  return 0;
}

}  // namespace

int runInspector(const InspectorOptions& options) {
  if (!options.script && options.exit_after_frames <= 0 &&
      (options.surface == SurfaceKind::osmesa || options.surface == SurfaceKind::null)) {
    return fail(usageError("there is nothing to do without a window", "--headless",
                           "give a script with --script FILE"));
  }
  HostOptions host_options;
  host_options.surface = options.surface;
  host_options.size = {options.width, options.height};
  host_options.scale = options.scale;
  host_options.title = options.runner->info().sequence + " - svoscope";
  const Result<std::unique_ptr<Host>> host = Host::open(host_options);
  if (!host) return fail(host.error());
  spdlog::debug("rendering by {}", host.value()->description());
  Inspector inspector(*options.runner, host.value()->graphics());
  inspector.state().output_folder = options.out.string();
  inspector.setRenderer(host.value()->description());
  if (host.value()->surface().kind() == SurfaceKind::window && !options.script)
    inspector.useLayoutFile(defaultLayoutPath());
  return options.script ? runScripted(options, *host.value(), inspector)
                        : runLoop(options, *host.value(), inspector);
}

}  // namespace svoscope::ui
