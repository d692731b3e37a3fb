// SPDX-License-Identifier: MIT
#include <cctype>
#include <cmath>

#include "engine/eval/estimate.h"
#include "ui/palette.h"
#include "ui/panels/panel.h"
#include "ui/panels/panel_context.h"
#include "ui/theme.h"
#include "ui/widgets/controls.h"

namespace svoscope::ui {

namespace {

void errorRows(const TruthState& s) {
  heading("Absolute trajectory error");
  valueRow("RMSE", format("%.4f m", s.ate_rmse), ink::selected);
  valueRow("Mean, median", format("%.4f m, %.4f m", s.ate_mean, s.ate_median));
  valueRow("Largest", format("%.4f m", s.ate_max));
  heading("Relative error over 1 s");
  if (s.rpe_pairs == 0) {
    note("Needs poses one second apart");
  } else {
    valueRow("Translation", format("%.4f m RMSE", s.rpe_trans));
    valueRow("Rotation", format("%.3f° RMSE", s.rpe_rot * 180 / 3.14159265358979));
    valueRow("Pairs", format("%d", s.rpe_pairs));
  }
}

void alignmentRows(const TruthState& s) {
  heading("Alignment");
  valueRow("Mode", alignmentLabel(s.mode));
  valueRow("Scale", format("%.4f m per map unit", s.scale));
  valueRow("Matched poses", format("%d within 20 ms", s.matched));
}

void runRows(PanelContext& c) {
  int good = 0, losses = 0, start = -1;
  TrackingState before = TrackingState::initializing;
  const int map_id = mainMap(c.caches.run.records()), maps = mapCount(c.caches.run.records());
  for (const FrameRecord& r : c.caches.run.records()) {
    good += hasPoseIn(r, map_id);
    if (r.pose_good && start < 0) start = r.index;
    if (r.state == TrackingState::lost && before != TrackingState::lost) ++losses;
    before = r.state;
  }
  const auto frames = static_cast<int>(c.caches.run.records().size());
  heading("Run");
  valueRow("Tracked", format("%d of %d frames", good, frames));
  valueRow("Start", start < 0 ? std::string("not yet") : format("frame %d", start));
  valueRow("Losses", format("%d", losses));
  if (maps > 1)
    valueRow("Maps", format("%d; errors and path are those of the one with most poses", maps));
}

void errorPlot(PanelContext& c) {
  PlotSpec spec;
  spec.id = "Error over time";
  spec.y_label = "Position error, m";
  spec.zero_based = true;
  spec.marks = &c.caches.run.marks();
  spec.cursor = c.viewedFrame();
  spec.size = {0, std::max(ImGui::GetFontSize() * 8, ImGui::GetContentRegionAvail().y - grid(1))};
  spec.series.push_back({methodName(c.info.method), &c.caches.run.frames(),
                         &c.caches.truth.state().error, methodColor(c.info.method)});
  PlotState& state = c.state.plots["Error over time"];
  const PlotResult result = plot(spec, state, c.state.linked_x);
  if (result.clicked) c.view(std::max(0, static_cast<int>(result.clicked_x)));
  if (result.export_csv) exportText(c, "plot_error.csv", plotCsv(spec, state, c.state.linked_x));
}

void draw(PanelContext& c) {
  if (c.info.ground_truth.empty()) {
    const std::string why = c.info.truth_note.empty()
                                ? "This sequence has none, so there is no error to show"
                                : "No error: " + c.info.truth_note;
    if (c.caches.run.records().empty()) return emptyState("No ground truth", why);
    note(c.info.truth_note.empty()
             ? "This sequence has no ground truth, so there is no error to show"
             : why);
    return runRows(c);
  }
  static const std::vector<const char*> modes{"No alignment", "SE(3)", "Sim(3)"};
  combo("##alignment", c.state.align_mode, modes, ImGui::GetFontSize() * 8,
        "How the estimate is brought to the ground truth; one camera alone cannot know the scale, "
        "so Sim(3)");
  const TruthState& s = c.caches.truth.state();
  if (!s.valid) {
    std::string why =
        s.problem.empty() ? std::string("needs three poses with ground truth") : s.problem;
    why.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(why.front())));
    return emptyState("No error yet", why);
  }
  const bool wide = ImGui::GetContentRegionAvail().x > ImGui::GetFontSize() * 40;
  if (wide && ImGui::BeginTable("##columns", 2)) {
    ImGui::TableNextColumn();
    errorRows(s);
    ImGui::TableNextColumn();
    alignmentRows(s);
    runRows(c);
    ImGui::EndTable();
  } else {
    errorRows(s);
    alignmentRows(s);
    runRows(c);
  }
  errorPlot(c);
}

std::string csv(PanelContext& c) {
  const TruthState& truth = c.caches.truth.state();
  const auto& records = c.caches.run.records();
  if (!truth.valid) return "";
  std::string text = "frame,timestamp,error_m\n";
  for (std::size_t i = 0; i < records.size() && i < truth.error.size(); ++i) {
    text += format("%d,%.6f,", records[i].index, records[i].timestamp) +
            (std::isfinite(truth.error[i]) ? format("%g", truth.error[i]) : std::string()) + "\n";
  }
  return text;
}

}  // namespace

extern const Panel kEvaluationPanel{"Evaluation", draw, csv, /*charts=*/true};

}  // namespace svoscope::ui
