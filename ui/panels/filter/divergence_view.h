// SPDX-License-Identifier: MIT
// What the KL / JS panel shows, made again only when the data or the scope changed.
#pragma once

#include <vector>

#include "ui/panels/filter/filter_stats.h"

namespace svoscope::ui {

struct PanelContext;

/// What the user chose in the panel, of each run.
struct DivergenceOptions {
  bool whole_run = true;       ///< else the viewed frame only
  bool brush_changed = false;  ///< the highlighted seeds must be found again
  bool brushed = false;        ///< a rectangle is drawn in the scatter
  double x_lo = 0, x_hi = 0, y_lo = 0, y_hi = 0;
  int generation = -1;  ///< of the run that the rectangle was drawn in
};

struct DivergenceView {
  std::vector<UpdatePoint> points;
  FilterDistributions shown;
  Calibration calibration;
  ByRule<std::vector<float>> steps, median, low, high;  ///< convergence

  void update(PanelContext& c);

 private:
  struct Key {
    std::uint64_t version = 0, truth = 0;
    int frame = -2;
    bool whole_run = true;
    bool operator==(const Key& o) const {
      return version == o.version && truth == o.truth && frame == o.frame &&
             whole_run == o.whole_run;
    }
  };
  Key key_;
};

}  // namespace svoscope::ui
