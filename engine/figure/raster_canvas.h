// SPDX-License-Identifier: MIT
#pragma once

#include <opencv2/core/mat.hpp>

#include "engine/figure/canvas.h"

namespace svoscope {

/// Draws into an image by OpenCV, in the colours of kSvgStyle on light ground. Texts are ASCII.
class RasterCanvas : public Canvas {
 public:
  /// `image`: CV_8UC3, the pixels are shared; `scale` pixels to a px of the figure.
  RasterCanvas(const cv::Mat& image, double scale);

  void line(FigurePoint a, FigurePoint b, const Stroke& stroke) override;
  void polyline(const std::vector<FigurePoint>& points, const Stroke& stroke) override;
  void rect(FigurePoint corner, double width, double height, const Stroke& stroke) override;
  void circle(FigurePoint centre, double radius, const Stroke& stroke) override;
  void cross(FigurePoint centre, double radius, const Stroke& stroke) override;
  void text(FigurePoint at, const std::string& text, TextAnchor anchor, TextInk ink) override;
  void turnedText(FigurePoint at, const std::string& text, TextInk ink) override;
  void beginClip(FigurePoint corner, double width, double height) override;
  void endClip() override;

 private:
  void segment(cv::Point2d a, cv::Point2d b, const Stroke& stroke);
  cv::Point2d pixel(FigurePoint p) const;

  cv::Mat image_;   ///< all of it
  cv::Mat target_;  ///< the part inside the clip
  cv::Point origin_;
  double scale_;
};

}  // namespace svoscope
