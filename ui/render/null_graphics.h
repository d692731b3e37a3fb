// SPDX-License-Identifier: MIT
// Graphics without pixels: panels run their logic, nothing is rendered.
#pragma once

#include "ui/render/graphics.h"

namespace svoscope::ui {

class NullGraphics : public Graphics {
 public:
  ImTextureID image(std::uint32_t slot, const cv::Mat&, std::uint64_t, bool) override {
    return handle(slot);
  }
  ImTextureID scene(std::uint32_t slot, const Scene3&, int, int) override { return handle(slot); }

 private:
  // Any value but null, which panels may take for "no picture".
  static ImTextureID handle(std::uint32_t slot) {
    return reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(slot) + 1);
  }
};

}  // namespace svoscope::ui
