// SPDX-License-Identifier: MIT
// What one epipolar search saw: patches and the score along the line.
#include <algorithm>
#include <cmath>

#include "ui/model/search_cache.h"
#include "ui/model/seed_trace.h"
#include "ui/palette.h"
#include "ui/panels/panel.h"
#include "ui/panels/panel_context.h"
#include "ui/theme.h"
#include "ui/widgets/chart.h"
#include "ui/widgets/icons.h"
#include "ui/widgets/pen.h"
#include "ui/widgets/probe.h"

namespace svoscope::ui {

namespace {

constexpr std::uint32_t kSlots = 40;  // textures of the patches

struct Patch {
  const char* title;
  cv::Mat pixels;
  std::string below;
};

// Nearest-neighbour magnified, titled; gives the square it was drawn in.
ImVec2 drawPatch(PanelContext& c, const Patch& patch, std::uint32_t slot, float side) {
  const float font = ImGui::GetFontSize();
  const ImVec2 at = ImGui::GetCursorScreenPos(), lo{at.x, at.y + font + grid(0.5f)},
               hi{lo.x + side, lo.y + side};
  ImDrawList* list = ImGui::GetWindowDrawList();
  pen::text(list, at, ink::text, patch.title);
  pen::rectFilled(list, lo, hi, ink::canvas);
  if (!patch.pixels.empty()) {
    pen::image(
        list,
        c.graphics.image(kSlots + slot, patch.pixels, c.cache<SearchCache>().version(), false), lo,
        hi, patch.pixels);
  } else {
    const ImVec2 size = ImGui::CalcTextSize("none");
    pen::text(list, {(lo.x + hi.x - size.x) / 2, (lo.y + hi.y - size.y) / 2}, ink::dim, "none");
  }
  pen::rect(list, lo, hi, ink::line);
  const std::string below = wrapped(patch.below, side);
  pen::text(list, {lo.x, hi.y + grid(0.5f)}, ink::dim, below.c_str());
  ImGui::Dummy({side, side + font + grid(1) + ImGui::CalcTextSize(below.c_str()).y});
  Probe::record(std::string("patch:") + patch.title, lo, hi);
  return lo;
}

cv::Mat difference(const cv::Mat& a, const cv::Mat& b) {
  if (a.empty() || a.size() != b.size() || a.type() != CV_8UC1 || b.type() != CV_8UC1) return {};
  double mean_a = 0, mean_b = 0;
  for (int y = 0; y < a.rows; ++y) {
    for (int x = 0; x < a.cols; ++x) {
      mean_a += a.at<unsigned char>(y, x);
      mean_b += b.at<unsigned char>(y, x);
    }
  }
  const double offset = (mean_b - mean_a) / static_cast<double>(a.total());
  cv::Mat d(a.size(), CV_8UC1);
  for (int y = 0; y < a.rows; ++y) {
    for (int x = 0; x < a.cols; ++x) {
      d.at<unsigned char>(y, x) = cv::saturate_cast<unsigned char>(
          128 + b.at<unsigned char>(y, x) - a.at<unsigned char>(y, x) - offset);
    }
  }
  return d;
}

void footprint(const std::vector<Vec2f>& corners, const SeedView& seed, ImVec2 lo, float side,
               int pixels, int level) {
  if (corners.size() != 4 || pixels < 1) return;
  ImDrawList* list = ImGui::GetWindowDrawList();
  const float zoom = side / static_cast<float>(pixels),
              unit = static_cast<float>(1 << std::min(level, 8));
  ImVec2 p[4];
  for (int i = 0; i < 4; ++i) {
    const Vec2f d = (corners[static_cast<std::size_t>(i)] - seed.px_ref) / unit;
    p[i] = {lo.x + side / 2 + d.x() * zoom, lo.y + side / 2 + d.y() * zoom};
  }
  pen::pushClipRect(list, lo, {lo.x + side, lo.y + side}, true);
  pen::polyline(list, p, 4, IM_COL32(0, 0, 0, 170), ImDrawFlags_Closed, dp(3.5f));
  pen::polyline(list, p, 4, okabe::yellow, ImDrawFlags_Closed, dp(1.8f));
  pen::popClipRect(list);
}

void patches(PanelContext& c, const SearchDetail& d, const SeedView& seed, const SeedUpdateView& u,
             float side) {
  const SnapshotPtr searched = c.run.at(u.frame_index);
  const Patch reference{"Reference", d.patch_reference,
                        format("level %d, keyframe %d", seed.level, seed.keyframe_id)};
  const ImVec2 lo = drawPatch(c, reference, 0, side);
  if (searched) {
    footprint(warpedFootprint(seed, u, *searched, c.info.camera, d.search_level), seed, lo, side,
              d.patch_reference.cols, seed.level);
  }
  ImGui::SameLine(0, grid(3));
  drawPatch(c, {"Warped", d.patch_warped, format("search level %d", d.search_level)}, 1, side);
  ImGui::SameLine(0, grid(3));
  drawPatch(c, {"Match", d.patch_match, format("frame %d", u.frame_index)}, 2, side);
  const float next = ImGui::GetItemRectMax().x + grid(3) + side;
  if (next > ImGui::GetWindowPos().x + ImGui::GetWindowContentRegionMax().x) return;
  ImGui::SameLine(0, grid(3));
  drawPatch(c, {"Difference", difference(d.patch_warped, d.patch_match), "grey: equal"}, 3, side);
}

// Samples as columns of the chart, by inverse distance or by pixels from the far end.
struct Profile {
  std::vector<float> x, score;
  bool pixels = false;
};

Profile profileOf(const SearchDetail& d, bool pixels) {
  Profile p;
  p.pixels = pixels;
  for (const SearchSample& s : d.profile) {
    p.x.push_back(pixels ? (s.px - d.profile.front().px).norm() : s.inv_distance);
    p.score.push_back(s.score);
  }
  return p;
}

struct ProfileLine {
  double x;
  LineStyle style;
  std::string label;
};

// Vertical lines of the profile over inverse distance, from left to right.
std::vector<ProfileLine> profileLines(const SeedUpdateView& u, double sigmas) {
  const BeliefView& b = firstComputed(u.before);
  std::vector<ProfileLine> lines{
      {b.mu - sigmas * b.sigma, {ink::dim, 1, true}, format("μ - %gσ", sigmas)},
      {b.mu, {ink::text, 1, true}, "μ"},
      {b.mu + sigmas * b.sigma, {ink::dim, 1, true}, format("μ + %gσ", sigmas)}};
  if (u.tau > 0) lines.push_back({u.x, {ink::measurement, 1.5f, false}, "x ± τ"});
  std::sort(lines.begin(), lines.end(),
            [](const ProfileLine& a, const ProfileLine& b2) { return a.x < b2.x; });
  return lines;
}

void profileMarks(Chart& chart, const SearchDetail& d, const SeedUpdateView& u, const Profile& p,
                  double sigmas) {
  const auto mark = [&](int i, PointShape shape, ImU32 color) {
    if (i >= 0 && i < static_cast<int>(p.x.size())) {
      chart.point(p.x[static_cast<std::size_t>(i)], p.score[static_cast<std::size_t>(i)], shape, 5,
                  color);
    }
  };
  if (p.pixels) {
    if (d.outcome == SearchOutcome::matched) {
      chart.markX((d.px_match - d.profile.front().px).norm(), {ink::measurement, 1.5f, false},
                  "sub-pixel");
    }
  } else {
    if (u.tau > 0) chart.shadeX(u.x - u.tau, u.x + u.tau, withAlpha(ink::measurement, 0.18f));
    for (const ProfileLine& line : profileLines(u, sigmas))
      chart.markX(line.x, line.style, line.label);
  }
  // After the lines: its label makes way for them.
  if (d.max_score > 0)
    chart.markY(d.max_score, {ink::threshold, 1, true}, format("accepted below %g", d.max_score));
  const bool accepted = bestAccepted(d);
  mark(d.second, PointShape::triangle, okabe::orange);
  mark(d.best, accepted ? PointShape::diamond : PointShape::cross,
       accepted ? okabe::sky : ink::threshold);
}

void hoverProfile(PanelContext& c, Chart& chart, const SearchDetail& d, const SeedUpdateView& u,
                  const Profile& p) {
  if (!chart.hovered()) return;
  std::size_t nearest = 0;
  for (std::size_t i = 0; i < p.x.size(); ++i) {
    if (std::abs(p.x[i] - chart.mouseX()) < std::abs(p.x[nearest] - chart.mouseX())) nearest = i;
  }
  const SearchSample& s = d.profile[nearest];
  c.state.search_hover = {true, true, u.frame_index, s.px};
  chart.markX(p.x[nearest], {withAlpha(ink::cursor, 0.6f), 1, false});
  chart.point(p.x[nearest], s.score, PointShape::circle, 3.5f, ink::cursor);
  ImGui::BeginTooltip();
  ImGui::Text("Score %.1f, %s", s.score,
              s.score < d.max_score ? "below the limit" : "above the limit");
  ImGui::Text("%.4f 1/map unit", s.inv_distance);
  if (s.inv_distance > 0) ImGui::Text("%.3f map units", 1 / s.inv_distance);
  ImGui::Text("%.1f, %.1f px", s.px.x(), s.px.y());
  ImGui::EndTooltip();
}

std::string whyNoProfile(const SearchDetail& d) {
  const bool searched = d.outcome == SearchOutcome::matched || d.outcome == SearchOutcome::no_match;
  if (!searched) return format("Not searched: %s", searchOutcomeName(d.outcome));
  const float length = (d.px_near - d.px_far).norm();
  return format(
      "Not scanned: the line is %.1f px long, alignment alone decides. Step to an earlier update "
      "(,) to see "
      "a score profile",
      std::isfinite(length) ? length : 0);
}

void profileChart(PanelContext& c, const SearchDetail& d, const SeedUpdateView& u) {
  const float room = ImGui::GetContentRegionAvail().y, least = ImGui::GetFontSize() * 12;
  if (d.profile.size() < 2) return note(whyNoProfile(d));
  const Profile p = profileOf(d, c.state.seed.profile_in_pixels);
  ChartSpec spec;
  spec.id = "Score profile";
  spec.title = "Zero-mean SSD along the line, grey² per px";
  spec.x_label =
      p.pixels ? "Distance from the far end, px" : "Inverse distance, 1/map unit (far to near)";
  spec.x = padded(finiteRange(p.x.data(), static_cast<int>(p.x.size()), false), 0.03, false);
  const Range y = finiteRange(p.score.data(), static_cast<int>(p.score.size()), false);
  // Above the limit there is room for its label.
  const bool limit = d.max_score > 0 && d.max_score < 4 * y.hi;
  spec.y = {0, std::max(1.08 * y.hi, limit ? 1.25 * d.max_score : 0)};
  spec.size = {0, std::max(least, room - grid(1))};
  spec.mark_rows = p.pixels || !(u.tau > 0) ? 1 : 2;
  const bool accepted = bestAccepted(d);
  spec.legend = {{"score", ink::text, Swatch::line},
                 {bestSampleText(d), accepted ? okabe::sky : ink::threshold,
                  accepted ? Swatch::dot : Swatch::cross}};
  if (d.second >= 0) spec.legend.push_back({"second best", okabe::orange, Swatch::dot});
  if (u.tau > 0) spec.legend.push_back({"sub-pixel result", ink::measurement, Swatch::line});
  Chart chart(spec);
  chart.line(p.x, p.score, {ink::text, 1.5f, false});
  if (p.x.size() < 120) {
    for (std::size_t i = 0; i < p.x.size(); ++i)
      chart.point(p.x[i], p.score[i], PointShape::circle, 1.8f, ink::text);
  }
  profileMarks(chart, d, u, p, filterGates(c).search_sigmas);
  hoverProfile(c, chart, d, u, p);
}

std::string summary(const SearchDetail& d, const SeedUpdateView& u) {
  std::string text = format("Frame %d: %s", u.frame_index, searchOutcomeName(d.outcome));
  const int n = static_cast<int>(d.profile.size());
  if (d.best >= 0 && d.best < n)
    text += format(", best %.0f", d.profile[static_cast<std::size_t>(d.best)].score);
  if (d.second >= 0 && d.second < n) {
    const float best = d.profile[static_cast<std::size_t>(d.best)].score,
                second = d.profile[static_cast<std::size_t>(d.second)].score;
    text += format(", second %.0f", second);
    if (best > 0) text += format(" (%.1f times)", second / best);
  }
  if ((d.px_near - d.px_far).allFinite())
    text += format(", line %.1f px, %d samples", (d.px_near - d.px_far).norm(), n);
  return text;
}

void shareLine(PanelContext& c, const SearchDetail& d, const SeedUpdateView& u) {
  c.state.search_line = {true,     u.frame_index, d.px_near,
                         d.px_far, d.px_match,    d.outcome == SearchOutcome::matched};
}

void draw(PanelContext& c) {
  const ViewedUpdate v = viewedUpdate(c);
  if (saysNoSeed(c, v)) return;
  if (saysNoUpdate(c, *v.trace)) return;
  if (!v.update || !v.trace->last) {
    return emptyState("No search to show",
                      "Nothing that was held so far updated this seed up to the viewed frame");
  }
  const SeedUpdateView& u = *v.update;
  const SearchDetail* d = c.cache<SearchCache>().find(
      c.run, *v.trace->last, u, v.index, v.trace->published[static_cast<std::size_t>(v.index)]);
  if (!d) return emptyState("The search cannot be shown", c.cache<SearchCache>().problem());
  shareLine(c, *d, u);
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {grid(1.5f), grid(0.5f)});
  ImGui::AlignTextToFramePadding();
  ImGui::Text("Seed %lld, update %d of %d", static_cast<long long>(u.seed_id), v.index + 1,
              static_cast<int>(v.trace->updates.size()));
  sameLineIfFits(buttonWidth("Pixels"));
  toggle("Pixels", c.state.seed.profile_in_pixels,
         "Profile over pixels along the line instead of inverse distance");
  sameLineIfFits(buttonWidth("Show frame"));
  const bool held = u.frame_index >= c.status.history_first;
  if (button("Show frame", {"View the frame that was searched",
                            held ? nullptr : "That frame is no longer held"})) {
    const int update = v.index;
    c.view(u.frame_index);
    c.state.seed.update = update;
    c.state.seed.update_frame = c.viewedFrame();
    c.state.seed.update_seed = v.trace->id;
  }
  sameLineIfFits(buttonWidth("Export CSV"));
  if (button("Export CSV", {"The score profile"})) {
    exportText(
        c, format("search_%lld_frame%05d.csv", static_cast<long long>(u.seed_id), u.frame_index),
        profileCsv(*d, u.seed_id, u.frame_index));
  }
  ImGui::PopStyleVar();
  note(summary(*d, u));
  const float room = ImGui::GetContentRegionAvail().y, font = ImGui::GetFontSize();
  const float width = (ImGui::GetContentRegionAvail().x - 3 * grid(3)) / 4;
  const bool profile = d->profile.size() > 1;
  const float share = profile ? 0.34f : 0.8f, most = profile ? 13.0f : 22.0f;
  const float side = std::floor(std::clamp(std::min(room * share, width), font * 5, font * most));
  patches(c, *d, *v.trace->last, u, side);
  profileChart(c, *d, u);
}

std::string csv(PanelContext& c) {
  const ViewedUpdate v = viewedUpdate(c);
  if (!v.trace || !v.update || !v.trace->last) return "";
  const SearchDetail* d =
      c.cache<SearchCache>().find(c.run, *v.trace->last, *v.update, v.index,
                                  v.trace->published[static_cast<std::size_t>(v.index)]);
  return d ? profileCsv(*d, v.update->seed_id, v.update->frame_index) : std::string();
}

std::vector<PanelOption> scriptOptions() {
  return {stateOption("search.pixels", &UiState::seed, &SeedOptions::profile_in_pixels)};
}

}  // namespace

extern const Panel kEpipolarPanel{"Epipolar search", draw, csv, /*charts=*/true, scriptOptions};

}  // namespace svoscope::ui
