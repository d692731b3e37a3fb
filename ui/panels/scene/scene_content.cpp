// SPDX-License-Identifier: MIT
#include "ui/panels/scene/scene_content.h"

#include <algorithm>
#include <cmath>

#include "engine/eval/estimate.h"
#include "ui/palette.h"
#include "ui/widgets/plot_math.h"

namespace svoscope::ui {

namespace {

int optionBits(const SceneOptions& o) {
  return static_cast<int>(o.color_by) | o.points << 4 | o.keyframes << 5 | o.estimate << 6 |
         o.ground_truth << 7 | o.seeds << 8 | o.grid << 9;
}

double quantile(std::vector<double>& values, double q) {
  if (values.empty()) return 0;
  const auto at = static_cast<std::size_t>(q * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(at), values.end());
  return values[at];
}

float valueOf(const MapPointView& p, PointColor by, const SE3& T_cam_world) {
  switch (by) {
    case PointColor::depth:
      return static_cast<float>((T_cam_world * p.position.cast<double>()).z());
    case PointColor::observations:
      return static_cast<float>(p.observations);
    case PointColor::sigma:
      return p.sigma;
    case PointColor::kind:
      break;
  }
  return 0;
}

ImU32 kindColor(FeatureType type) {
  switch (type) {
    case FeatureType::corner:
      return okabe::green;
    case FeatureType::edgelet:
      return okabe::purple;
    case FeatureType::segment:
      return okabe::orange;
  }
  return okabe::grey;
}

}  // namespace

void SceneContent::update(const SceneInput& input) {
  if (!input.snapshot) return;
  const Key key{input.snapshot->sequence_number, input.truth ? input.truth->version : 0,
                input.generation, optionBits(*input.options)};
  if (key == key_) return;
  key_ = key;
  ++scene_.version;
  scene_.lines.clear();
  scene_.points.clear();
  scene_.background = ink::canvas;
  measure(input);
  if (input.options->grid) addGrid();
  addPaths(input);
  if (input.options->keyframes) addKeyframes(input);
  if (input.options->points) addPoints(input);
  if (input.options->seeds) addSeeds(input);
  frustum(input.snapshot->record.T_world_cam, input.info->camera,
          static_cast<float>(radius_ * 0.09), ink::cursor);
}

void SceneContent::measure(const SceneInput& input) {
  std::vector<double> x, y, z;
  const auto add = [&](const Vec3& p) {
    if (!p.allFinite()) return;
    x.push_back(p.x());
    y.push_back(p.y());
    z.push_back(p.z());
  };
  if (input.snapshot->points) {
    for (const MapPointView& p : *input.snapshot->points) add(p.position.cast<double>());
  }
  for (const FrameRecord& r : *input.records) {
    if (hasPoseIn(r, input.snapshot->record.map_id)) add(r.T_world_cam.translation());
  }
  if (x.empty()) {  // before the start: a room of one map unit around the camera
    center_ = input.snapshot->record.T_world_cam.translation();
    radius_ = 1;
    floor_ = center_.y() + 0.5;
    cell_ = 0.2;
    return;
  }
  Vec3 lo, hi;  // a few wild points must not shrink the rest to a dot
  lo << quantile(x, 0.03), quantile(y, 0.03), quantile(z, 0.03);
  hi << quantile(x, 0.97), quantile(y, 0.97), quantile(z, 0.97);
  center_ = (lo + hi) / 2;
  radius_ = std::max(0.05, (hi - lo).norm() / 2);
  floor_ = hi.y();
  cell_ = niceStep(radius_ * 2, 10);
}

void SceneContent::line(const Vec3f& a, const Vec3f& b, ImU32 color) {
  scene_.lines.push_back({a, color});
  scene_.lines.push_back({b, color});
}

void SceneContent::addGrid() {
  // Snapped to its cells, so that it does not swim while the map grows.
  const int n = static_cast<int>(std::ceil(radius_ / cell_)) + 1;
  const double cx = std::round(center_.x() / cell_) * cell_;
  const double cz = std::round(center_.z() / cell_) * cell_;
  const double y = std::ceil(floor_ / cell_ * 2) * cell_ / 2;
  for (int i = -n; i <= n; ++i) {
    const auto f = [](double a, double b, double c) {
      return Vec3f(static_cast<float>(a), static_cast<float>(b), static_cast<float>(c));
    };
    const ImU32 color = i == 0 ? IM_COL32(58, 65, 76, 255) : IM_COL32(34, 38, 46, 255);
    line(f(cx + i * cell_, y, cz - n * cell_), f(cx + i * cell_, y, cz + n * cell_), color);
    line(f(cx - n * cell_, y, cz + i * cell_), f(cx + n * cell_, y, cz + i * cell_), color);
  }
}

void SceneContent::addPaths(const SceneInput& input) {
  const int map_id = input.snapshot->record.map_id;
  if (input.options->ground_truth && input.truth && input.truth->valid &&
      input.truth->map_id == map_id) {
    const auto& path = input.truth->path;
    // Dashed: every other piece, so that it differs from the estimate by more than colour.
    for (std::size_t i = 1; i < path.size(); ++i) {
      if ((i / 3) % 2 == 0) line(path[i - 1], path[i], ink::ground_truth);
    }
  }
  if (!input.options->estimate) return;
  const ImU32 color = methodColor(input.info->method);
  const FrameRecord* last = nullptr;
  for (const FrameRecord& r : *input.records) {
    if (r.index > input.snapshot->record.index) break;
    if (!hasPoseIn(r, map_id)) {  // other maps: in another world
      last = nullptr;
      continue;
    }
    if (last) {
      line(last->T_world_cam.translation().cast<float>(), r.T_world_cam.translation().cast<float>(),
           color);
    }
    last = &r;
  }
}

void SceneContent::frustum(const SE3& T_world_cam, const Pinhole& camera, float size, ImU32 color) {
  if (!T_world_cam.finite() || camera.width < 1 || camera.fx <= 0) return;
  const double d = size;
  const auto corner = [&](double u, double v) -> Vec3f {
    return (T_world_cam * Vec3(d * camera.unproject({u, v}))).cast<float>();
  };
  const double w = camera.width, h = camera.height;
  const Vec3f c = T_world_cam.translation().cast<float>();
  const Vec3f p[4] = {corner(0, 0), corner(w, 0), corner(w, h), corner(0, h)};
  for (int i = 0; i < 4; ++i) {
    line(c, p[i], color);
    line(p[i], p[(i + 1) % 4], color);
  }
  const Vec3f top = corner(w / 2, -h * 0.18);  // which side is up
  line(p[0], top, color);
  line(top, p[1], color);
}

void SceneContent::addKeyframes(const SceneInput& input) {
  if (!input.snapshot->keyframes) return;
  for (const KeyframeView& k : *input.snapshot->keyframes) {
    frustum(k.T_world_cam, input.info->camera, static_cast<float>(radius_ * 0.045),
            IM_COL32(66, 110, 142, 255));
  }
}

void SceneContent::addPoints(const SceneInput& input) {
  if (!input.snapshot->points) return;
  const PointColor by = input.options->color_by;
  const SE3 T_cam_world = input.snapshot->record.T_world_cam.inverse();
  const auto& points = *input.snapshot->points;
  std::vector<double> values;
  if (by != PointColor::kind) {
    for (const MapPointView& p : points) values.push_back(valueOf(p, by, T_cam_world));
  }
  const auto lo = static_cast<float>(quantile(values, 0.05)),
             hi = static_cast<float>(quantile(values, 0.95));
  color_range_ = {lo, hi};
  const float span = std::max(1e-9f, hi - lo);
  scene_.points.reserve(points.size());
  for (const MapPointView& p : points) {
    if (!p.position.allFinite()) continue;
    const ImU32 color = by == PointColor::kind
                            ? kindColor(p.type)
                            : viridis(0.12f + 0.88f * (valueOf(p, by, T_cam_world) - lo) / span);
    if (p.type == FeatureType::segment && p.position_end.allFinite()) {
      line(p.position, p.position_end, color);
      continue;
    }
    scene_.points.push_back({p.position, color});
  }
}

void SceneContent::addSeeds(const SceneInput& input) {
  if (!input.snapshot->seeds) return;
  for (const SeedView& s : *input.snapshot->seeds) {
    if (!s.position_near.allFinite() || !s.position_far.allFinite()) continue;
    // A far end near infinity would only draw a fan of rays across the view.
    const Vec3f along = s.position_far - s.position_near;
    const auto limit = static_cast<float>(radius_ * 1.5);
    const Vec3f far_end =
        along.norm() > limit ? Vec3f(s.position_near + along.normalized() * limit) : s.position_far;
    line(s.position_near, far_end, withAlpha(seedColor(s), 0.45f));
  }
}

}  // namespace svoscope::ui
