// SPDX-License-Identifier: MIT
// Where the UI appears: a window, memory rendered by OSMesa, or nowhere. The host draws the same
// picture on each; only the window knows a display.
#pragma once

#include <imgui/imgui.h>

#include <memory>
#include <string>
#include <vector>

#include "engine/base/result.h"
#include "ui/render/gl.h"

namespace svoscope::ui {

enum class SurfaceKind {
  automatic,  ///< a window, or an error that says how to go without
  window,
  osmesa,  ///< pixels without display or GPU
  null,    ///< no pixels: logic only
};

struct SurfaceSize {
  int width = 1600, height = 1000;  ///< pixels
};

class Surface {
 public:
  virtual ~Surface() = default;

  virtual SurfaceKind kind() const = 0;
  virtual SurfaceSize size() const = 0;
  /// Sizes of fonts and widgets relative to a 96 dpi screen.
  virtual float scale() const = 0;
  virtual void resize(SurfaceSize size) = 0;
  virtual void setScale(float scale) = 0;

  virtual Status makeCurrent() = 0;
  /// Null for everything on the null surface.
  virtual GlProc getProcAddress(const char* name) = 0;

  /// Writes display size, time step and input into io; before ImGui::NewFrame.
  virtual void beginFrame(ImGuiIO& io) = 0;
  /// Shows what was blitted to framebuffer 0. Nothing to do without a window.
  virtual void present() {}
  /// Sleeps until there is input, at most that long. At once without a window.
  virtual void waitForInput(double seconds) { (void)seconds; }
  /// Input arrived since the last beginFrame.
  virtual bool inputPending() const { return false; }

  virtual bool shouldClose() const { return false; }
  virtual void setTitle(const std::string& title) { (void)title; }
  virtual std::vector<std::string> takeDroppedFiles() { return {}; }
  virtual std::string clipboard() { return clipboard_; }
  virtual void setClipboard(const std::string& text) { clipboard_ = text; }

 private:
  std::string clipboard_;  // headless runs copy and paste among themselves
};

/// Opens a surface of `size` pixels. A window's scale is the screen's times `scale`.
Result<std::unique_ptr<Surface>> makeSurface(SurfaceKind kind, SurfaceSize size, float scale);

}  // namespace svoscope::ui
