// SPDX-License-Identifier: MIT
// The viewed frame of every run beside each other, zoomed alike.
#include <algorithm>
#include <cmath>

#include "ui/palette.h"
#include "ui/panels/compare/compare_panel.h"
#include "ui/panels/panel.h"
#include "ui/panels/scene/image_overlay.h"
#include "ui/theme.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/probe.h"

namespace svoscope::ui {

namespace {

constexpr std::uint32_t kSlots = 60;  // one texture per run

struct CompareOptions {
  bool features = true, seeds = false;  ///< over the images
  ImageViewState view;                  ///< of all images alike
};

struct Tile {
  int run = 0;
  SnapshotPtr snapshot;
  const FrameRecord* record = nullptr;
  bool hasImage() const {
    return snapshot && snapshot->pyramid && !snapshot->pyramid->empty() &&
           !snapshot->pyramid->front().empty();
  }
};

std::vector<Tile> tilesOf(const PanelContext& c) {
  std::vector<Tile> tiles;
  for (int i = 0; i < c.runs.size(); ++i) {
    if (c.runs.style(i).poses_only) continue;
    tiles.push_back({i, c.runs.run(i).at(c.viewedFrame()),
                     c.all_caches[static_cast<std::size_t>(i)]->run.find(c.viewedFrame())});
  }
  return tiles;
}

void toolbar(CompareOptions& o) {
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {grid(1.5f), grid(0.5f)});
  toggle("Features##compare", o.features, "Features, as the panel Image shows them");
  ImGui::SameLine(0, grid(1));
  toggle("Seeds##compare", o.seeds, "Seeds that project into the image");
  ImGui::PopStyleVar();
}

// As many columns as make the images largest.
int columnsFor(int count, ImVec2 room, float title, int width, int height) {
  int best = 1;
  float largest = 0;
  for (int columns = 1; columns <= count; ++columns) {
    const float rows = std::ceil(static_cast<float>(count) / static_cast<float>(columns));
    const ImVec2 cell{room.x / static_cast<float>(columns), room.y / rows - title};
    const float zoom = fitZoom(width, height, cell);
    if (zoom <= largest) continue;
    largest = zoom;
    best = columns;
  }
  return best;
}

void overlays(PanelContext& c, const ImageView& view, const Tile& tile, int width, int height) {
  const ImVec2 a = view.toScreen({-0.5f, -0.5f});
  const ImVec2 b =
      view.toScreen({static_cast<float>(width) - 0.5f, static_cast<float>(height) - 0.5f});
  ImGui::GetWindowDrawList()->PushClipRect(a, b, true);
  // A selection is of one run: the same number is another feature elsewhere.
  const bool current = tile.run == c.runs.current();
  const Selection selection = current ? c.state.selection : Selection();
  static const std::set<std::int64_t> nothing;
  if (c.options<CompareOptions>().seeds) {
    drawSeeds(view, *tile.snapshot, c.state.image, selection,
              current ? c.state.highlighted : nothing, {});
  }
  if (c.options<CompareOptions>().features)
    drawFeatures(view, *tile.snapshot, c.state.image, selection);
  ImGui::GetWindowDrawList()->PopClipRect();
}

void drawTile(PanelContext& c, const Tile& tile) {
  const RunStyle& style = c.runs.style(tile.run);
  runTitle(c, style, tile.record);
  const bool current = tile.run == c.runs.current();
  if (!tile.hasImage()) {
    const bool had = tile.record && !tile.snapshot;
    emptyState(had           ? "No longer held"
               : tile.record ? "No image"
                             : format("No frame %d", c.viewedFrame()).c_str(),
               had ? "The budget of the history is shared by the runs" : "");
    return;
  }
  const cv::Mat& image = tile.snapshot->pyramid->front();
  const std::string label = "image:" + style.name;
  const ImageView view =
      imageViewArea(label.c_str(), c.options<CompareOptions>().view, image.cols, image.rows);
  const bool smooth = view.zoom < 4;
  const std::uint64_t version = tile.snapshot->sequence_number * 2 + (smooth ? 1 : 0);
  drawImage(view,
            c.graphics.image(kSlots + static_cast<std::uint32_t>(tile.run), image, version, smooth),
            image.cols, image.rows);
  overlays(c, view, tile, image.cols, image.rows);
  if (current) ImGui::GetWindowDrawList()->AddRect(view.lo, view.hi, style.color, 0, 0, dp(1.5f));
  if (!view.clicked) return;
  if (current)
    c.state.selection = pick(view, *tile.snapshot, c.state.image, ImGui::GetIO().MousePos, dp(12));
  else
    c.state.run_request = tile.run;
}

void draw(PanelContext& c) {
  if (!comparing(c)) return;
  toolbar(c.options<CompareOptions>());
  if (c.engineFrame() < 0) {
    return emptyState("No frame yet",
                      "Press Space to play, or the right arrow key to process one frame");
  }
  const std::vector<Tile> tiles = tilesOf(c);
  const ImVec2 room = ImGui::GetContentRegionAvail(), start = ImGui::GetCursorScreenPos();
  const int width = std::max(1, c.info.camera.width), height = std::max(1, c.info.camera.height);
  const float title = ImGui::GetTextLineHeightWithSpacing();
  const int count = static_cast<int>(tiles.size());
  const int columns = columnsFor(count, room, title, width, height),
            rows = (count + columns - 1) / columns;
  const float gap = grid(1);
  const ImVec2 cell{
      std::floor((room.x - gap * static_cast<float>(columns - 1)) / static_cast<float>(columns)),
      std::floor((room.y - gap * static_cast<float>(rows - 1)) / static_cast<float>(rows))};
  if (cell.x < grid(8) || cell.y < grid(8)) return;
  for (int i = 0; i < count; ++i) {
    ImGui::SetCursorScreenPos({start.x + static_cast<float>(i % columns) * (cell.x + gap),
                               start.y + static_cast<float>(i / columns) * (cell.y + gap)});
    ImGui::PushID(i);
    const ImGuiWindowFlags flags =
        ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse;
    if (ImGui::BeginChild("##tile", cell, false, flags))
      drawTile(c, tiles[static_cast<std::size_t>(i)]);
    ImGui::EndChild();
    ImGui::PopID();
  }
}

std::vector<PanelOption> scriptOptions() {
  return {windowOption<CompareOptions>("compare.features", &CompareOptions::features),
          windowOption<CompareOptions>("compare.seeds", &CompareOptions::seeds)};
}

}  // namespace

extern const Panel kCompareImagesPanel{"Compare images", draw, /*csv=*/nullptr,
                                       /*charts=*/false, scriptOptions};

}  // namespace svoscope::ui
