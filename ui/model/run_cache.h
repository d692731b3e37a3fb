// SPDX-License-Identifier: MIT
// Rows and events of the run so far, fetched from the runner a few at a time and kept as columns
// for the plots.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "engine/runner/run_view.h"
#include "ui/widgets/plot.h"

namespace svoscope::ui {

/// One quantity of a frame that can be plotted.
struct SeriesInfo {
  const char* group;  ///< chart it belongs to
  const char* label;
  ImU32 color;
  bool dashed;
  const char* field;  ///< of the record (engine/snapshot/frame_fields.h)
};
const std::vector<SeriesInfo>& seriesTable();

struct ChartInfo {
  const char* group;
  const char* unit_label;  ///< quantity and unit
  bool zero_based;
};
const std::vector<ChartInfo>& chartTable();

class RunCache {
 public:
  /// Fetches what is new. True if the run was reset: everything derived is void.
  bool update(const RunView& run);

  const std::vector<FrameRecord>& records() const { return records_; }
  const std::vector<Event>& events() const { return events_; }
  const std::vector<float>& frames() const { return frames_; }  ///< x of every column
  const std::vector<float>& column(std::size_t series) const { return columns_[series]; }
  const std::vector<float>& stage(Stage stage) const { return stages_[static_cast<int>(stage)]; }
  const std::vector<PlotMark>& marks() const { return marks_; }
  /// Row of a frame; null if it was not processed.
  const FrameRecord* find(int frame) const;
  /// Inliers below which tracking is lost, as of the last frame up to this one that was held
  /// against them; 0 if none was.
  int requiredAt(int frame) const;
  int generation() const { return generation_; }

 private:
  void append(const FrameRecord& record);

  int generation_ = -1;
  std::vector<FrameRecord> records_;
  std::vector<Event> events_;
  std::vector<float> frames_;
  std::vector<std::vector<float>> columns_, stages_;
  std::vector<PlotMark> marks_;
};

}  // namespace svoscope::ui
