// SPDX-License-Identifier: MIT
#include "ui/render/image_texture.h"

#include "ui/render/gl_state.h"

namespace svoscope::ui {

void ImageTexture::update(const cv::Mat& pixels, std::uint64_t version, bool smooth) {
  const cv::Mat black(1, 1, CV_8UC1, cv::Scalar(0));
  const cv::Mat& source = pixels.empty() ? black : pixels;
  const bool same =
      filled_ && version == version_ && source.size() == size_ && source.type() == type_;
  if (same && smooth == smooth_) return;
  const GlStateGuard guard(*gl_);
  gl_->BindTexture(GL_TEXTURE_2D, texture_.id());
  if (!same) {
    upload(source);
    version_ = version;
  }
  setFilter(smooth);
  filled_ = true;
}

void ImageTexture::upload(const cv::Mat& pixels) {
  CV_Assert(pixels.type() == CV_8UC1 || pixels.type() == CV_8UC3);
  const bool grey = pixels.channels() == 1;
  const std::size_t pixel_bytes = pixels.elemSize();
  // GL counts row lengths in pixels; rows padded by a fraction of one are copied first.
  const cv::Mat source = pixels.step[0] % pixel_bytes == 0 ? pixels : pixels.clone();
  const GLint internal_format = grey ? GL_R8 : GL_RGB8;
  const GLenum format = grey ? GL_RED : GL_RGB;
  gl_->PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  gl_->PixelStorei(GL_UNPACK_ROW_LENGTH, static_cast<GLint>(source.step[0] / pixel_bytes));
  if (filled_ && source.size() == size_ && source.type() == type_) {
    gl_->TexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, source.cols, source.rows, format, GL_UNSIGNED_BYTE,
                       source.data);
  } else {
    gl_->TexImage2D(GL_TEXTURE_2D, 0, internal_format, source.cols, source.rows, 0, format,
                    GL_UNSIGNED_BYTE, source.data);
    const GLint as_grey[4] = {GL_RED, GL_RED, GL_RED, GL_ONE};
    const GLint as_is[4] = {GL_RED, GL_GREEN, GL_BLUE, GL_ONE};
    gl_->TexParameteriv(GL_TEXTURE_2D, GL_TEXTURE_SWIZZLE_RGBA, grey ? as_grey : as_is);
  }
  gl_->PixelStorei(GL_UNPACK_ROW_LENGTH, 0);
  size_ = source.size();
  type_ = source.type();
}

void ImageTexture::setFilter(bool smooth) {
  smooth_ = smooth;
  // Shrinking is always smooth; magnified pixels stay square unless asked otherwise.
  gl_->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  gl_->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, smooth ? GL_LINEAR : GL_NEAREST);
  gl_->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  gl_->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
}

}  // namespace svoscope::ui
