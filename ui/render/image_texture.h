// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <opencv2/core/mat.hpp>

#include "ui/render/gl_object.h"

namespace svoscope::ui {

/// Texture of a CV_8UC1 or CV_8UC3 (RGB) image with rows of any step.
class ImageTexture {
 public:
  explicit ImageTexture(const Gl& gl) : gl_(&gl), texture_(gl) {}
  /// Uploads only if the version, the size or the type changed.
  void update(const cv::Mat& pixels, std::uint64_t version, bool smooth);
  GLuint id() const { return texture_.id(); }

 private:
  void upload(const cv::Mat& pixels);
  void setFilter(bool smooth);

  const Gl* gl_;
  GlTexture texture_;
  bool filled_ = false, smooth_ = false;
  std::uint64_t version_ = 0;
  cv::Size size_;
  int type_ = -1;
};

}  // namespace svoscope::ui
