// SPDX-License-Identifier: MIT
// Graphics whose slots are moved out of the way of others: each run has textures of its own, so
// that equal version numbers of two runs are not taken for the same picture.
#pragma once

#include "ui/render/graphics.h"

namespace svoscope::ui {

class SlotGraphics : public Graphics {
 public:
  explicit SlotGraphics(Graphics& graphics) : graphics_(graphics) {}
  void setFirstSlot(std::uint32_t first) { first_ = first; }

  ImTextureID image(std::uint32_t slot, const cv::Mat& pixels, std::uint64_t version,
                    bool smooth) override {
    return graphics_.image(first_ + slot, pixels, version, smooth);
  }
  ImTextureID scene(std::uint32_t slot, const Scene3& scene, int width, int height) override {
    return graphics_.scene(first_ + slot, scene, width, height);
  }

 private:
  Graphics& graphics_;
  std::uint32_t first_ = 0;
};

}  // namespace svoscope::ui
