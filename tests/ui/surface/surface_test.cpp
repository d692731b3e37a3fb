// SPDX-License-Identifier: MIT
#include "ui/surface/surface.h"

#include <gmock/gmock.h>

#include <cstdlib>
#include <opencv2/core.hpp>

#include "tests/ui/render/render_fixture.h"

namespace svoscope::ui {
namespace {

/// The error of a window on that display; null: DISPLAY is not set.
Error errorOn(const char* name) {
  const char* display = std::getenv("DISPLAY");
  const std::string saved = display ? display : "";
  const char* wayland = std::getenv("WAYLAND_DISPLAY");
  const std::string saved_wayland = wayland ? wayland : "";
  unsetenv("DISPLAY");
  unsetenv("WAYLAND_DISPLAY");
  if (name) setenv("DISPLAY", name, 1);
  const auto surface = makeSurface(SurfaceKind::automatic, {320, 240}, 1);
  if (name) unsetenv("DISPLAY");
  if (display) setenv("DISPLAY", saved.c_str(), 1);
  if (wayland) setenv("WAYLAND_DISPLAY", saved_wayland.c_str(), 1);
  return surface.ok() ? Error{} : surface.error();
}

TEST(Surface, WithoutADisplayTheErrorSaysHowToGoOn) {
  for (const char* name : {static_cast<const char*>(nullptr), ":77"}) {
    const Error error = errorOn(name);
    EXPECT_EQ(error.kind, ErrorKind::usage);
    EXPECT_THAT(error.message(), testing::HasSubstr(name ? name : "DISPLAY is not set"));
    EXPECT_THAT(error.message(), testing::HasSubstr("--headless"));
    EXPECT_THAT(error.message(), testing::HasSubstr("xvfb-run"));
  }
}

TEST(Surface, TheNullSurfaceHasSizeAndScaleButNoGl) {
  const auto surface = makeSurface(SurfaceKind::null, {320, 240}, 1.5f);
  ASSERT_TRUE(surface.ok());
  EXPECT_EQ(surface.value()->getProcAddress("glClear"), nullptr);
  surface.value()->resize({640, 480});
  EXPECT_EQ(surface.value()->size().width, 640);
  EXPECT_EQ(surface.value()->scale(), 1.5f);
}

// Both kinds of content have to look the same; runs where there is a display (xvfb-run).
TEST(Surface, TheWindowShowsWhatOsmesaShows) {
  if (!std::getenv("DISPLAY")) GTEST_SKIP() << "no display";
  DrawFunction content([] {
    ImGui::SetNextWindowPos({10, 10});
    ImGui::Begin("window");
    ImGui::Button("Play");
    ImGui::End();
  });
  const auto picture = [&](SurfaceKind kind) {
    const std::unique_ptr<Host> host = openHost(kind, 320, 240);
    if (!host) return cv::Mat();
    host->driveByScript();  // the real mouse may be over the window
    for (int i = 0; i < 3; ++i) host->frame(content);
    return host->pixels().value();
  };
  const cv::Mat window = picture(SurfaceKind::window), offscreen = picture(SurfaceKind::osmesa);
  ASSERT_FALSE(window.empty()) << "the display refuses an OpenGL 3.3 window";
  if (offscreen.empty()) GTEST_SKIP() << "OSMesa is absent: install libosmesa6";
  ASSERT_EQ(window.size(), offscreen.size());
  EXPECT_LE(cv::norm(window, offscreen, cv::NORM_INF), 2);
}

}  // namespace
}  // namespace svoscope::ui
