// SPDX-License-Identifier: MIT
#include <algorithm>

#include "ui/palette.h"
#include "ui/panels/export.h"
#include "ui/panels/panel.h"
#include "ui/panels/panel_context.h"
#include "ui/theme.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/icons.h"

namespace svoscope::ui {

namespace {

struct Bar {
  const char* name;
  int count;
  const char* meaning;
};

// `before`: count of the step before, 0 for the first step, -1 if nothing was counted in this
// frame.
void drawBar(const Bar& bar, int full, int before, int threshold, bool failed) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float h = ImGui::GetTextLineHeight() + grid(0.5f), name = ImGui::GetFontSize() * 6;
  const float value = ImGui::GetFontSize() * 6;
  const float room = std::max(8.0f, ImGui::GetContentRegionAvail().x - name - value);
  const auto length = [&](int n) {
    return room * static_cast<float>(std::clamp(n, 0, full)) /
           static_cast<float>(std::max(1, full));
  };
  ImDrawList* list = ImGui::GetWindowDrawList();
  list->AddText(at, ink::dim, bar.name);
  const float x = at.x + name;
  list->AddRectFilled({x, at.y + grid(0.5f)}, {x + room, at.y + h - grid(0.5f)}, ink::grid);
  list->AddRectFilled({x, at.y + grid(0.5f)}, {x + length(bar.count), at.y + h - grid(0.5f)},
                      failed ? okabe::vermillion : withAlpha(okabe::green, 0.85f));
  if (threshold > 0) {
    const float t = std::round(x + length(threshold));
    list->AddLine({t, at.y}, {t, at.y + h}, ink::text, dp(2));
  }
  const std::string count = before < 0 ? "–" : format("%d", bar.count);
  list->AddText({x + room + grid(2), at.y}, failed ? okabe::orange : ink::text, count.c_str());
  if (before > 0) {
    const std::string share = format("%d%%", static_cast<int>(100.0 * bar.count / before + 0.5));
    list->AddText({x + room + value - ImGui::CalcTextSize(share.c_str()).x, at.y}, ink::dim,
                  share.c_str());
  }
  ImGui::Dummy({name + room + value, h});
  tooltip(bar.meaning);
}

void bars(const Funnel& f, bool judged) {
  const Bar bars[] = {
      {"Candidates", f.candidates, "Landmarks and seeds of the local map"},
      {"Projected", f.projected, "Candidates that fall into the image"},
      {"Tried", f.tried, "Feature alignments attempted, at most one per grid cell"},
      {"Matched", f.matched, "Feature alignments that converged"},
      {"Inliers", f.inliers, "Left after pose refinement; below the mark tracking is lost"}};
  const int full =
      std::max({f.candidates, f.projected, f.tried, f.matched, f.inliers, f.required, 1});
  int before = judged ? 0 : -1;
  for (const Bar& bar : bars) {
    const bool last = bar.name == bars[4].name;
    drawBar(bar, full, before, last ? f.required : 0,
            last && f.required > 0 && f.inliers < f.required);
    if (judged) before = bar.count;
  }
}

void inlierRows(const Funnel& f) {
  valueRow("Inliers",
           counted(f.inlier_landmarks, "landmark") + ", " + counted(f.inlier_seeds, "seed"));
  const int corners = std::max(0, f.inliers - f.inlier_edgelets - f.inlier_segments);
  valueRow("Of type", counted(corners, "corner") + ", " + counted(f.inlier_edgelets, "edgelet") +
                          ", " + counted(f.inlier_segments, "segment"));
  if (f.followed_segments)
    valueRow("Followed",
             counted(f.followed_segments, "segment") + ", matched but kept out of the pose");
  valueRow("Required", counted(f.required, "inlier"));
}

// Fields that no step of this frame has set hold zeros: they are no measurements.
void trackingFunnel(const FrameRecord& r) {
  const Funnel& f = r.funnel;
  const bool judged = f.required > 0;
  const char* no_pose = "No pose to project the map with: nothing was counted";
  bars(f, judged);
  if (!judged) {
    for (const char* name : {"Inliers", "Of type", "Required"}) missingRow(name, no_pose);
  } else {
    inlierRows(f);
  }
  if (f.aligned_sparse > 0) {
    valueRow("Sparse alignment",
             format("%d patches, RMSE %.1f levels", f.aligned_sparse, r.align_rmse));
  } else {
    missingRow("Sparse alignment", "Not aligned to the frame before");
  }
  if (r.pose_good && f.inliers > 0)
    valueRow("Reprojection", format("%.2f px median", r.reprojection_px));
  else
    missingRow("Reprojection", "Only of frames with a pose");
  if (f.aligned_sparse > 0)
    valueRow("Brightness", format("gain %.3f, offset %+.1f", r.gain, r.offset));
  else
    missingRow("Brightness", "Not aligned to the frame before");
}

void startRows(const FrameRecord& r) {
  heading("Two-view start");
  valueRow("Tracks alive", format("%d", r.disparity_tracks));
  valueRow("Median disparity", format("%.1f px", r.disparity_px));
}

void draw(PanelContext& c) {
  if (!c.record) {
    return emptyState("No frame yet",
                      "Shows how many features survive each step, and why tracking was lost");
  }
  const FrameRecord& r = *c.record;
  ImGui::Text("Frame %d", r.index);
  ImGui::SameLine();
  legendEntry(stateColor(r.state), Swatch::dot, stateLabel(r.state));
  if (r.state == TrackingState::initializing)
    startRows(r);
  else
    trackingFunnel(r);
  heading("Why");
  valueRow("State", r.reason.empty() ? stateLabel(r.state) : r.reason,
           r.state == TrackingState::lost ? okabe::orange : 0);
  if (!r.keyframe_reason.empty()) {
    valueRow("Keyframe", (r.is_keyframe ? format("taken as %d, ", r.keyframe_id) : "not taken, ") +
                             r.keyframe_reason);
  }
  if (r.relocalized) valueRow("Relocalized", "first good pose after a loss", okabe::green);
  heading("Map after this frame");
  valueRow("Size", counted(r.landmarks, "landmark") + ", " + counted(r.seeds, "seed") + ", " +
                       counted(r.keyframes, "keyframe"));
  valueRow("Seeds now", format("%d updated, %d converged, %d rejected", r.seed_updates,
                               r.seeds_converged, r.seeds_rejected));
}

std::string csv(PanelContext& c) {
  return c.caches.run.records().empty() ? std::string() : framesCsv(c.caches.run);
}

}  // namespace

extern const Panel kFunnelPanel{"Funnel", draw, csv};

}  // namespace svoscope::ui
