// SPDX-License-Identifier: MIT
#include "engine/detect/segment_detector.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "engine/base/angle.h"
#include "engine/detect/feature_detector.h"
#include "engine/geometry/segment.h"

namespace svoscope {

namespace {

constexpr double kLsdScale = 0.8;  // the detector's own reduction against stairs in slanted edges
// OpenCV's detector maps its reduced image back without regard to pixel centres.
constexpr double kLsdShift = 0.5 / kLsdScale - 0.5;

bool longer(const DetectedSegment& a, const DetectedSegment& b) { return a.length() > b.length(); }

/// Whether `b` continues the longer segment `a`; same direction, so same polarity.
bool continues(const DetectedSegment& a, const DetectedSegment& b,
               const SegmentDetectorParameters& p) {
  const Vec2 da = (a.px[1] - a.px[0]).normalized(), db = (b.px[1] - b.px[0]).normalized();
  if (da.dot(db) < std::cos(p.merge_angle_deg * kDegree)) return false;
  const ImageLine line = lineThrough(a.px[0], a.px[1]);
  if (std::abs(line.distance(b.px[0])) > p.merge_distance_px ||
      std::abs(line.distance(b.px[1])) > p.merge_distance_px)
    return false;
  const double s0 = da.dot(b.px[0] - a.px[0]), s1 = da.dot(b.px[1] - a.px[0]);
  return std::max(s0 - a.length(), -s1) <= p.merge_gap_px;
}

/// Line through both, fitted by length-weighted moments of the pieces.
DetectedSegment joined(const DetectedSegment& a, const DetectedSegment& b) {
  const double la = a.length(), lb = b.length();
  const Vec2 mean = (la * 0.5 * (a.px[0] + a.px[1]) + lb * 0.5 * (b.px[0] + b.px[1])) / (la + lb);
  Mat2 S = Mat2::Zero();
  for (const DetectedSegment* s : {&a, &b}) {
    const double l = s->length();
    const Vec2 d = s->px[1] - s->px[0], c = 0.5 * (s->px[0] + s->px[1]) - mean;
    S += l * (d * d.transpose() / 12.0 + c * c.transpose());
  }
  const double angle = 0.5 * std::atan2(2 * S(0, 1), S(0, 0) - S(1, 1));
  Vec2 d(std::cos(angle), std::sin(angle));
  if (d.dot(a.px[1] - a.px[0]) < 0) d = -d;
  double lo = 1e30, hi = -1e30;
  for (const Vec2& px : {a.px[0], a.px[1], b.px[0], b.px[1]}) {
    lo = std::min(lo, d.dot(px - mean));
    hi = std::max(hi, d.dot(px - mean));
  }
  DetectedSegment out;
  out.px[0] = mean + lo * d;
  out.px[1] = mean + hi * d;
  return out;
}

std::vector<DetectedSegment> runDetector(const cv::Mat& image, int level) {
  std::vector<cv::Vec4f> lines;
  cv::createLineSegmentDetector(cv::LSD_REFINE_STD, kLsdScale)->detect(image, lines);
  std::vector<DetectedSegment> segments;
  segments.reserve(lines.size());
  const Vec2 shift(kLsdShift, kLsdShift);
  for (const cv::Vec4f& l : lines) {
    DetectedSegment s;
    s.px[0] = fromLevel(Vec2(l[0], l[1]) + shift, level);
    s.px[1] = fromLevel(Vec2(l[2], l[3]) + shift, level);
    segments.push_back(s);
  }
  return segments;
}

/// Part of a segment that keeps clear of the border; false if there is none.
bool trimToImage(const cv::Mat& image, double border, DetectedSegment& s) {
  double t0 = 0, t1 = 1;
  const Vec2 d = s.px[1] - s.px[0];
  const double limits[2] = {image.cols - 1 - border, image.rows - 1 - border};
  for (int axis = 0; axis < 2; ++axis) {
    const double x0 = s.px[0][axis], dx = d[axis];
    if (std::abs(dx) < 1e-9) {
      if (x0 < border || x0 > limits[axis]) return false;
      continue;
    }
    const double a = (border - x0) / dx, b = (limits[axis] - x0) / dx;
    t0 = std::max(t0, std::min(a, b));
    t1 = std::min(t1, std::max(a, b));
  }
  if (t0 >= t1) return false;
  const Vec2 start = s.px[0];
  s.px[0] = start + t0 * d;
  s.px[1] = start + t1 * d;
  return true;
}

}  // namespace

std::vector<DetectedSegment> mergeCollinear(std::vector<DetectedSegment> segments,
                                            const SegmentDetectorParameters& p) {
  std::stable_sort(segments.begin(), segments.end(), longer);
  // A joined segment reaches further and may meet another piece: until nothing changes.
  for (bool changed = true; changed;) {
    changed = false;
    for (std::size_t i = 0; i < segments.size(); ++i) {
      for (std::size_t j = i + 1; j < segments.size();) {
        if (!continues(segments[i], segments[j], p)) {
          ++j;
          continue;
        }
        segments[i] = joined(segments[i], segments[j]);
        segments.erase(segments.begin() + static_cast<std::ptrdiff_t>(j));
        changed = true;
      }
    }
    std::stable_sort(segments.begin(), segments.end(), longer);
  }
  return segments;
}

std::vector<DetectedSegment> detectSegments(const Pyramid& pyramid,
                                            const SegmentDetectorParameters& p,
                                            const std::vector<DetectedSegment>& tracked) {
  const int level = std::min<int>(p.level, static_cast<int>(pyramid.size()) - 1);
  const cv::Mat& image = pyramid.front();
  const double least = p.min_length_px * image.cols / 640.0;
  std::vector<DetectedSegment> raw = runDetector(pyramid[level], level);
  // Short pieces are joined too, but what is far too short only costs time.
  raw.erase(std::remove_if(raw.begin(), raw.end(),
                           [&](const auto& s) { return s.length() < 0.3 * least; }),
            raw.end());
  OccupancyGrid grid(image.cols, image.rows, scaledCell(p.cell_px, image.cols));
  std::vector<int> count(static_cast<std::size_t>(grid.cells()), 0);
  const auto middle = [](const DetectedSegment& s) { return Vec2(0.5 * (s.px[0] + s.px[1])); };
  for (const DetectedSegment& s : tracked)
    ++count[static_cast<std::size_t>(grid.cellOf(middle(s)))];
  std::vector<DetectedSegment> kept;
  for (DetectedSegment& s : mergeCollinear(std::move(raw), p)) {
    if (static_cast<int>(kept.size() + tracked.size()) >= p.max_segments) break;
    if (!trimToImage(image, 8, s) || s.length() < least) continue;
    int& in_cell = count[static_cast<std::size_t>(grid.cellOf(middle(s)))];
    if (in_cell >= p.per_cell) continue;
    const auto repeats = [&](const DetectedSegment& o) {
      return sameEdge(s.px, o.px, 8, p.separation_px, 0.3);
    };
    if (std::any_of(kept.begin(), kept.end(), repeats) ||
        std::any_of(tracked.begin(), tracked.end(), repeats))
      continue;
    ++in_cell;
    kept.push_back(s);
  }
  return kept;
}

}  // namespace svoscope
