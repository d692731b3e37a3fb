// SPDX-License-Identifier: MIT
// Surfaces without a display: OSMesa for pixels, null for logic. Time runs by frames and the mouse
// is nowhere until a script moves it, so every run is the same.
#pragma once

#include <memory>

#include "ui/surface/surface.h"

namespace svoscope::ui {

class NullSurface : public Surface {
 public:
  NullSurface(SurfaceSize size, float scale) : size_(size), scale_(scale) {}
  SurfaceKind kind() const override { return SurfaceKind::null; }
  SurfaceSize size() const override { return size_; }
  float scale() const override { return scale_; }
  void resize(SurfaceSize size) override { size_ = size; }
  void setScale(float scale) override { scale_ = scale; }
  Status makeCurrent() override { return Done{}; }
  GlProc getProcAddress(const char*) override { return nullptr; }
  void beginFrame(ImGuiIO& io) override;

 private:
  SurfaceSize size_;
  float scale_;
};

/// Fails with the package's name if libOSMesa is absent.
Result<std::unique_ptr<Surface>> makeOsmesaSurface(SurfaceSize size, float scale);

}  // namespace svoscope::ui
