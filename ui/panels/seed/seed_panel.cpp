// SPDX-License-Identifier: MIT
// What the selected seed believes: all rules, update by update.
#include <algorithm>
#include <cmath>

#include "ui/model/seed_trace.h"
#include "ui/palette.h"
#include "ui/panels/panel.h"
#include "ui/panels/panel_context.h"
#include "ui/panels/seed/seed_charts.h"
#include "ui/theme.h"
#include "ui/widgets/chart.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/icons.h"
#include "ui/widgets/probe.h"

namespace svoscope::ui {

namespace {

std::string endingText(const PanelContext& c, const SeedTrace& t) {
  const SeedView& s = *t.last;
  if (s.ending != SeedEnding::none)
    return format("ended in frame %d: %s", t.last_frame, seedEndingName(s.ending));
  if (t.last_frame < c.engineFrame()) return format("last held in frame %d", t.last_frame);
  return seedStatusName(s.status);
}

void header(PanelContext& c, const ViewedUpdate& v) {
  const SeedTrace& t = *v.trace;
  ImGui::AlignTextToFramePadding();
  ImGui::Text("Seed %lld", static_cast<long long>(t.id));
  if (t.last) {
    ImGui::SameLine();
    ImGui::TextDisabled("%s, level %d, keyframe %d", featureTypeName(t.last->type), t.last->level,
                        t.last->keyframe_id);
    const std::string ending = endingText(c, t);
    sameLineIfFits(ImGui::CalcTextSize(ending.c_str()).x);
    ImGui::PushStyleColor(ImGuiCol_Text, toVec4(seedColor(*t.last)));
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(ending.c_str());
    ImGui::PopStyleColor();
  }
}

void options(PanelContext& c, const ViewedUpdate& v) {
  SeedOptions& o = c.state.seed;
  const bool pinned = isPinned(c, v.trace->id);
  if (button(pinned ? "Unpin" : "Pin", {"Keep this seed in view when another one is selected"},
             pinned)) {
    togglePin(c, v.trace->id);
  }
  sameLineIfFits(buttonWidth("Distance"));
  toggle("Distance", o.distance, "Densities over distance instead of inverse distance");
  sameLineIfFits(buttonWidth("Whole range"));
  toggle("Whole range", o.whole_range,
         "Densities from infinity to the nearest distance, instead of about the belief");
  sameLineIfFits(buttonWidth("Image follows"));
  toggle("Image follows", o.image_follows,
         "Stepping through updates shows the frame they belong to");
  sameLineIfFits(buttonWidth("Export CSV"));
  if (button("Export CSV", {"All held updates of this seed"})) {
    exportText(c, format("seed_%lld.csv", static_cast<long long>(v.trace->id)), traceCsv(*v.trace));
  }
}

void stepper(PanelContext& c, const ViewedUpdate& v) {
  const int count = static_cast<int>(v.trace->updates.size());
  const char* none_before = v.index <= 0 ? "This is the first one held" : nullptr;
  const char* none_after = v.index >= count - 1 ? "This is the last one" : nullptr;
  if (iconButton("First update", Icon::first, {"First update held", none_before}))
    viewUpdate(c, *v.trace, 0);
  ImGui::SameLine();
  if (iconButton("Previous update", Icon::back, {"Update before (,)", none_before}))
    viewUpdate(c, *v.trace, v.index - 1);
  ImGui::SameLine();
  if (iconButton("Next update", Icon::step, {"Next update (.)", none_after}))
    viewUpdate(c, *v.trace, v.index + 1);
  ImGui::SameLine();
  if (iconButton("Last update", Icon::last, {"Last update", none_after}))
    viewUpdate(c, *v.trace, count - 1);
  ImGui::SameLine();
  int shown = v.index + 1;
  ImGui::SetNextItemWidth(std::max(ImGui::GetFontSize() * 6,
                                   ImGui::GetContentRegionAvail().x - ImGui::GetFontSize() * 14));
  const bool moved =
      ImGui::SliderInt("##update", &shown, 1, count, format("%%d of %d", count).c_str(),
                       ImGuiSliderFlags_AlwaysClamp);
  Probe::record("update");
  if (moved && shown != v.index + 1) viewUpdate(c, *v.trace, shown - 1);
  if (!v.update) return;
  const std::string text =
      format("frame %d, %s", v.update->frame_index, searchOutcomeName(v.update->outcome));
  sameLineIfFits(ImGui::CalcTextSize(text.c_str()).x);
  ImGui::TextUnformatted(text.c_str());
}

// A number that does not fit must not look like a shorter one.
void cell(const std::string& text, ImU32 color = ink::text) {
  ImGui::TableNextColumn();
  const std::string shown = fitted(text, ImGui::GetContentRegionAvail().x);
  ImGui::PushStyleColor(ImGuiCol_Text, toVec4(color));
  ImGui::TextUnformatted(shown.c_str());
  ImGui::PopStyleColor();
  if (shown.find("…") != std::string::npos) tooltip(text.c_str());
}

void factsTable(const std::vector<SeedFact>& facts) {
  const ImGuiTableFlags flags =
      ImGuiTableFlags_SizingStretchProp | ImGuiTableFlags_NoSavedSettings | ImGuiTableFlags_RowBg;
  if (!ImGui::BeginTable("##facts", 1 + static_cast<int>(kRuleCount), flags)) return;
  ImGui::TableSetupColumn("", 0, 1.1f);
  for (std::size_t i = 0; i < kRuleCount; ++i) ImGui::TableSetupColumn("", 0, 1.5f);
  ImGui::TableNextRow();
  cell("Before → after", ink::dim);
  for (const FilterRule rule : kRules) cell(ruleName(rule), ruleColor(rule));
  for (const SeedFact& f : facts) {
    ImGui::TableNextRow();
    cell(f.name, ink::dim);
    for (const std::string& text : f.text) cell(text);
  }
  ImGui::EndTable();
}

std::string change(const BeliefView& before, const BeliefView& after, const char* pattern,
                   float BeliefView::*field) {
  if (!drawable(after)) return "not computed";
  const std::string now = format(pattern, static_cast<double>(after.*field));
  return drawable(before) ? format(pattern, static_cast<double>(before.*field)) + " → " + now : now;
}

std::string truthText(const BeliefView& b, double truth) {
  if (!drawable(b) || !(b.mu > 0)) return "–";
  const double sigmas = (b.mu - truth) / b.sigma;
  return format("%+.2f %%, NEES %.2f", 100 * (truth / b.mu - 1), sigmas * sigmas);
}

void measurementLine(const SeedUpdateView& u, const SeedView* seed, double truth) {
  std::string text = u.tau > 0 ? format("Measured x %.4f ± %.4f 1/map unit", u.x, u.tau)
                               : format("No measurement: %s", searchOutcomeName(u.outcome));
  if (truth > 0)
    text += format(", true distance %.3f map units", 1 / truth);
  else if (seed && seed->true_inv_distance > 0)
    text += format(", true distance %.3f m, no scale yet", 1 / seed->true_inv_distance);
  note(text);
  if (!(u.tau > 0)) return;
  note(format("Belief p, measurement q: KL(p||q) %.3g, KL(q||p) %.3g, JS %.4f nats, w %.3f",
              u.kl_belief_measurement, u.kl_measurement_belief, u.jsd, u.affinity));
}

void charts(PanelContext& c, const ViewedUpdate& v) {
  const FilterGates gates = filterGates(c);
  const float font = ImGui::GetFontSize();
  const TraceColumns columns = traceColumns(*v.trace);
  const bool wide = ImGui::GetContentRegionAvail().x > font * 52;
  const float room = ImGui::GetContentRegionAvail().y;
  const int rows = wide ? 3 : 5;
  const float height =
      std::clamp(std::floor(room / static_cast<float>(rows)) - grid(2), font * 9.5f, font * 17);
  const float gap = grid(2), full = ImGui::GetContentRegionAvail().x,
              half = wide ? std::floor((full - gap) / 2) : full;
  const auto pair = [&] {
    if (wide) ImGui::SameLine(0, gap);
  };
  densityChart(c, v, gates, {full, height});
  beliefHistory(c, v, columns, {full, height});
  sigmaHistory(c, v, columns, gates, {wide ? std::floor((full - 2 * gap) * 0.36f) : half, height});
  pair();
  ratioHistory(c, v, columns, gates, {wide ? std::floor((full - 2 * gap) * 0.32f) : half, height});
  pair();
  ratioDensityChart(v, gates, {wide ? std::floor((full - 2 * gap) * 0.32f) : half, height});
}

}  // namespace

std::vector<SeedFact> seedFacts(const SeedUpdateView& u, double truth) {
  const auto fact = [&](const char* name, const auto& text) {
    SeedFact f{name, {}};
    for (const FilterRule rule : kRules) f.text[rule] = text(u.before[rule], u.after[rule]);
    return f;
  };
  const auto field = [&](const char* name, const char* pattern, float BeliefView::*member) {
    return fact(name, [&](const BeliefView& before, const BeliefView& after) {
      return change(before, after, pattern, member);
    });
  };
  const auto ratio = [](const BeliefView& before, const BeliefView& after) {
    if (!drawable(after)) return std::string("not computed");
    const double then = inlierRatio(before), now = inlierRatio(after);
    return std::isfinite(now) && std::isfinite(then) ? format("%.3f → %.3f", then, now)
                                                     : std::string("–");
  };
  std::vector<SeedFact> facts{field("μ, 1/map unit", "%.5f", &BeliefView::mu),
                              field("σ, 1/map unit", "%.5f", &BeliefView::sigma),
                              field("a", "%.2f", &BeliefView::a),
                              field("b", "%.2f", &BeliefView::b), fact("Inlier ratio", ratio)};
  if (truth > 0)
    facts.push_back(fact("Error of distance", [&](const BeliefView&, const BeliefView& after) {
      return truthText(after, truth);
    }));
  return facts;
}

namespace {

void draw(PanelContext& c) {
  const ViewedUpdate v = viewedUpdate(c);
  if (saysNoSeed(c, v)) return;
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {grid(1), grid(1)});
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {grid(1.5f), grid(0.5f)});
  header(c, v);
  options(c, v);
  const bool held = !v.trace->updates.empty();
  if (held) stepper(c, v);
  ImGui::PopStyleVar(2);
  const SeedView* seed = v.trace->last ? &*v.trace->last : nullptr;
  const double truth = seed ? trueInverseDistance(c, *seed) : 0;
  if (v.update) {
    factsTable(seedFacts(*v.update, truth));
    measurementLine(*v.update, seed, truth);
  }
  if (held) charts(c, v);  // axes without an update would be made up
  if (!c.state.seed.pinned.empty()) pinnedRows(c, filterGates(c));
  saysNoUpdate(c, *v.trace);
}

std::string csv(PanelContext& c) {
  const ViewedUpdate v = viewedUpdate(c);
  return v.trace && !v.trace->updates.empty() ? traceCsv(*v.trace) : std::string();
}

std::vector<PanelOption> scriptOptions() {
  return {stateOption("seed.distance", &UiState::seed, &SeedOptions::distance),
          stateOption("seed.whole_range", &UiState::seed, &SeedOptions::whole_range),
          stateOption("seed.image_follows", &UiState::seed, &SeedOptions::image_follows)};
}

}  // namespace

extern const Panel kSeedPanel{"Seed", draw, csv, /*charts=*/true, scriptOptions};

}  // namespace svoscope::ui
