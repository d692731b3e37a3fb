// SPDX-License-Identifier: MIT
#include "ui/panels/compare/compare_scene.h"

#include <algorithm>
#include <cmath>

#include "ui/palette.h"
#include "ui/widgets/plot_math.h"

namespace svoscope::ui {

namespace {

// Dashes as parts of the radius of the whole: the same on any scale.
constexpr double kDash = 0.03, kDot = 0.008;

}  // namespace

void CompareScene::update(const CompareData& data, int viewed, bool grid) {
  if (data.version() == data_version_ && viewed == viewed_ && grid == grid_) return;
  data_version_ = data.version();
  viewed_ = viewed;
  grid_ = grid;
  ++scene_.version;
  scene_.background = ink::canvas;
  scene_.lines.clear();
  now_.clear();
  losses_.clear();
  measure(data);
  if (empty_) return;
  if (grid) addGrid();
  addTruth(data.truthPath());
  for (const ComparedRun& run : data.runs()) addPath(run, viewed);
}

void CompareScene::measure(const CompareData& data) {
  Vec3f lo = Vec3f::Constant(1e30f), hi = Vec3f::Constant(-1e30f);
  const auto add = [&](const Vec3f& p) {
    if (!p.allFinite()) return;
    lo = lo.cwiseMin(p);
    hi = hi.cwiseMax(p);
  };
  for (const Vec3f& p : data.truthPath()) add(p);
  // With ground truth, a run that went astray does not shrink the rest to a dot.
  if (data.truthPath().empty()) {
    for (const ComparedRun& run : data.runs()) {
      for (const Vec3f& p : run.path) add(p);
    }
  }
  empty_ = lo.x() > hi.x() || std::none_of(data.runs().begin(), data.runs().end(),
                                           [](const ComparedRun& r) { return r.aligned; });
  if (empty_) return;
  center_ = ((lo + hi) / 2).cast<double>();
  radius_ = std::max(1e-3, 0.5 * (hi - lo).cast<double>().norm());
  floor_ = hi.y() + 0.1 * radius_;
  cell_ = niceStep(radius_ * 2, 10);
}

void CompareScene::addGrid() {
  const int n = static_cast<int>(std::ceil(radius_ / cell_)) + 1;
  const double cx = std::round(center_.x() / cell_) * cell_,
               cz = std::round(center_.z() / cell_) * cell_;
  const auto at = [&](double x, double z) { return Vec3(x, floor_, z).cast<float>().eval(); };
  for (int i = -n; i <= n; ++i) {
    const ImU32 color = i == 0 ? IM_COL32(58, 65, 76, 255) : IM_COL32(34, 38, 46, 255);
    scene_.lines.push_back({at(cx + i * cell_, cz - n * cell_), color});
    scene_.lines.push_back({at(cx + i * cell_, cz + n * cell_), color});
    scene_.lines.push_back({at(cx - n * cell_, cz + i * cell_), color});
    scene_.lines.push_back({at(cx + n * cell_, cz + i * cell_), color});
  }
}

void CompareScene::piece(const Vec3f& a, const Vec3f& b, ImU32 color, Dash dash,
                         double& travelled) {
  const double length = (b - a).norm(), unit = (dash == Dash::dotted ? kDot : kDash) * radius_;
  const bool drawn = dash == Dash::solid || std::fmod(travelled / unit, 2.0) < 1.2;
  travelled += length;
  if (!drawn) return;
  scene_.lines.push_back({a, color});
  scene_.lines.push_back({b, color});
}

void CompareScene::addTruth(const std::vector<Vec3f>& path) {
  double travelled = 0;
  for (std::size_t i = 1; i < path.size(); ++i) {
    piece(path[i - 1], path[i], ink::ground_truth, Dash::dashed, travelled);
  }
}

void CompareScene::addPath(const ComparedRun& run, int viewed) {
  const Vec3f* last = nullptr;
  double travelled = 0;
  std::size_t loss = 0;
  for (std::size_t i = 0; i < run.path.size() && run.frames[i] <= static_cast<float>(viewed); ++i) {
    const bool lost_here = loss < run.losses.size() && run.losses[loss] == static_cast<int>(i);
    if (lost_here) ++loss;
    if (lost_here && last) losses_.push_back({*last, run.style.color});
    const Vec3f& p = run.path[i];
    const bool good = p.allFinite();
    // A trajectory may have fewer poses than the sequence frames: its line goes on.
    if (!good) {
      if (!run.style.poses_only) last = nullptr;
      continue;
    }
    if (last) piece(*last, p, run.style.color, run.style.dash, travelled);
    last = &p;
  }
  const int row = rowOf(run.frames, viewed);
  if (row >= 0 && run.path[static_cast<std::size_t>(row)].allFinite()) {
    now_.push_back({run.path[static_cast<std::size_t>(row)], run.style.color});
  }
}

}  // namespace svoscope::ui
