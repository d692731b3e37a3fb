// SPDX-License-Identifier: MIT
// The paths of all open runs and the ground truth as lines, rebuilt only when they change.
#pragma once

#include <optional>

#include "ui/panels/compare/compare_data.h"
#include "ui/render/graphics.h"

namespace svoscope::ui {

struct ComparePlace {
  Vec3f position;
  ImU32 color = 0;
};

class CompareScene {
 public:
  /// Paths up to frame `viewed`.
  void update(const CompareData& data, int viewed, bool grid);

  Scene3& scene() { return scene_; }
  Vec3 center() const { return center_; }
  double radius() const { return radius_; }
  double cell() const { return cell_; }  ///< grid spacing in the unit of the paths
  bool empty() const { return empty_; }
  /// Where each run is in the viewed frame, and the last good place before each loss until then.
  const std::vector<ComparePlace>& now() const { return now_; }
  const std::vector<ComparePlace>& losses() const { return losses_; }

 private:
  void measure(const CompareData& data);
  void addGrid();
  void addPath(const ComparedRun& run, int viewed);
  void addTruth(const std::vector<Vec3f>& path);
  void piece(const Vec3f& a, const Vec3f& b, ImU32 color, Dash dash, double& travelled);

  Scene3 scene_;
  std::vector<ComparePlace> now_, losses_;
  std::uint64_t data_version_ = 0;
  int viewed_ = -2;
  bool grid_ = false, empty_ = true;
  Vec3 center_ = Vec3::Zero();
  double radius_ = 1, floor_ = 0, cell_ = 1;
};

}  // namespace svoscope::ui
