// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "ui/model/seed_trace.h"
#include "ui/palette.h"
#include "ui/panels/panel.h"
#include "ui/panels/panel_context.h"
#include "ui/panels/scene/scene_content.h"
#include "ui/panels/scene/scene_view.h"
#include "ui/theme.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/icons.h"
#include "ui/widgets/probe.h"

namespace svoscope::ui {

namespace {

constexpr std::uint32_t kSlot = 2;

void toolbar(PanelContext& c) {
  SceneOptions& o = c.state.scene;
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {grid(1), grid(1)});
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {grid(1.5f), grid(0.5f)});
  static const std::vector<const char*> colors{"Kind", "Depth", "Observations", "Sigma"};
  int by = static_cast<int>(o.color_by);
  if (combo("##point_color", by, colors, ImGui::GetFontSize() * 7.5f, "Colour of the points")) {
    o.color_by = static_cast<PointColor>(by);
  }
  sameLineIfFits(buttonWidth("Fit"));
  if (button("Fit", {"Show the whole map"})) {
    o.fitted = false;  // fitted below, where the panel's size is known
    o.follow = false;
  }
  sameLineIfFits(buttonWidth("Top"));
  if (button("Top", {"Look from above"})) topView(o);
  OptionBar bar(shortOfRoom());
  bar.item("Follow", o.follow, "Keep the camera in the middle (F)");
  bar.item("Points", o.points, "Map points");
  bar.item("Keyframes", o.keyframes, "Keyframe frustums");
  bar.item("Estimate", o.estimate, "Estimated trajectory");
  if (!c.info.ground_truth.empty()) {
    bar.item("Ground truth", o.ground_truth, "Ground truth, aligned to the estimate, dashed");
  }
  bar.item("Rays", o.seeds, "Seeds as rays from near to far");
  bar.item("Grid", o.grid, "Ground grid");
  ImGui::PopStyleVar(2);
}

// The map grows after the first look: fit again until the user moves the view.
void fitWhileUntouched(PanelContext& c, double aspect) {
  SceneOptions& o = c.state.scene;
  const int points = c.snapshot->points ? static_cast<int>(c.snapshot->points->size()) : 0;
  if (o.follow && c.record && c.record->pose_good) {
    o.target = c.record->T_world_cam.translation();
  } else if (!o.fitted) {
    fitScene(o, c.cache<SceneContent>().center(), c.cache<SceneContent>().radius(), aspect);
    o.fitted_points = points;
  }
}

// The density along the ray: pieces as strong as the Gaussian of the inverse distance there.
void drawBeliefRay(PanelContext& c, const SceneCamera& camera, const SeedView& seed, ImU32 color) {
  constexpr int kPieces = 8;
  const KeyframeView* keyframe = nullptr;
  if (c.snapshot->keyframes) {
    for (const KeyframeView& k : *c.snapshot->keyframes) {
      if (k.id == seed.keyframe_id) keyframe = &k;
    }
  }
  if (!keyframe || !(seed.sigma > 0) || !(seed.mu > 0) || !std::isfinite(seed.mu + seed.sigma))
    return;
  const Vec3 origin = keyframe->T_world_cam.translation();
  const Vec3 ray = seed.position.cast<double>() - origin;
  if (!ray.allFinite() || ray.norm() < 1e-9) return;
  // Beyond four times its distance a ray says no more than "far".
  const auto at = [&](double sigmas) {
    const double z = std::max(seed.mu + sigmas * seed.sigma, 0.25 * seed.mu);
    return camera.project(origin + ray.normalized() / z);
  };
  if (const auto from = camera.project(origin), to = at(2); from && to) {
    ImGui::GetWindowDrawList()->AddLine(*from, *to, withAlpha(color, 0.15f), dp(1));
  }
  for (int i = 0; i < kPieces; ++i) {
    const double lo = -2 + 4.0 * i / kPieces, hi = lo + 4.0 / kPieces, middle = (lo + hi) / 2;
    const auto a = at(lo), b = at(hi);
    if (!a || !b) continue;
    const auto strength = static_cast<float>(std::exp(-0.5 * middle * middle));
    ImGui::GetWindowDrawList()->AddLine(*a, *b, withAlpha(color, 0.15f + 0.85f * strength),
                                        dp(1 + 3.5f * strength));
  }
}

void drawSelected(PanelContext& c, const SceneCamera& camera) {
  const Selection& s = c.state.selection;
  if (s.kind == Selection::Kind::landmark) {
    if (const MapPointView* p = findPoint(*c.snapshot, s.id)) {
      circleAt(camera, p->position.cast<double>(), ink::selected);
    }
  } else if (s.kind == Selection::Kind::seed) {
    const SeedView* seed = findSeed(*c.snapshot, s.id);
    if (!seed) return;
    drawBeliefRay(c, camera, *seed, ink::selected);
    circleAt(camera, seed->position.cast<double>(), seedColor(*seed));
  }
}

void drawMarkedSeeds(PanelContext& c, const SceneCamera& camera) {
  if (!c.snapshot->seeds || (c.state.highlighted.empty() && c.state.seed.pinned.empty())) return;
  for (const SeedView& seed : *c.snapshot->seeds) {
    if (isPinned(c, seed.id)) {
      drawBeliefRay(c, camera, seed, ink::prior);
      circleAt(camera, seed.position.cast<double>(), ink::prior);
    } else if (c.state.highlighted.count(seed.id)) {
      const auto at = camera.project(seed.position.cast<double>());
      if (at)
        ImGui::GetWindowDrawList()->AddRect({at->x - dp(4), at->y - dp(4)},
                                            {at->x + dp(4), at->y + dp(4)}, ink::highlight, 0, 0,
                                            dp(1.5f));
    }
  }
}

void pickPoint(PanelContext& c, const SceneCamera& camera) {
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  float nearest = dp(10);
  Selection best;
  const auto consider = [&](const Vec3f& p, Selection candidate) {
    const auto at = camera.project(p.cast<double>());
    if (!at) return;
    const float d = std::hypot(at->x - mouse.x, at->y - mouse.y);
    if (d >= nearest) return;
    nearest = d;
    best = candidate;
  };
  if (c.state.scene.points && c.snapshot->points) {
    for (const MapPointView& p : *c.snapshot->points)
      consider(p.position, {Selection::Kind::landmark, p.id});
  }
  if (c.state.scene.seeds && c.snapshot->seeds) {
    for (const SeedView& s : *c.snapshot->seeds)
      consider(s.position, {Selection::Kind::seed, s.id});
  }
  c.state.selection = best;
}

// Positions are those of the newest keyframe; landmarks may have come or gone since.
std::string pointsText(const Snapshot& s) {
  const std::string text = format("%d points", static_cast<int>(s.points->size()));
  int newest = -1;
  if (s.keyframes) {
    for (const KeyframeView& k : *s.keyframes) newest = std::max(newest, k.id);
  }
  return newest < 0 ? text : text + format(", as of keyframe %d", newest);
}

void labels(PanelContext& c, const SceneCamera& camera) {
  ImDrawList* list = ImGui::GetWindowDrawList();
  const SceneContent& scene = c.cache<SceneContent>();
  ImVec2 at{camera.lo.x + grid(2), camera.lo.y + grid(1)};
  const auto entry = [&](Swatch kind, ImU32 color, const std::string& text) {
    sceneLegend(at, kind, color, text);
  };
  const SceneOptions& o = c.state.scene;
  const ImVec2 room{camera.hi.x - camera.lo.x, camera.hi.y - camera.lo.y};
  if (room.y < ImGui::GetFontSize() * 16 || room.x < ImGui::GetFontSize() * 22)
    return;  // the map matters more
  if (o.estimate) entry(Swatch::line, methodColor(c.info.method), methodName(c.info.method));
  const TruthState& truth = c.caches.truth.state();
  if (o.ground_truth && truth.valid) {
    const bool here = truth.map_id == c.snapshot->record.map_id;
    entry(Swatch::dashed, ink::ground_truth,
          here ? format("Ground truth, %s", alignmentLabel(truth.mode))
               : format("Ground truth: with map %d", truth.map_id));
  }
  if (o.points && c.snapshot->points) {
    const bool kind = o.color_by == PointColor::kind;
    int counts[3] = {};
    for (const MapPointView& p : *c.snapshot->points) ++counts[static_cast<int>(p.type)];
    entry(Swatch::dot, kind ? okabe::green : ink::dim, pointsText(*c.snapshot));
    if (kind && counts[1])
      entry(Swatch::dot, okabe::purple, format("%d of them edgelets", counts[1]));
    if (kind && counts[2])
      entry(Swatch::dot, okabe::orange, format("%d of them segments", counts[2]));
  }
  if (o.points && o.color_by != PointColor::kind) {
    const auto [lo, hi] = scene.colorRange();
    for (int i = 0; i < 24; ++i) {
      const float w = grid(1.5f), x = at.x + static_cast<float>(i) * w;
      list->AddRectFilled({x, at.y + 2}, {x + w, at.y + grid(2)},
                          viridis(0.12f + 0.88f * static_cast<float>(i) / 23));
    }
    const std::string text = format("%.3g – %.3g", lo, hi);
    outlinedText(list, {at.x + grid(38), at.y - 2}, ink::text, text.c_str());
  }
  if (!o.grid) return;
  const std::string text = format("grid %.3g %s", scene.cell(), "map units");
  outlinedText(list,
               {camera.hi.x - ImGui::CalcTextSize(text.c_str()).x - grid(2),
                camera.hi.y - ImGui::GetTextLineHeight() - grid(1)},
               ink::dim, text.c_str());
}

void draw(PanelContext& c) {
  toolbar(c);
  if (saysWhyEmpty(c)) return;
  SceneContent& content = c.cache<SceneContent>();
  content.update({c.snapshot.get(), &c.caches.run.records(), &c.caches.truth.state(), &c.info,
                  &c.state.scene, c.caches.run.generation()});
  fitWhileUntouched(c, sceneAspect());
  const SceneArea area = sceneArea("scene:view", c.state.scene);
  const SceneCamera& camera = area.camera;
  Scene3& scene = content.scene();
  scene.clip_from_world = camera.clip_from_world.cast<float>();
  scene.point_size_px = dp(c.state.scene.point_size);
  scene.line_width_px = dp(1.4f);
  const ImTextureID texture = c.graphics.scene(kSlot, scene, area.width(), area.height());
  ImGui::GetWindowDrawList()->PushClipRect(area.lo, area.hi, true);
  ImGui::GetWindowDrawList()->AddImage(texture, area.lo, area.hi);
  drawMarkedSeeds(c, camera);
  drawSelected(c, camera);
  drawGizmo(camera);
  labels(c, camera);
  ImGui::GetWindowDrawList()->PopClipRect();
  if (area.clicked) pickPoint(c, camera);
}

std::string csv(PanelContext& c) {
  if (!c.snapshot || !c.snapshot->points) return "";
  std::string text = "id,type,x,y,z,x_end,y_end,z_end,sigma,observations\n";
  for (const MapPointView& p : *c.snapshot->points) {
    text += format("%lld,%s,%.6g,%.6g,%.6g,", static_cast<long long>(p.id), featureTypeName(p.type),
                   p.position.x(), p.position.y(), p.position.z());
    const Vec3f& e = p.position_end;
    text += p.type == FeatureType::segment ? format("%.6g,%.6g,%.6g", e.x(), e.y(), e.z()) : ",,";
    text += format(",%.6g,%d\n", p.sigma, p.observations);
  }
  return text;
}

std::vector<PanelOption> scriptOptions() {
  const auto item = [](const char* name, auto field) {
    return stateOption(name, &UiState::scene, field);
  };
  using O = SceneOptions;
  return {item("scene.color_by", &O::color_by),
          item("scene.points", &O::points),
          item("scene.keyframes", &O::keyframes),
          item("scene.estimate", &O::estimate),
          item("scene.ground_truth", &O::ground_truth),
          item("scene.seeds", &O::seeds),
          item("scene.grid", &O::grid),
          item("scene.follow", &O::follow),
          item("scene.point_size", &O::point_size),
          item("scene.distance", &O::distance),
          item("scene.yaw", &O::yaw),
          item("scene.pitch", &O::pitch)};
}

}  // namespace

extern const Panel kScenePanel{"3-D", draw, csv, /*charts=*/false, scriptOptions};

}  // namespace svoscope::ui
