// SPDX-License-Identifier: MIT
// What the user looks at and how: plain values that panels read and write. One selection, one
// viewed frame, shared by all panels.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>

#include "ui/layout.h"
#include "ui/widgets/image_view.h"
#include "ui/widgets/plot.h"
#include "ui/widgets/toasts.h"

namespace svoscope::ui {

struct Selection {
  enum class Kind : std::uint8_t { none, landmark, seed, track };
  Kind kind = Kind::none;
  std::int64_t id = -1;

  explicit operator bool() const { return kind != Kind::none; }
  bool operator==(const Selection& o) const { return kind == o.kind && id == o.id; }
  bool operator!=(const Selection& o) const { return !(*this == o); }
};

enum class ColorBy : int { origin, status, depth, observations, residual, level };

struct ImageOptions {
  ImageViewState view;
  int level = 0;
  ColorBy color_by = ColorBy::origin;
  bool corners = true, edgelets = true, segments = true;
  bool outliers = true, not_aligned = false;
  bool residuals = true, predicted = false, ids = false, trails = true;
  bool seeds = true, spans = true, tracks = true;
  float residual_scale = 5;
  int trail_frames = 12;
};

enum class PointColor : int { kind, depth, observations, sigma };

struct SceneOptions {
  PointColor color_by = PointColor::kind;
  bool points = true, keyframes = true, estimate = true, ground_truth = true, seeds = false;
  bool grid = true;
  bool follow = false;
  float point_size = 2.5f;
  Vec3 target = Vec3::Zero();
  double distance = 6, yaw = 0.55, pitch = 0.45;
  bool fitted = false;  ///< the view was fitted to the map, or moved by the user
  int fitted_points = 0;
};

struct UiState {
  int viewed_frame = -1;  ///< -1: live, follows the engine
  Selection selection;
  ImageOptions image;
  SceneOptions scene;
  LinkedX linked_x;       ///< of all plots over frames
  std::map<std::string, PlotState> plots;
  std::set<std::string> plot_groups{"Features", "Time", "Error"};
  Layout layout = presetLayout("Tracking");
  std::string maximized;  ///< panel title, or empty
  bool show_help = false;
  bool show_transport = true, show_status = true;
  float ui_scale = 1;
  float image_fit = 1;    ///< zoom at which the image fits its panel, for the zoom keys
  int speed = 0;          ///< index into the transport's speeds
  int run_to = 100;       ///< frame typed for "Run to frame"
  int align_mode = 2;     ///< none, SE(3), Sim(3)
  std::string log_filter, parameter_filter;
  std::string output_folder = ".";  ///< of exports and screenshots
  Toasts toasts;
  std::optional<std::string> screenshot;
  bool close = false;
};

}  // namespace svoscope::ui
