// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "ui/palette.h"
#include "ui/panels/panel.h"
#include "ui/panels/panel_context.h"
#include "ui/panels/scene/image_overlay.h"
#include "ui/panels/scene/trails.h"
#include "ui/theme.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/icons.h"

namespace svoscope::ui {

namespace {

constexpr std::uint32_t kSlot = 1;

void levelChoice(PanelContext& c, int levels) {
  std::vector<std::string> names;
  for (int i = 0; i < levels; ++i) names.push_back(format("Level %d", i));
  std::vector<const char*> items;
  for (const auto& n : names) items.push_back(n.c_str());
  c.state.image.level = std::clamp(c.state.image.level, 0, std::max(0, levels - 1));
  combo("##level", c.state.image.level, items, ImGui::GetFontSize() * 5.5f, "Pyramid level shown");
}

void toolbar(PanelContext& c, int levels) {
  ImageOptions& o = c.state.image;
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {grid(1), grid(1)});
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {grid(1.5f), grid(0.5f)});
  levelChoice(c, levels);
  static const std::vector<const char*> colors{"Origin",       "Status",   "Depth",
                                               "Observations", "Residual", "Level"};
  int by = static_cast<int>(o.color_by);
  ImGui::SameLine();
  if (combo("##color_by", by, colors, ImGui::GetFontSize() * 7.5f, "Colour of the features")) {
    o.color_by = static_cast<ColorBy>(by);
  }
  static const std::vector<const char*> seed_colors{"Seed status", "Seed σ / R", "Seed ratio",
                                                    "Seed age", "KL / JS apart"};
  int seed_by = static_cast<int>(o.seed_color);
  sameLineIfFits(ImGui::GetFontSize() * 8);
  if (combo("##seed_color", seed_by, seed_colors, ImGui::GetFontSize() * 8,
            "Colour of the seeds")) {
    o.seed_color = static_cast<SeedColorBy>(seed_by);
  }
  OptionBar bar(shortOfRoom());
  bar.item("Corners", o.corners, "Corner features, squares as large as their level");
  bar.item("Edgelets", o.edgelets, "Edgelets, lines along the edge with a tick along the gradient");
  bar.item("Segments", o.segments, "Line segments");
  bar.item("Outliers", o.outliers, "Aligned, but rejected by pose refinement");
  bar.item("Failed", o.not_aligned, "Projected into the image, but feature alignment failed");
  bar.item("Residuals", o.residuals, "Sticks from measured towards predicted position, scaled");
  if (o.residuals && bar.visible()) {
    if (!bar.compact()) sameLineIfFits(ImGui::GetFontSize() * 4);
    slider("##residual_scale", o.residual_scale, 1, 50, "x%.0f", ImGui::GetFontSize() * 4,
           "Scale of the residual sticks");
  }
  bar.item("Predicted", o.predicted, "Crosses at the predicted positions");
  bar.item("Trails", o.trails, "Positions in the frames before");
  bar.item("Seeds", o.seeds, "Seeds that project into the image");
  bar.item("Spans", o.spans, "Where the seed may lie on its epipolar line, near to far");
  bar.item("Tracks", o.tracks, "Tracks of the two-view start");
  bar.item("Ids", o.ids, "Ids as text");
  ImGui::PopStyleVar(2);
}

// On a dark ground, readable on any image.
void darkText(ImVec2 at, ImU32 color, const std::string& text) {
  const ImVec2 size = ImGui::CalcTextSize(text.c_str());
  ImDrawList* list = ImGui::GetWindowDrawList();
  list->AddRectFilled({at.x - grid(1), at.y - grid(0.25f)},
                      {at.x + size.x + grid(1), at.y + size.y + grid(0.25f)},
                      IM_COL32(0, 0, 0, 170), dp(3));
  list->AddText(at, color, text.c_str());
}

// Text lines over the lower left corner of the view.
struct Corner {
  ImVec2 at;
  void line(const std::string& text, ImU32 color = ink::text) {
    at.y -= ImGui::GetTextLineHeight() + grid(1);
    darkText(at, color, text);
  }
};

// In the lower right corner; `aside`: that far to the left of it, or above it if negative.
void colorBar(const ImageView& view, const ColorScale& scale, float aside) {
  ImDrawList* list = ImGui::GetWindowDrawList();
  const float width = grid(40), height = grid(2);
  const float up = aside < 0 ? 2 * ImGui::GetTextLineHeight() + grid(6) : 0;
  const ImVec2 hi{view.hi.x - grid(2) - std::max(0.0f, aside),
                  view.hi.y - grid(2) - ImGui::GetTextLineHeight() - up};
  const ImVec2 lo{hi.x - width, hi.y - height};
  list->AddRectFilled({lo.x - grid(2), lo.y - ImGui::GetTextLineHeight() - grid(2)},
                      {hi.x + grid(2), hi.y + ImGui::GetTextLineHeight() + grid(2)},
                      IM_COL32(0, 0, 0, 150), dp(3));
  constexpr int kSteps = 32;
  for (int i = 0; i < kSteps; ++i) {
    const float a = static_cast<float>(i) / kSteps, b = static_cast<float>(i + 1) / kSteps;
    list->AddRectFilled({lo.x + a * width, lo.y}, {lo.x + b * width, hi.y},
                        viridis(0.15f + 0.85f * a));
  }
  list->AddText({lo.x, lo.y - ImGui::GetTextLineHeight() - grid(0.5f)}, ink::text, scale.label);
  const std::string left = format("%.3g", scale.lo), right = format("%.3g", scale.hi);
  list->AddText({lo.x, hi.y + grid(0.5f)}, ink::dim, left.c_str());
  list->AddText({hi.x - ImGui::CalcTextSize(right.c_str()).x, hi.y + grid(0.5f)}, ink::dim,
                right.c_str());
}

struct LegendItem {
  ImU32 color;
  Swatch kind;
  std::string text;
};

std::vector<LegendItem> legendItems(const Snapshot& s, const ImageOptions& o) {
  int counts[4] = {}, outliers = 0, failed = 0, followed = 0;
  for (const FeatureView& f : s.features) {
    if (!shows(o, f)) continue;
    if (f.status == FeatureStatus::outlier)
      ++outliers;
    else if (f.status == FeatureStatus::not_aligned)
      ++failed;
    else if (f.status == FeatureStatus::followed)
      ++followed;
    else
      ++counts[static_cast<int>(f.origin)];
  }
  std::vector<LegendItem> items;
  for (int i = 0; i < 4; ++i) {
    const auto origin = static_cast<FeatureOrigin>(i);
    if (counts[i] == 0) continue;
    items.push_back({o.color_by == ColorBy::status ? okabe::green : originColor(origin),
                     Swatch::square, format("%s %d", originName(origin), counts[i])});
  }
  if (followed) items.push_back({okabe::purple, Swatch::square, format("Followed %d", followed)});
  if (outliers) items.push_back({okabe::vermillion, Swatch::cross, format("Outlier %d", outliers)});
  if (failed) items.push_back({okabe::grey, Swatch::ring, format("Not aligned %d", failed)});
  return items;
}

void legend(const ImageView& view, const Snapshot& s, const ImageOptions& o) {
  const auto items = legendItems(s, o);
  if (items.empty()) return;
  float width = 0;
  for (const auto& i : items) width = std::max(width, legendWidth(i.text.c_str()));
  const float line = ImGui::GetTextLineHeight() + grid(0.5f);
  const ImVec2 lo{view.hi.x - width - grid(4),
                  view.hi.y - line * static_cast<float>(items.size()) - grid(3)};
  const bool small =
      lo.x < view.lo.x + grid(40) || lo.y < view.lo.y + 0.55f * (view.hi.y - view.lo.y);
  if (small) return;  // the image matters more
  ImDrawList* list = ImGui::GetWindowDrawList();
  list->AddRectFilled(lo, {view.hi.x - grid(1), view.hi.y - grid(1)}, IM_COL32(0, 0, 0, 150),
                      dp(3));
  ImVec2 at{lo.x + grid(1.5f), lo.y + grid(1)};
  for (const auto& i : items) {
    drawSwatch(i.kind, {at.x + grid(1), at.y + ImGui::GetTextLineHeight() / 2}, grid(1), i.color);
    list->AddText({at.x + grid(3.5f), at.y}, ink::text, i.text.c_str());
    at.y += line;
  }
}

void notes(PanelContext& c, const ImageView& view, const Snapshot& s, const cv::Mat& level,
           int shift) {
  Corner corner{{view.lo.x + grid(2), view.hi.y - grid(1)}};
  const std::string hidden = hiddenText(c.state.image, s);
  if (!hidden.empty()) corner.line(hidden, okabe::orange);
  if (s.record.state == TrackingState::initializing && s.record.disparity_tracks > 0) {
    corner.line(format("Two-view start  %d tracks, median disparity %.1f px",
                       s.record.disparity_tracks, s.record.disparity_px),
                okabe::yellow);
  }
  if (s.record.state == TrackingState::lost) corner.line(stateSentence(s.record), okabe::orange);
  if (!view.hovered || level.empty()) return;
  const float k = 1.0f / static_cast<float>(1 << shift);
  const int x = static_cast<int>(std::floor((view.mouse.x() + 0.5f) * k));
  const int y = static_cast<int>(std::floor((view.mouse.y() + 0.5f) * k));
  if (x < 0 || y < 0 || x >= level.cols || y >= level.rows) return;
  const std::string text =
      format("%.1f, %.1f  grey %d  zoom %.2g", view.mouse.x(), view.mouse.y(),
             level.type() == CV_8UC1 ? level.at<unsigned char>(y, x) : 0, view.zoom);
  darkText({view.lo.x + grid(2), view.lo.y + grid(1)}, ink::text, text);
}

// Overlays end at the image's border: beside it there is nothing they could refer to.
void pushImageClip(const ImageView& view, int width, int height) {
  const ImVec2 a = view.toScreen({-0.5f, -0.5f});
  const ImVec2 b =
      view.toScreen({static_cast<float>(width) - 0.5f, static_cast<float>(height) - 0.5f});
  ImGui::GetWindowDrawList()->PushClipRect(
      {std::max(a.x, view.lo.x), std::max(a.y, view.lo.y)},
      {std::max(a.x, std::min(b.x, view.hi.x)), std::max(a.y, std::min(b.y, view.hi.y))}, true);
}

void viewBody(PanelContext& c, const Snapshot& s) {
  const auto& levels = *s.pyramid;
  ImageOptions& o = c.state.image;
  const cv::Mat& level = levels[static_cast<std::size_t>(o.level)];
  const int width = levels[0].cols, height = levels[0].rows;
  const ImVec2 room = ImGui::GetContentRegionAvail();
  c.state.image_fit = fitZoom(width, height, room);
  const ImageView view = imageViewArea("image:view", o.view, width, height);
  const std::uint64_t version = s.sequence_number * 16 + static_cast<std::uint64_t>(o.level);
  const bool smooth = view.zoom < 4;
  drawImage(view, c.graphics.image(kSlot, level, version * 2 + (smooth ? 1 : 0), smooth), width,
            height);
  pushImageClip(view, width, height);
  if (o.trails) drawTrails(view, c.cache<Trails>().update(c.run, s, o.trail_frames), s, o);
  drawSeeds(view, s, o, c.state.selection, c.state.highlighted, c.state.seed.pinned);
  drawFeatures(view, s, o, c.state.selection);
  drawSearch(view, s.record.index, c.state.search_line, c.state.search_hover);
  ImGui::GetWindowDrawList()->PopClipRect();
  ImGui::GetWindowDrawList()->PushClipRect(view.lo, view.hi, true);
  const ColorScale scale = colorScaleOf(s.features, o.color_by);
  if (scale.ramp)
    colorBar(view, scale, 0);
  else
    legend(view, s, o);
  if (o.seeds && o.seed_color != SeedColorBy::status) {
    colorBar(view, seedScale(o.seed_color, mostUpdates(s)),
             view.hi.x - view.lo.x > grid(100) ? grid(48) : -1);
  }
  notes(c, view, s, level, o.level);
  ImGui::GetWindowDrawList()->PopClipRect();
  if (view.clicked) c.state.selection = pick(view, s, o, ImGui::GetIO().MousePos, dp(12));
}

void draw(PanelContext& c) {
  const bool has_image = c.snapshot && c.snapshot->pyramid && !c.snapshot->pyramid->empty() &&
                         !c.snapshot->pyramid->front().empty();
  toolbar(c, has_image ? static_cast<int>(c.snapshot->pyramid->size()) : 1);
  if (saysWhyEmpty(c)) return;
  if (!has_image)
    return emptyState("This frame has no image", "Its numbers are in the other panels");
  viewBody(c, *c.snapshot);
}

std::string csv(PanelContext& c) {
  if (!c.snapshot) return "";
  std::string text = "id,type,origin,status,level,x,y,x_end,y_end,depth,residual_px,observations\n";
  for (const FeatureView& f : c.snapshot->features) {
    text +=
        format("%lld,%s,%s,%s,%d,%.3f,%.3f,", static_cast<long long>(f.id), featureTypeName(f.type),
               originName(f.origin), statusName(f.status), f.level, f.px.x(), f.px.y());
    text += f.type == FeatureType::segment ? format("%.3f,%.3f", f.px_end.x(), f.px_end.y()) : ",";
    text += format(",%.6g,%.4g,%d\n", f.depth, f.residual_px, f.observations);
  }
  return text;
}

std::vector<PanelOption> scriptOptions() {
  const auto item = [](const char* name, auto field) {
    return stateOption(name, &UiState::image, field);
  };
  using O = ImageOptions;
  return {
      item("image.level", &O::level),           item("image.color_by", &O::color_by),
      item("image.seed_color", &O::seed_color), item("image.corners", &O::corners),
      item("image.edgelets", &O::edgelets),     item("image.segments", &O::segments),
      item("image.outliers", &O::outliers),     item("image.not_aligned", &O::not_aligned),
      item("image.residuals", &O::residuals),   item("image.residual_scale", &O::residual_scale),
      item("image.predicted", &O::predicted),   item("image.ids", &O::ids),
      item("image.trails", &O::trails),         item("image.seeds", &O::seeds),
      item("image.spans", &O::spans),           item("image.tracks", &O::tracks)};
}

}  // namespace

extern const Panel kImagePanel{"Image", draw, csv, /*charts=*/false, scriptOptions};

}  // namespace svoscope::ui
