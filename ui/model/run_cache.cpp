// SPDX-License-Identifier: MIT
#include "ui/model/run_cache.h"

#include <algorithm>

#include "engine/snapshot/frame_fields.h"
#include "ui/palette.h"

namespace svoscope::ui {

namespace {

const std::vector<std::size_t>& seriesFields() {
  static const std::vector<std::size_t> fields = [] {
    std::vector<std::size_t> places;
    for (const SeriesInfo& s : seriesTable()) places.push_back(frameFieldIndex(s.field).value());
    return places;
  }();
  return fields;
}

}  // namespace

const std::vector<SeriesInfo>& seriesTable() {
  static const std::vector<SeriesInfo> table{
      {"Features", "Matched", okabe::grey, true, "matched"},
      {"Features", "Inliers", okabe::green, false, "inliers"},
      {"Features", "of these seeds", okabe::sky, false, "inlier_seeds"},
      {"Features", "of these edgelets", okabe::purple, true, "inlier_edgelets"},
      {"Time", "Tracking", okabe::sky, false, "ms_tracking"},
      {"Time", "Mapping", okabe::purple, true, "ms_mapping"},
      {"Map", "Landmarks", okabe::green, false, "landmarks"},
      {"Map", "Seeds", okabe::orange, true, "seeds"},
      {"Seed updates", "Updates", okabe::grey, true, "seed_updates"},
      {"Seed updates", "Converged", okabe::sky, false, "seeds_converged"},
      {"Seed updates", "Rejected", okabe::vermillion, true, "seeds_rejected"},
      {"Residual", "Reprojection median", okabe::orange, false, "reprojection_px"},
      {"Alignment", "Sparse alignment RMSE", okabe::yellow, false, "align_rmse"},
      {"Depth", "Median depth", okabe::purple, false, "median_depth"},
      {"Brightness", "Gain", okabe::yellow, false, "gain"},
      {"Disparity", "Median disparity", okabe::yellow, false, "disparity_px"},
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

bool RunCache::update(const RunView& run) {
  const int generation = run.generation();
  const bool reset = generation != generation_;
  if (reset) {
    *this = RunCache();
    generation_ = generation;
    columns_.resize(seriesTable().size());
    stages_.resize(kStageCount);
  }
  for (const FrameRecord& r : run.records(static_cast<int>(records_.size()))) append(r);
  for (const Event& e : run.events(static_cast<int>(events_.size()))) {
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
  const std::vector<double> numbers = frameNumbers(record);
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    columns_[i].push_back(static_cast<float>(numbers[seriesFields()[i]]));
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
