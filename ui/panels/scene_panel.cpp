// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "ui/palette.h"
#include "ui/panels/panel_context.h"
#include "ui/panels/scene_camera.h"
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

void navigate(SceneOptions& o, const SceneCamera& camera, bool hovered, bool active) {
  const ImGuiIO& io = ImGui::GetIO();
  if (hovered && io.MouseWheel != 0) {
    o.distance = std::clamp(o.distance * std::pow(0.87, io.MouseWheel), 1e-3, 1e6);
    o.fitted = true;
  }
  if (!active) return;
  const bool panning = ImGui::IsMouseDown(1) || ImGui::IsMouseDown(2) || io.KeyShift;
  if (io.MouseDelta.x == 0 && io.MouseDelta.y == 0) return;
  if (panning) {
    const double k = o.distance * 0.9 / std::max(1.0f, camera.hi.y - camera.lo.y);
    o.target += k * (-io.MouseDelta.x * camera.right + io.MouseDelta.y * camera.up);
    o.follow = false;
  } else if (ImGui::IsMouseDragging(0, 3)) {
    o.yaw -= io.MouseDelta.x * 0.006;
    o.pitch = std::clamp(o.pitch + io.MouseDelta.y * 0.006, -1.5707, 1.5707);
  }
  o.fitted = true;
}

// The map grows after the first look: fit again until the user moves the view.
void fitWhileUntouched(PanelContext& c, double aspect) {
  SceneOptions& o = c.state.scene;
  const int points = c.snapshot->points ? static_cast<int>(c.snapshot->points->size()) : 0;
  if (o.follow && c.record && c.record->pose_good) {
    o.target = c.record->T_world_cam.translation();
  } else if (!o.fitted) {
    fitScene(o, c.caches.scene.center(), c.caches.scene.radius(), aspect);
    o.fitted_points = points;
  }
}

void gizmo(const SceneCamera& camera) {
  const float r = grid(6);
  if (camera.hi.y - camera.lo.y < 5 * r) return;
  const ImVec2 o{camera.lo.x + r + grid(2), camera.hi.y - r - grid(2)};
  struct AxisInk {
    Vec3 direction;
    ImU32 color;
    const char* name;
  };
  const AxisInk axes[] = {{Vec3::UnitX(), okabe::vermillion, "x"},
                          {Vec3::UnitY(), okabe::green, "y"},
                          {Vec3::UnitZ(), okabe::sky, "z"}};
  ImDrawList* list = ImGui::GetWindowDrawList();
  for (const AxisInk& a : axes) {
    const auto x = static_cast<float>(a.direction.dot(camera.right));
    const auto y = static_cast<float>(-a.direction.dot(camera.up));
    const ImVec2 e{o.x + x * r * 0.8f, o.y + y * r * 0.8f};
    list->AddLine(o, e, a.color, dp(2));
    outlinedText(list, {e.x + x * grid(1.5f) - grid(0.75f), e.y + y * grid(1.5f) - ImGui::GetFontSize() / 2},
                 a.color, a.name);
  }
}

void circleAt(const SceneCamera& camera, const Vec3& p, ImU32 color) {
  const auto at = camera.project(p);
  if (!at) return;
  ImGui::GetWindowDrawList()->AddCircle(*at, dp(7), IM_COL32(0, 0, 0, 180), 20, dp(4));
  ImGui::GetWindowDrawList()->AddCircle(*at, dp(7), color, 20, dp(2));
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
  if (!keyframe || !(seed.sigma > 0) || !(seed.mu > 0) || !std::isfinite(seed.mu + seed.sigma)) return;
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
    ImGui::GetWindowDrawList()->AddLine(*a, *b, withAlpha(color, 0.15f + 0.85f * strength), dp(1 + 3.5f * strength));
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
      if (at) ImGui::GetWindowDrawList()->AddRect({at->x - dp(4), at->y - dp(4)}, {at->x + dp(4), at->y + dp(4)}, ink::highlight, 0, 0, dp(1.5f));
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
    for (const MapPointView& p : *c.snapshot->points) consider(p.position, {Selection::Kind::landmark, p.id});
  }
  if (c.state.scene.seeds && c.snapshot->seeds) {
    for (const SeedView& s : *c.snapshot->seeds) consider(s.position, {Selection::Kind::seed, s.id});
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
  const SceneContent& scene = c.caches.scene;
  ImVec2 at{camera.lo.x + grid(2), camera.lo.y + grid(1)};
  const auto entry = [&](Swatch kind, ImU32 color, const std::string& text) {
    const float width = ImGui::CalcTextSize(text.c_str()).x, line = ImGui::GetTextLineHeight() + grid(0.5f);
    list->AddRectFilled({at.x - grid(1), at.y}, {at.x + grid(5) + width, at.y + line}, IM_COL32(0, 0, 0, 110));
    drawSwatch(kind, {at.x + grid(1.5f), at.y + ImGui::GetTextLineHeight() / 2}, grid(1), color);
    list->AddText({at.x + grid(4), at.y}, ink::text, text.c_str());
    at.y += line;
  };
  const SceneOptions& o = c.state.scene;
  const ImVec2 room{camera.hi.x - camera.lo.x, camera.hi.y - camera.lo.y};
  if (room.y < ImGui::GetFontSize() * 16 || room.x < ImGui::GetFontSize() * 22) return;  // the map matters more
  if (o.estimate) entry(Swatch::line, methodColor(c.info.method), methodName(c.info.method));
  const TruthState& truth = c.caches.truth.state();
  if (o.ground_truth && truth.valid) {
    entry(Swatch::dashed, ink::ground_truth, format("Ground truth, %s", alignModeName(truth.mode)));
  }
  if (o.points && c.snapshot->points) {
    const bool kind = o.color_by == PointColor::kind;
    int counts[3] = {};
    for (const MapPointView& p : *c.snapshot->points) ++counts[static_cast<int>(p.type)];
    entry(Swatch::dot, kind ? okabe::green : ink::dim, pointsText(*c.snapshot));
    if (kind && counts[1]) entry(Swatch::dot, okabe::purple, format("%d of them edgelets", counts[1]));
    if (kind && counts[2]) entry(Swatch::dot, okabe::orange, format("%d of them segments", counts[2]));
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
  outlinedText(list, {camera.hi.x - ImGui::CalcTextSize(text.c_str()).x - grid(2),
                      camera.hi.y - ImGui::GetTextLineHeight() - grid(1)}, ink::dim, text.c_str());
}

}  // namespace

void drawScenePanel(PanelContext& c) {
  toolbar(c);
  if (saysWhyEmpty(c)) return;
  SceneContent& content = c.caches.scene;
  content.update({c.snapshot.get(), &c.caches.run.records(), &c.caches.truth.state(), &c.info,
                  &c.state.scene, c.caches.run.generation()});
  const ImVec2 avail = ImGui::GetContentRegionAvail();
  const ImVec2 room{std::max(avail.x, 4.0f), std::max(avail.y, 4.0f)};
  const ImVec2 lo = ImGui::GetCursorScreenPos(), hi{lo.x + room.x, lo.y + room.y};
  fitWhileUntouched(c, room.x / room.y);
  ImGui::InvisibleButton("##scene", room,
                         ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight |
                             ImGuiButtonFlags_MouseButtonMiddle);
  Probe::record("scene:view", lo, hi);
  const bool hovered = ImGui::IsItemHovered(), active = ImGui::IsItemActive();
  const ImVec2 drag = ImGui::GetMouseDragDelta(0, 0);
  const bool clicked = ImGui::IsItemDeactivated() && hovered && std::hypot(drag.x, drag.y) < 4;
  SceneCamera camera = makeSceneCamera(c.state.scene, lo, hi);
  navigate(c.state.scene, camera, hovered, active);
  camera = makeSceneCamera(c.state.scene, lo, hi);
  Scene3& scene = content.scene();
  scene.clip_from_world = camera.clip_from_world.cast<float>();
  scene.point_size_px = dp(c.state.scene.point_size);
  scene.line_width_px = dp(1.4f);
  const ImTextureID texture =
      c.graphics.scene(kSlot, scene, static_cast<int>(room.x), static_cast<int>(room.y));
  ImGui::GetWindowDrawList()->PushClipRect(lo, hi, true);
  ImGui::GetWindowDrawList()->AddImage(texture, lo, hi);
  drawMarkedSeeds(c, camera);
  drawSelected(c, camera);
  gizmo(camera);
  labels(c, camera);
  ImGui::GetWindowDrawList()->PopClipRect();
  if (clicked) pickPoint(c, camera);
}

}  // namespace svoscope::ui
