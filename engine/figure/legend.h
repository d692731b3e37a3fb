// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "engine/figure/canvas.h"

namespace svoscope {

/// Places the entries of a legend beside each other, in rows.
class LegendRows {
 public:
  static constexpr double kHeight = 18;  ///< of a row, px

  /// Entries begin at `left` and end before `right` where they can; `swatch`: px before the name.
  LegendRows(double left, double right, double swatch)
      : left_(left), right_(right), swatch_(swatch), next_(left) {}

  /// Where the next entry begins: y counts from the first row.
  FigurePoint place(const std::string& name) {
    const double width = swatch_ + kGlyph * static_cast<double>(name.size()) + kGap;
    if (rows_ == 0) rows_ = 1;
    if (next_ > left_ && next_ + width > right_) {
      next_ = left_;
      ++rows_;
    }
    const FigurePoint at{next_, kHeight * (rows_ - 1)};
    next_ += width;
    return at;
  }

  double height() const { return kHeight * rows_; }

  static constexpr double kGlyph = 6.8;  ///< px, about the width of a letter

 private:
  static constexpr double kGap = 14;

  double left_, right_, swatch_, next_;
  int rows_ = 0;
};

}  // namespace svoscope
