// SPDX-License-Identifier: MIT
// The filter lab: the paper's Figures 2 and 3 and its claims about convergence, to be turned by
// hand.
#include <algorithm>
#include <cmath>

#include "ui/palette.h"
#include "ui/panels/filter/lab_view.h"
#include "ui/panels/panel.h"
#include "ui/panels/panel_context.h"
#include "ui/panels/seed/densities.h"
#include "ui/theme.h"
#include "ui/widgets/chart.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/icons.h"
#include "ui/widgets/pen.h"
#include "ui/widgets/probe.h"
#include "ui/widgets/rule_style.h"

namespace svoscope::ui {

namespace {

constexpr double kLogTwo = 0.6931471805599453;

bool labelled(const char* label, float& value, float lo, float hi, const char* pattern, float width,
              const char* hint) {
  const float name = ImGui::GetFontSize() * 6.2f;
  ImGui::AlignTextToFramePadding();
  const float start = ImGui::GetCursorPosX();
  ImGui::TextDisabled("%s", label);
  ImGui::SameLine(0, 0);
  ImGui::SetCursorPosX(start + name);
  const std::string id = std::string("##") + label;
  return slider(id.c_str(), value, lo, hi, pattern, std::max(grid(10), width - name), hint);
}

// A block of sliders beside each other in two columns, as wide as the section.
struct SliderGrid {
  ImVec2 start = ImGui::GetCursorScreenPos();
  float width, column;
  int count = 0;
  explicit SliderGrid(float w)
      : width(w), column(w > ImGui::GetFontSize() * 34 ? (w - grid(4)) / 2 : w) {}
  bool two() const { return column < width; }
  bool item(const char* label, float& value, float lo, float hi, const char* pattern,
            const char* hint) {
    if (two() && count % 2 == 1) {
      ImGui::SameLine(0, 0);
      ImGui::SetCursorScreenPos({start.x + column + grid(4), ImGui::GetCursorScreenPos().y});
    } else {
      ImGui::SetCursorScreenPos({start.x, ImGui::GetCursorScreenPos().y});
    }
    ++count;
    return labelled(label, value, lo, hi, pattern, column, hint);
  }
};

void gaussians(const LabSettings& s, ImVec2 size) {
  const double x = s.mu + s.offset;
  const Range over{std::min<double>(s.mu - 3.5 * s.sigma, x - 3.5 * s.tau),
                   std::max<double>(s.mu + 3.5 * s.sigma, x + 3.5 * s.tau)};
  const Curve p = gaussianCurve(s.mu, s.sigma, over), q = gaussianCurve(x, s.tau, over);
  Curve m;
  for (int i = 0; i <= 240; ++i) {
    const double at = over.lo + over.span() * i / 240;
    m.x.push_back(static_cast<float>(at));
    m.y.push_back(static_cast<float>(
        0.5 * (gaussianDensity(at, s.mu, s.sigma) + gaussianDensity(at, x, s.tau))));
  }
  ChartSpec spec;
  spec.id = "Two Gaussians";
  spec.title = "Densities";
  spec.x_label = "Inverse distance";
  spec.x = over;
  spec.y = {0, 1.1 * std::max(p.peak(), q.peak())};
  spec.y_ticks = false;
  spec.size = size;
  spec.legend = {{"belief p", okabe::purple, Swatch::line},
                 {"measurement q", ink::measurement, Swatch::line},
                 {"mixture m", ink::dim, Swatch::dashed}};
  Chart chart(spec);
  chart.area(p.x, p.y, withAlpha(okabe::purple, 0.18f));
  chart.area(q.x, q.y, withAlpha(ink::measurement, 0.18f));
  chart.line(p.x, p.y, {okabe::purple, 1.8f, false});
  chart.line(q.x, q.y, {ink::measurement, 1.8f, false});
  chart.line(m.x, m.y, {ink::dim, 1.3f, true});
}

void separation(PanelContext& c, const LabPair& now, ImVec2 size) {
  LabSettings& s = c.options<LabSettings>();
  SeparationCurves& curves = c.cache<SeparationCurves>();
  curves.update(s.sigma, s.tau);
  ChartSpec spec;
  spec.id = "Divergence over separation";
  spec.title = "Divergence";
  spec.x_label = "Separation |x - μ|";
  spec.y_label = "nats";
  spec.x = {0, curves.offset.back()};
  spec.y = {0, 3};
  spec.size = size;
  spec.legend = {ruleEntry(FilterRule::kl, "KL(p||q)"),
                 {"KL(q||p)", okabe::purple, Swatch::dashed},
                 ruleEntry(FilterRule::js)};
  Chart chart(spec);
  chart.markY(kLogTwo, {ink::threshold, 1, true}, "limit of JS, log 2");
  chart.line(curves.offset, curves.kl_pq, ruleLine(FilterRule::kl));
  chart.line(curves.offset, curves.kl_qp, {okabe::purple, 1.8f, true});
  chart.line(curves.offset, curves.jsd, ruleLine(FilterRule::js, 2.2f));
  const double at = std::abs(s.offset);
  chart.markX(at, {withAlpha(ink::cursor, 0.8f), 1, false});
  chart.point(at, now.jsd, PointShape::circle, 4, ruleColor(FilterRule::js));
  chart.point(at, std::min(now.kl_pq, 2.97),
              now.kl_pq > 3 ? PointShape::triangle : PointShape::diamond, 4,
              ruleColor(FilterRule::kl));
  chart.point(at, std::min(now.kl_qp, 2.82),
              now.kl_qp > 3 ? PointShape::triangle : PointShape::diamond, 4, okabe::purple);
  if (!chart.hovered()) return;
  ImGui::SetTooltip("Drag to move the measurement");
  if (ImGui::IsMouseDown(0)) s.offset = static_cast<float>(std::max(0.0, chart.mouseX()));
}

void sketchRay(ImDrawList* list, ImVec2 a, ImVec2 b, ImU32 color, float width) {
  const float dx = b.x - a.x, dy = b.y - a.y, n = std::max(1.0f, std::hypot(dx, dy));
  pen::line(list, a, {a.x + dx / n * 4000, a.y + dy / n * 4000}, color, width);
}

// Top view: cameras at the bottom, the point ahead of the first. Sideways stretched to use the
// room.
void sketch(const LabSettings& s, const TwoViews& v, ImVec2 size) {
  ImDrawList* list = ImGui::GetWindowDrawList();
  const ImVec2 lo = ImGui::GetCursorScreenPos(), hi{lo.x + size.x, lo.y + size.y};
  ImGui::Dummy(size);
  Probe::record("Two views", lo, hi);
  pen::rectFilled(list, lo, hi, ink::canvas);
  const double top =
      std::min(std::isfinite(v.far_m) ? v.far_m * 1.12 : 3.0 * s.depth, 3.0 * s.depth);
  const double scale = (size.y - grid(9)) / std::max(1e-6, top);
  const double stretch = std::clamp((size.x - grid(40)) / (scale * s.baseline), 0.2, 1000.0);
  const auto at = [&](double x, double z) {
    return ImVec2{lo.x + grid(20) + static_cast<float>(x * scale * stretch),
                  hi.y - grid(6) - static_cast<float>(z * scale)};
  };
  pen::pushClipRect(list, lo, hi, true);
  const ImVec2 first = at(0, 0), second = at(s.baseline, 0), point = at(0, s.depth);
  const double far_end = std::isfinite(v.far_m) ? v.far_m : 10 * s.depth;
  const ImVec2 fan[3] = {second, at(0, v.near_m), at(0, far_end)};
  pen::triangleFilled(list, fan[0], fan[1], fan[2], withAlpha(okabe::orange, 0.10f));
  sketchRay(list, first, point, ink::dim, dp(1));
  sketchRay(list, second, at(0, v.near_m), withAlpha(okabe::orange, 0.8f), dp(1.2f));
  sketchRay(list, second, point, ink::text, dp(1.2f));
  if (std::isfinite(v.far_m))
    sketchRay(list, second, at(0, v.far_m), withAlpha(okabe::orange, 0.8f), dp(1.2f));
  pen::line(list, at(0, v.near_m), at(0, far_end), okabe::sky, dp(4));
  pen::line(list, first, second, okabe::green, dp(2));
  for (const ImVec2& camera : {first, second}) {
    pen::triangleFilled(list, {camera.x, camera.y + dp(2)}, {camera.x - dp(6), camera.y - dp(9)},
                        {camera.x + dp(6), camera.y - dp(9)}, okabe::green);
  }
  pen::circleFilled(list, point, dp(4), ink::cursor);
  const std::string note_text = format("top view, sideways x%.1f; blue: where P may lie", stretch);
  outlinedText(list, {hi.x - ImGui::CalcTextSize(note_text.c_str()).x - grid(2), lo.y + grid(1)},
               ink::dim, note_text.c_str());
  const std::string near_text = format("%.2f m", v.near_m),
                    far_text = std::isfinite(v.far_m) ? format("%.2f m", v.far_m) : "infinity";
  outlinedText(list, {point.x - grid(15), at(0, v.near_m).y - ImGui::GetFontSize() / 2}, okabe::sky,
               near_text.c_str());
  outlinedText(list,
               {point.x - grid(15), std::max(lo.y, at(0, far_end).y - ImGui::GetFontSize() / 2)},
               okabe::sky, far_text.c_str());
  outlinedText(list, {point.x + grid(2), point.y - ImGui::GetFontSize() / 2}, ink::cursor, "P");
  outlinedText(list, {first.x - grid(5), first.y + grid(1)}, okabe::green, "I_r");
  outlinedText(list, {second.x - grid(1), second.y + grid(1)}, okabe::green, "I_k");
  pen::popClipRect(list);
}

void relativeError(const LabSettings& s, ImVec2 size) {
  std::vector<float> x, y;
  for (int i = 0; i <= 80; ++i) {
    const double baseline = 0.01 * std::pow(200.0, i / 80.0);
    const TwoViews v = twoViews(baseline, s.depth, s.pixel_noise, s.focal);
    x.push_back(static_cast<float>(baseline));
    y.push_back(static_cast<float>(100 * v.tau * s.depth));
  }
  ChartSpec spec;
  spec.id = "Uncertainty over baseline";
  spec.title = "τ relative to 1 / distance";
  spec.x_label = "Baseline, m (log)";
  spec.y_label = "% (log)";
  spec.x = {0.01, 2};
  spec.y = {0.05, 200};
  spec.log_x = spec.log_y = true;
  spec.size = size;
  Chart chart(spec);
  chart.line(x, y, {okabe::sky, 1.8f, false});
  chart.markX(s.baseline, {withAlpha(ink::cursor, 0.8f), 1, false});
  const TwoViews now = twoViews(s.baseline, s.depth, s.pixel_noise, s.focal);
  chart.point(s.baseline, 100 * now.tau * s.depth, PointShape::circle, 4, okabe::sky);
}

}  // namespace

void divergenceSection(PanelContext& c, ImVec2 size) {
  LabSettings& s = c.options<LabSettings>();
  ImGui::BeginGroup();
  SliderGrid sliders(size.x);
  sliders.item("Belief μ", s.mu, 0.1f, 2, "%.2f", "Mean of the belief p, inverse distance");
  sliders.item("Belief σ", s.sigma, 0.005f, 1, "%.3f", "Standard deviation of the belief p");
  sliders.item("Offset x - μ", s.offset, 0, 3, "%.2f", "Distance of the measurement's mean");
  sliders.item("Measured τ", s.tau, 0.005f, 1, "%.3f", "Standard deviation of the measurement q");
  const LabPair now = comparePair(s.mu, s.sigma, s.mu + s.offset, s.tau);
  note(format("KL(p||q) %.3g   KL(q||p) %.3g   JS %.4f of log 2 = 0.6931   affinity w %.3f",
              now.kl_pq, now.kl_qp, now.jsd, now.affinity));
  const float room = std::max(ImGui::GetFontSize() * 9,
                              size.y - ImGui::GetItemRectMax().y + sliders.start.y - grid(3));
  const bool side = size.x > ImGui::GetFontSize() * 38;
  const ImVec2 cell{side ? std::floor((size.x - grid(2)) / 2) : size.x,
                    side ? room : std::max(ImGui::GetFontSize() * 9, std::floor(room / 2))};
  gaussians(s, cell);
  if (side) ImGui::SameLine(0, grid(2));
  separation(c, now, cell);
  ImGui::EndGroup();
}

void twoViewSection(PanelContext& c, ImVec2 size) {
  LabSettings& s = c.options<LabSettings>();
  ImGui::BeginGroup();
  SliderGrid sliders(size.x);
  sliders.item("Baseline", s.baseline, 0.01f, 2, "%.2f m", "Between the two cameras");
  sliders.item("Depth", s.depth, 0.3f, 10, "%.2f m", "Of the point, ahead of the first camera");
  sliders.item("Pixel noise", s.pixel_noise, 0.1f, 20, "%.1f px",
               "Error of the match along the epipolar line");
  sliders.item("Focal length", s.focal, 100, 1500, "%.0f px", "Of both cameras");
  const TwoViews v = twoViews(s.baseline, s.depth, s.pixel_noise, s.focal);
  const std::string far_text =
      std::isfinite(v.far_m) ? format("%.3f m", v.far_m) : std::string("infinity");
  note(format("P lies between %.3f m and %s   angle %.2f°   τ %.4f 1/m, %.1f %% of 1/distance",
              v.near_m, far_text.c_str(), v.angle * 57.29578, v.tau, 100 * v.tau * s.depth));
  const float room = std::max(ImGui::GetFontSize() * 9,
                              size.y - ImGui::GetItemRectMax().y + sliders.start.y - grid(3));
  const bool side = size.x > ImGui::GetFontSize() * 38;
  const ImVec2 cell{side ? std::floor((size.x - grid(2)) / 2) : size.x,
                    side ? room : std::max(ImGui::GetFontSize() * 9, std::floor(room / 2))};
  sketch(s, v, cell);
  if (side) ImGui::SameLine(0, grid(2));
  relativeError(s, cell);
  ImGui::EndGroup();
}

namespace {

std::string csv(PanelContext& c) {
  const LabSettings& s = c.options<LabSettings>();
  SeparationCurves& curves = c.cache<SeparationCurves>();
  curves.update(s.sigma, s.tau);
  return labCsv(s, curves, c.cache<LabSimulation>().worker.state().result.get());
}

void draw(PanelContext& c) {
  LabSettings& s = c.options<LabSettings>();
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {grid(1.5f), grid(0.5f)});
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {grid(1), grid(1)});
  const char* names[] = {"Divergences", "Two views", "Population", "All"};
  for (int i = 0; i < 4; ++i) {
    if (i > 0) sameLineIfFits(buttonWidth(names[i]));
    if (button(names[i], {}, c.options<LabChoices>().section == i))
      c.options<LabChoices>().section = i;
  }
  sameLineIfFits(buttonWidth("Reset lab"));
  if (button("Reset lab", {"All sliders as at the start"})) s = LabSettings();
  sameLineIfFits(buttonWidth("Export CSV"));
  if (button("Export CSV", {"Divergences over separation, and the simulated population"})) {
    exportText(c, "filter_lab.csv", csv(c));
  }
  const int section = c.options<LabChoices>().section;
  const ImVec2 room = ImGui::GetContentRegionAvail();
  const float font = ImGui::GetFontSize();
  if (section < 3) {
    const ImVec2 size{room.x, std::max(font * 18, room.y)};
    section == 0   ? divergenceSection(c, size)
    : section == 1 ? twoViewSection(c, size)
                   : populationSection(c, size);
  } else {
    const float third = std::max(font * 18, std::floor(room.y / 3) - grid(5)),
                most = std::max(font * 26, third);
    heading("Divergences (paper, Figure 3)");
    divergenceSection(c, {room.x, third});
    heading("Two views (paper, Figure 2)");
    twoViewSection(c, {room.x, third});
    heading("Simulated population");
    populationSection(c, {room.x, most});
  }
  ImGui::PopStyleVar(2);
}

std::vector<PanelOption> scriptOptions() {
  const auto slider = [](const char* name, float LabSettings::*field) {
    return windowOption<LabSettings>(name, field);
  };
  using S = LabSettings;
  return {windowOption<LabChoices>("lab.section", &LabChoices::section),
          windowOption<LabChoices>("lab.wait", &LabChoices::wait),
          slider("lab.mu", &S::mu),
          slider("lab.sigma", &S::sigma),
          slider("lab.offset", &S::offset),
          slider("lab.tau", &S::tau),
          slider("lab.baseline", &S::baseline),
          slider("lab.depth", &S::depth),
          slider("lab.pixel_noise", &S::pixel_noise),
          slider("lab.seeds", &S::seeds),
          slider("lab.outliers", &S::outliers),
          slider("lab.hopeless", &S::hopeless)};
}

}  // namespace

extern const Panel kLabPanel{"Filter lab", draw, csv, /*charts=*/true, scriptOptions};

}  // namespace svoscope::ui
