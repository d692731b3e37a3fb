// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "ui/model/seed_trace.h"
#include "ui/palette.h"
#include "ui/panels/panel.h"
#include "ui/panels/panel_context.h"
#include "ui/theme.h"
#include "ui/widgets/controls.h"

namespace svoscope::ui {

namespace {

std::string px(const Vec2f& p) { return format("%.2f, %.2f px", p.x(), p.y()); }

// The keyframe a feature or seed refers to, with a way to look at its frame.
void referenceRow(PanelContext& c, int keyframe) {
  if (keyframe < 0) return;
  int frame = -1;
  if (c.snapshot->keyframes) {
    for (const KeyframeView& k : *c.snapshot->keyframes) {
      if (k.id == keyframe) frame = k.frame_index;
    }
  }
  valueRow("Reference", frame < 0 ? format("keyframe %d, removed", keyframe)
                                  : format("keyframe %d, frame %d", keyframe, frame));
  if (frame < 0) return;
  sameLineIfFits(ImGui::CalcTextSize("Show").x + 2 * grid(1.5f));
  const bool held = frame >= c.status.history_first;
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {grid(1.5f), 0});
  if (button("Show",
             {"View the keyframe's frame", held ? nullptr : "That frame is no longer held"})) {
    c.view(frame);
  }
  ImGui::PopStyleVar();
}

void featureRows(PanelContext& c, const FeatureView& f) {
  heading("In this frame");
  valueRow("Status", statusName(f.status), featureColor(f));
  valueRow("Measured", px(f.px));
  if (f.type == FeatureType::segment) valueRow("Other end", px(f.px_end));
  valueRow(f.origin == FeatureOrigin::track ? "First seen at" : "Predicted", px(f.predicted_px));
  if (f.origin == FeatureOrigin::track) {
    valueRow("Disparity", format("%.2f px", (f.px - f.predicted_px).norm()));
    return;
  }
  valueRow("Residual", format("%.3f px", f.residual_px));
  valueRow("Depth", format("%.3f map units", f.depth));
  valueRow("Level", format("%d", f.level));
  if (f.type == FeatureType::edgelet) {
    valueRow("Gradient", format("%.0f°", f.direction * 180.0 / 3.14159265358979));
  }
  valueRow(f.origin == FeatureOrigin::landmark ? "Observations" : "Updates",
           format("%d", f.observations));
  referenceRow(c, f.reference_keyframe);
}

void pointRows(const MapPointView& p) {
  heading("Landmark");
  valueRow("Position", format("%.3f, %.3f, %.3f", p.position.x(), p.position.y(), p.position.z()));
  valueRow("Seen by", counted(p.observations, "keyframe"));
  if (p.sigma > 0) valueRow("σ at promotion", format("%.4f 1/map unit", p.sigma));
}

void seedRows(PanelContext& c, const SeedView& s) {
  heading("Belief");
  valueRow("Status",
           format("%s after %s, %s", seedStatusName(s.status), counted(s.updates, "update").c_str(),
                  counted(s.failures, "failure").c_str()),
           seedColor(s));
  valueRow("Last search", searchOutcomeName(s.outcome));
  valueRow("Inverse distance", format("%.4f ± %.4f 1/map unit", s.mu, s.sigma));
  if (s.mu > 0) {
    const double far_end = s.mu > s.sigma ? 1 / (s.mu - s.sigma) : INFINITY;
    const std::string hi = std::isfinite(far_end) ? format("%.2f", far_end) : std::string("∞");
    valueRow("Distance",
             format("%.3f map units, %.2f to %s", 1 / s.mu, 1 / (s.mu + s.sigma), hi.c_str()));
  }
  valueRow("Inlier ratio",
           format("%.2f   Beta(%.1f, %.1f)", s.a / std::max(1e-6f, s.a + s.b), s.a, s.b));
  valueRow("σ / range", format("%.4f", s.range > 0 ? s.sigma / s.range : 0.0f));
  if (s.last_tau > 0) valueRow("Last measurement", format("%.4f ± %.4f", s.last_x, s.last_tau));
  if (s.true_inv_distance > 0) {
    const double aligned = trueInverseDistance(c, s);
    valueRow("True distance",
             format("%.3f m", 1 / s.true_inv_distance) +
                 (aligned > 0 ? format(" = %.3f map units", 1 / aligned) : std::string()));
  }
  if (s.visible) valueRow("Mean at", px(s.px));
  referenceRow(c, s.keyframe_id);
}

// All plots of the panel span the frames of the history, whatever the run plots show.
LinkedX historyFrames(const SelectionHistory& h) {
  LinkedX x;
  x.known = {1e30, -1e30};
  for (const auto* frames : {&h.seed_frames, &h.frames}) {
    if (frames->empty()) continue;
    x.known = {std::min<double>(x.known.lo, frames->front()),
               std::max<double>(x.known.hi, frames->back())};
  }
  return x;
}

void historyPlot(PanelContext& c, PlotSpec spec) {
  spec.size = {0, ImGui::GetFontSize() * 7};
  spec.cursor = c.viewedFrame();
  LinkedX frames = historyFrames(c.caches.selection);
  const PlotResult result = plot(spec, c.state.plots[spec.id], frames);
  if (result.clicked) c.view(static_cast<int>(result.clicked_x));
}

void histories(PanelContext& c) {
  const SelectionHistory& h = c.caches.selection;
  if (h.seed_frames.size() > 1) {
    heading("Convergence");
    PlotSpec spec;
    spec.id = "Seed belief";
    spec.y_label = "Inverse distance";
    spec.series = {{"μ ± σ", &h.seed_frames, &h.mu, okabe::orange, false, &h.mu_lo, &h.mu_hi}};
    historyPlot(c, spec);
    PlotSpec ratios;
    ratios.id = "Seed ratios";
    ratios.y_label = "Ratios";
    ratios.zero_based = true;
    ratios.series = {{"σ / range", &h.seed_frames, &h.sigma_ratio, okabe::sky},
                     {"Inlier ratio", &h.seed_frames, &h.inlier_ratio, okabe::purple, true}};
    historyPlot(c, ratios);
  }
  if (h.frames.size() > 1) {
    heading("As a feature");
    PlotSpec spec;
    spec.id = "Feature residual";
    spec.y_label = "Residual, px";
    spec.zero_based = true;
    spec.series = {{"", &h.frames, &h.residual, okabe::orange}};
    historyPlot(c, spec);
    PlotSpec depth;
    depth.id = "Feature depth";
    depth.y_label = "Depth, map units";
    depth.series = {{"", &h.frames, &h.depth, okabe::purple}};
    historyPlot(c, depth);
  }
}

// The selected thing is not in this frame: say since when, and offer the last one that has it.
void leftTheFrame(PanelContext& c) {
  const SelectionHistory& h = c.caches.selection;
  if (h.last_seen < 0) return note("Not seen in any frame that is still held");
  if (h.last_seen < c.viewedFrame()) {
    note(format("Left the frame, last seen in frame %d", h.last_seen));
  } else {
    note("Not seen in this frame");
  }
  if (h.last_seen != c.viewedFrame() &&
      button("Go to last seen", {"View the last frame that has it"})) {
    c.view(h.last_seen);
  }
}

const char* kindName(Selection::Kind kind) {
  switch (kind) {
    case Selection::Kind::landmark:
      return "Landmark";
    case Selection::Kind::seed:
      return "Seed";
    case Selection::Kind::track:
      return "Start track";
    case Selection::Kind::none:
      break;
  }
  return "";
}

void draw(PanelContext& c) {
  const Selection& s = c.state.selection;
  if (!s) {
    return emptyState("Nothing selected",
                      "Click a feature or seed in the image, or a point in the 3-D view");
  }
  if (!c.snapshot) {
    saysWhyEmpty(c);
    return;
  }
  const FeatureView* feature = findFeature(*c.snapshot, s);
  const SeedView* seed = s.kind == Selection::Kind::seed ? findSeed(*c.snapshot, s.id) : nullptr;
  const FeatureType type = feature ? feature->type : seed ? seed->type : FeatureType::corner;
  ImGui::AlignTextToFramePadding();
  ImGui::Text("%s %lld", kindName(s.kind), static_cast<long long>(s.id));
  if (feature || seed) {
    ImGui::SameLine();
    ImGui::AlignTextToFramePadding();
    ImGui::TextDisabled("%s", featureTypeName(type));
  }
  ImGui::SameLine(ImGui::GetWindowContentRegionMax().x - buttonWidth("Clear"));
  if (button("Clear", {"Select nothing (Esc)"})) {
    c.state.selection = {};
    return;
  }
  if (!feature && !seed) leftTheFrame(c);
  if (feature) featureRows(c, *feature);
  if (seed) seedRows(c, *seed);
  if (s.kind == Selection::Kind::landmark) {
    if (const MapPointView* p = findPoint(*c.snapshot, s.id)) pointRows(*p);
  }
  histories(c);
}

}  // namespace

extern const Panel kSelectionPanel{"Selection", draw};

}  // namespace svoscope::ui
