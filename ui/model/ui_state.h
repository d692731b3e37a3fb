// SPDX-License-Identifier: MIT
// What the user looks at and how: plain values that panels read and write. One selection, one
// viewed frame, shared by all panels. What a single panel alone needs it keeps in `options`.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "ui/layout.h"
#include "ui/model/typed_store.h"
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

enum class SeedColorBy : int { status, sigma, inlier_ratio, age, disagreement };

struct ImageOptions {
  ImageViewState view;
  int level = 0;
  ColorBy color_by = ColorBy::origin;
  SeedColorBy seed_color = SeedColorBy::status;
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

/// The seed panels: which update is looked at, which seeds are kept in view.
struct SeedOptions {
  bool distance = false;      ///< densities over distance, else over inverse distance
  bool image_follows = true;  ///< stepping through updates shows the frame that was searched
  int update = -1;            ///< index into the held updates; -1: the last one at the viewed frame
  int update_frame = -1;      ///< viewed frame that `update` was chosen at; another one frees it
  std::int64_t update_seed = -1;
  int shown_update = 0, held_updates = 0;  ///< what the panels show: from 1, and of how many
  int step_request = 0;                    ///< updates to step by, from a key
  bool whole_range = false;                ///< densities from 0 to the range, else about the belief
  std::vector<std::int64_t> pinned;
  bool profile_in_pixels = false;
};

/// Place on the epipolar line under the mouse in the score profile; drawn in the image.
struct SearchHover {
  bool fresh = false;  ///< set in this UI frame
  bool on = false;
  int frame = -1;
  Eigen::Vector2f px = Eigen::Vector2f::Zero();
};

/// The epipolar line of the update looked at; drawn in the image of its frame.
struct SearchLine {
  bool fresh = false;  ///< set in this UI frame
  int frame = -1;
  Eigen::Vector2f near_px = Eigen::Vector2f::Zero(), far_px = Eigen::Vector2f::Zero();
  Eigen::Vector2f match_px = Eigen::Vector2f::Zero();
  bool matched = false;
};

/// A panel to be written into a file; CSV and SVG by the inspector, PNG by who has the pixels.
struct ExportRequest {
  std::string panel, file;
  bool quiet = false;  ///< by a script: no message over its pictures
  bool fresh = true;   ///< the panels had no frame yet to draw themselves
};

struct UiState {
  int viewed_frame = -1;  ///< -1: live, follows the engine
  Selection selection;
  ImageOptions image;
  SceneOptions scene;
  SeedOptions seed;
  SearchHover search_hover;
  SearchLine search_line;
  TypedStore options;                  ///< of single panels, for the window
  TypedStore run_options;              ///< of single panels, for the current run
  int run_request = -1;                ///< run to become the current one in the next UI frame
  std::set<std::int64_t> highlighted;  ///< seeds, by a brush
  LinkedX linked_x;                    ///< of all plots over frames
  std::map<std::string, PlotState> plots;
  Layout layout = presetLayout("Tracking");
  std::string maximized;  ///< panel title, or empty
  bool show_help = false;
  bool show_transport = true, show_status = true;
  float ui_scale = 1;
  float image_fit = 1;              ///< zoom at which the image fits its panel, for the zoom keys
  int align_mode = 2;               ///< none, SE(3), Sim(3)
  std::string output_folder = ".";  ///< of exports and screenshots
  Toasts toasts;
  std::optional<std::string> screenshot;
  std::optional<ExportRequest> export_request;   ///< CSV or SVG, done in the next UI frame
  std::optional<ExportRequest> picture_request;  ///< PNG
  int picture_delay = 0;                         ///< UI frames until then: a menu must have gone
  std::string export_menu;                       ///< panel whose export menu is open
  std::string export_error;                      ///< of the last export; empty: it was written
  bool close = false;
};

}  // namespace svoscope::ui
