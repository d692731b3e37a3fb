// SPDX-License-Identifier: MIT
// What the user chose in the panels about the run.
#pragma once

#include <set>
#include <string>

namespace svoscope::ui {

struct PlotsOptions {
  std::set<std::string> groups{"Features", "Time"};  ///< of series, that are shown
};

struct LogOptions {
  std::string filter;  ///< a part of the messages shown, in any case
};

struct ParametersOptions {
  std::string filter;
};

}  // namespace svoscope::ui
