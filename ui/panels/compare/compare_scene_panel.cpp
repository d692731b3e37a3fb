// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <utility>

#include "ui/palette.h"
#include "ui/panels/compare/compare_panel.h"
#include "ui/panels/compare/compare_scene.h"
#include "ui/panels/panel.h"
#include "ui/panels/scene/scene_view.h"
#include "ui/theme.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/icons.h"

namespace svoscope::ui {

namespace {

constexpr std::uint32_t kSlot = 3;

struct CompareSceneOptions : SceneOptions {
  int generation = -1;  ///< of all runs, when the view was fitted
};

// Fitted again after a reset of any run.
SceneOptions& viewpoint(PanelContext& c) {
  CompareSceneOptions& o = c.options<CompareSceneOptions>();
  int generation = 0;  // a sum: each of them only increases
  for (const auto& caches : c.all_caches) generation += caches->run.generation();
  if (std::exchange(o.generation, generation) != generation) o.fitted = false;
  return o;
}

void toolbar(PanelContext& c) {
  SceneOptions& o = c.options<CompareSceneOptions>();
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {grid(1.5f), grid(0.5f)});
  if (button("Fit##compare", {"Show all paths"})) o.fitted = false;
  ImGui::SameLine(0, grid(1));
  if (button("Top##compare", {"Look from above"})) topView(o);
  ImGui::SameLine(0, grid(1));
  toggle("Grid##compare", o.grid, "Ground grid");
  ImGui::PopStyleVar();
}

void marks(const CompareScene& scene, const SceneCamera& camera) {
  ImDrawList* list = ImGui::GetWindowDrawList();
  std::vector<ImVec2> taken;  // runs are often lost in the same place: side by side then
  for (const ComparePlace& place : scene.losses()) {
    auto at = camera.project(place.position.cast<double>());
    if (!at) continue;
    for (const ImVec2& other : taken) {
      if (std::hypot(other.x - at->x, other.y - at->y) < dp(9)) at->x = other.x + dp(12);
    }
    taken.push_back(*at);
    list->AddCircleFilled(*at, dp(6), IM_COL32(0, 0, 0, 150), 16);
    drawSwatch(Swatch::cross, *at, dp(4), place.color);
  }
  for (const ComparePlace& place : scene.now()) {
    const auto at = camera.project(place.position.cast<double>());
    if (!at) continue;
    list->AddCircleFilled(*at, dp(5), IM_COL32(0, 0, 0, 200), 16);
    list->AddCircleFilled(*at, dp(3.5f), place.color, 16);
  }
}

void labels(PanelContext& c, const CompareData& data, const CompareScene& scene,
            const SceneArea& area) {
  ImVec2 at{area.lo.x + grid(2), area.lo.y + grid(1)};
  const float lines = static_cast<float>(data.runs().size() + 3);
  if (area.hi.y - area.lo.y > lines * (ImGui::GetTextLineHeight() + grid(0.5f))) {
    for (const ComparedRun& run : data.runs()) {
      const std::string why = run.aligned            ? ""
                              : !run.problem.empty() ? ": " + run.problem
                                                     : ": no pose yet";
      sceneLegend(at, swatchOf(run.style.dash), run.style.color, run.style.label + why);
    }
    if (!data.truthPath().empty())
      sceneLegend(at, Swatch::dashed, ink::ground_truth, "Ground truth");
    if (!scene.losses().empty()) sceneLegend(at, Swatch::cross, ink::text, "Lost here");
  }
  const char* unit = data.metric() ? "m" : "map units";
  std::string text = c.options<CompareSceneOptions>().grid
                         ? format("grid %.3g %s", scene.cell(), unit)
                         : std::string();
  const RunStyle& current = c.runs.style(c.runs.current());
  const std::string onto = data.metric()
                               ? format("aligned to ground truth, %s",
                                        alignmentLabel(static_cast<Alignment>(c.state.align_mode)))
                               : "aligned to " + current.label;
  text = text.empty() ? onto : onto + ", " + text;
  outlinedText(ImGui::GetWindowDrawList(),
               {area.hi.x - ImGui::CalcTextSize(text.c_str()).x - grid(2),
                area.hi.y - ImGui::GetTextLineHeight() - grid(1)},
               ink::dim, text.c_str());
}

void draw(PanelContext& c) {
  if (!comparing(c)) return;
  const CompareData& data = c.compare;
  SceneOptions& o = viewpoint(c);
  toolbar(c);
  CompareScene& scene = c.cache<CompareScene>();
  scene.update(data, c.viewedFrame(), o.grid);
  if (scene.empty()) {
    return emptyState("No path yet", c.info.ground_truth.empty()
                                         ? "Needs poses of the current run"
                                         : "Needs three poses with ground truth");
  }
  if (!o.fitted) fitScene(o, scene.center(), scene.radius() * 1.15, sceneAspect());
  const SceneArea area = sceneArea("compare:view", o);
  Scene3& content = scene.scene();
  content.clip_from_world = area.camera.clip_from_world.cast<float>();
  content.line_width_px = dp(1.6f);
  ImDrawList* list = ImGui::GetWindowDrawList();
  list->PushClipRect(area.lo, area.hi, true);
  list->AddImage(c.graphics.scene(kSlot, content, area.width(), area.height()), area.lo, area.hi);
  marks(scene, area.camera);
  drawGizmo(area.camera);
  labels(c, data, scene, area);
  list->PopClipRect();
}

std::string csv(PanelContext& c) {
  return updateComparison(c) ? pathsCsv(c.compare) : std::string();
}

std::vector<PanelOption> scriptOptions() {
  using O = CompareSceneOptions;
  return {windowOption<O>("compare.grid", &O::grid), windowOption<O>("compare.yaw", &O::yaw),
          windowOption<O>("compare.pitch", &O::pitch)};
}

}  // namespace

extern const Panel kCompareScenePanel{"Compare 3-D", draw, csv, /*charts=*/false, scriptOptions};

}  // namespace svoscope::ui
