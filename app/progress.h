// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "engine/base/stopwatch.h"

namespace svoscope {

/// One line on stderr that is rewritten on a terminal (ten times a second at most) and repeated
/// every few seconds elsewhere.
class Progress {
 public:
  Progress();
  ~Progress();  ///< ends the line
  void show(const std::string& text);

 private:
  bool terminal_;
  bool shown_ = false;
  Stopwatch since_;
};

}  // namespace svoscope
