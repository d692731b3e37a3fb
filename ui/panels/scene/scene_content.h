// SPDX-License-Identifier: MIT
// The 3-D view's vertices, rebuilt only when what they show changes.
#pragma once

#include <utility>
#include <vector>

#include "engine/snapshot/snapshot.h"
#include "ui/model/truth.h"
#include "ui/model/ui_state.h"
#include "ui/render/graphics.h"

namespace svoscope::ui {

struct SceneInput {
  const Snapshot* snapshot = nullptr;
  const std::vector<FrameRecord>* records = nullptr;
  const TruthState* truth = nullptr;
  const RunInfo* info = nullptr;
  const SceneOptions* options = nullptr;
  int generation = 0;
};

class SceneContent {
 public:
  /// Rebuilds scene().lines and .points and raises its version if anything shown changed.
  void update(const SceneInput& input);

  Scene3& scene() { return scene_; }
  const Scene3& scene() const { return scene_; }
  double cell() const { return cell_; }  ///< grid spacing, map units
  std::pair<float, float> colorRange() const { return color_range_; }
  /// Centre and radius of the map, outliers left out.
  Vec3 center() const { return center_; }
  double radius() const { return radius_; }

 private:
  struct Key {
    std::uint64_t sequence = 0, truth = 0;
    int generation = -1, options = 0;
    bool operator==(const Key& o) const {
      return sequence == o.sequence && truth == o.truth && generation == o.generation &&
             options == o.options;
    }
  };
  void measure(const SceneInput& input);
  void addGrid();
  void addPaths(const SceneInput& input);
  void addKeyframes(const SceneInput& input);
  void addPoints(const SceneInput& input);
  void addSeeds(const SceneInput& input);
  void line(const Vec3f& a, const Vec3f& b, ImU32 color);
  void frustum(const SE3& T_world_cam, const Pinhole& camera, float size, ImU32 color);

  Scene3 scene_;
  Key key_;
  Vec3 center_ = Vec3::Zero();
  double radius_ = 1, floor_ = 0.5, cell_ = 1;
  std::pair<float, float> color_range_{0, 1};
};

}  // namespace svoscope::ui
