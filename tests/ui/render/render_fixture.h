// SPDX-License-Identifier: MIT
// A host on OSMesa with content given by a function.
#pragma once

#include <gtest/gtest.h>

#include <functional>
#include <memory>
#include <utility>

#include "ui/host.h"

namespace svoscope::ui {

class DrawFunction : public UiContent {
 public:
  explicit DrawFunction(std::function<void()> draw) : draw_(std::move(draw)) {}
  void draw() override { draw_(); }

 private:
  std::function<void()> draw_;
};

inline std::unique_ptr<Host> openHost(SurfaceKind kind, int width, int height, float scale = 1) {
  HostOptions options;
  options.surface = kind;
  options.size = {width, height};
  options.scale = scale;
  Result<std::unique_ptr<Host>> host = Host::open(options);
  return host ? std::move(host).value() : nullptr;
}

}  // namespace svoscope::ui

/// Declares `host`; skips the test where OSMesa is not installed.
#define SVOSCOPE_OSMESA_HOST(host, width, height)                                            \
  const std::unique_ptr<::svoscope::ui::Host> host =                                         \
      ::svoscope::ui::openHost(::svoscope::ui::SurfaceKind::osmesa, width, height);          \
  if (!host) GTEST_SKIP() << "OSMesa is absent: install libosmesa6"
