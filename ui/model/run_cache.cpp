// SPDX-License-Identifier: MIT
#include "ui/model/run_cache.h"

#include <algorithm>
#include <cmath>

#include "ui/palette.h"

namespace svoscope::ui {

namespace {

using R = FrameRecord;

double goodOnly(const R& r, double value) { return r.pose_good ? value : NAN; }

}  // namespace

const std::vector<SeriesInfo>& seriesTable() {
  static const std::vector<SeriesInfo> table{
      {"Features", "Matched", okabe::grey, true, [](const R& r) { return 1.0 * r.funnel.matched; }},
      {"Features", "Inliers", okabe::green, false,
       [](const R& r) { return 1.0 * r.funnel.inliers; }},
      {"Features", "of these seeds", okabe::sky, false,
       [](const R& r) { return 1.0 * r.funnel.inlier_seeds; }},
      {"Features", "of these edgelets", okabe::purple, true,
       [](const R& r) { return 1.0 * r.funnel.inlier_edgelets; }},
      {"Time", "Tracking", okabe::sky, false, [](const R& r) { return r.ms(Stage::tracking); }},
      {"Time", "Mapping", okabe::purple, true, [](const R& r) { return r.ms(Stage::mapping); }},
      {"Map", "Landmarks", okabe::green, false, [](const R& r) { return 1.0 * r.landmarks; }},
      {"Map", "Seeds", okabe::orange, true, [](const R& r) { return 1.0 * r.seeds; }},
      {"Seed updates", "Updates", okabe::grey, true,
       [](const R& r) { return 1.0 * r.seed_updates; }},
      {"Seed updates", "Converged", okabe::sky, false,
       [](const R& r) { return 1.0 * r.seeds_converged; }},
      {"Seed updates", "Rejected", okabe::vermillion, true,
       [](const R& r) { return 1.0 * r.seeds_rejected; }},
      {"Residual", "Reprojection median", okabe::orange, false,
       [](const R& r) { return goodOnly(r, r.reprojection_px); }},
      {"Alignment", "Sparse alignment RMSE", okabe::yellow, false,
       [](const R& r) { return goodOnly(r, r.align_rmse); }},
      {"Depth", "Median depth", okabe::purple, false,
       [](const R& r) { return goodOnly(r, r.median_depth); }},
      {"Brightness", "Gain", okabe::yellow, false,
       [](const R& r) { return r.funnel.aligned_sparse > 0 ? r.gain : NAN; }},
      {"Disparity", "Median disparity", okabe::yellow, false,
       [](const R& r) { return r.disparity_tracks > 0 ? r.disparity_px : NAN; }},
  };
  return table;
}

const std::vector<ChartInfo>& chartTable() {
  static const std::vector<ChartInfo> table{
      {"Features", "Features", true},
      {"Time", "Time, ms", true},
      {"Error", "Position error, m", true},
      {"Map", "Map size", true},
      {"Seed updates", "Seeds per frame", true},
      {"Residual", "Residual, px", true},
      {"Alignment", "Intensity, levels", true},
      {"Depth", "Depth, map units", true},
      {"Brightness", "Brightness gain", false},
      {"Disparity", "Disparity, px", true},
  };
  return table;
}

bool RunCache::update(const Runner& runner) {
  const int generation = runner.generation();
  const bool reset = generation != generation_;
  if (reset) {
    *this = RunCache();
    generation_ = generation;
    columns_.resize(seriesTable().size());
    stages_.resize(kStageCount);
  }
  for (const FrameRecord& r : runner.records(static_cast<int>(records_.size()))) append(r);
  for (const Event& e : runner.events(static_cast<int>(events_.size()))) {
    if (e.kind != EventKind::info) {
      marks_.push_back({static_cast<float>(e.frame_index), eventColor(e.kind), e.text});
    }
    events_.push_back(e);
  }
  return reset;
}

void RunCache::append(const FrameRecord& record) {
  records_.push_back(record);
  frames_.push_back(static_cast<float>(record.index));
  const auto& table = seriesTable();
  for (std::size_t i = 0; i < table.size(); ++i) {
    columns_[i].push_back(static_cast<float>(table[i].value(record)));
  }
  for (int s = 0; s < kStageCount; ++s) {
    stages_[s].push_back(static_cast<float>(record.time_ms[s]));
  }
}

const FrameRecord* RunCache::find(int frame) const {
  const auto it = std::lower_bound(records_.begin(), records_.end(), frame,
                                   [](const FrameRecord& r, int f) { return r.index < f; });
  return it != records_.end() && it->index == frame ? &*it : nullptr;
}

int RunCache::requiredAt(int frame) const {
  // A relocalization needs more: the threshold of tracking is that of frames with a pose before it.
  for (auto r = records_.rbegin(); r != records_.rend(); ++r) {
    if (r->index > frame || !r->pose_good || r->relocalized) continue;
    if (r->funnel.required > 0) return r->funnel.required;
  }
  return 0;
}

}  // namespace svoscope::ui
