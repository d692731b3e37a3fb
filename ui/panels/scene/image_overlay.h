// SPDX-License-Identifier: MIT
// Features, seeds and their histories drawn over an image, and picking among what is drawn.
#pragma once

#include <set>
#include <vector>

#include "engine/snapshot/snapshot.h"
#include "ui/model/ui_state.h"
#include "ui/widgets/image_view.h"

namespace svoscope::ui {

/// Values of the colour ramp in use.
struct ColorScale {
  bool ramp = false;  ///< else categories
  float lo = 0, hi = 1;
  const char* label = "";
};
ColorScale colorScaleOf(const std::vector<FeatureView>& features, ColorBy by);
ImU32 colorOf(const FeatureView& feature, const ColorScale& scale, ColorBy by);

/// Whether the options let the feature be seen.
bool shows(const ImageOptions& options, const FeatureView& feature);
std::string hiddenText(const ImageOptions& options, const Snapshot& snapshot);

/// Values of the seeds' colour ramp; by status there is none.
ColorScale seedScale(SeedColorBy by, int most_updates);
/// Where the seed stands on its ramp, 0 .. 1; NaN if unknown.
float seedRamp(const SeedView& seed, SeedColorBy by, int most_updates);
ImU32 seedColorOf(const SeedView& seed, SeedColorBy by, int most_updates);
int mostUpdates(const Snapshot& snapshot);

/// The line searched in this frame and the place hovered in its score profile.
void drawSearch(const ImageView& view, int frame, const SearchLine& line, const SearchHover& hover);

void drawTrails(const ImageView& view, const std::vector<std::vector<Vec2f>>& trails,
                const Snapshot& snapshot, const ImageOptions& options);
void drawSeeds(const ImageView& view, const Snapshot& snapshot, const ImageOptions& options,
               const Selection& selection, const std::set<std::int64_t>& highlighted,
               const std::vector<std::int64_t>& pinned);
void drawFeatures(const ImageView& view, const Snapshot& snapshot, const ImageOptions& options,
                  const Selection& selection);

/// Nearest visible feature, or else seed, within `radius` screen pixels of `at`.
Selection pick(const ImageView& view, const Snapshot& snapshot, const ImageOptions& options,
               ImVec2 at, float radius);

}  // namespace svoscope::ui
