// SPDX-License-Identifier: MIT
// The odometry methods. A new method is a row of the table: it can then be chosen on the command
// line and in benchmarks, and has its colour and line pattern in the window, figures and reports.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "engine/base/rules.h"

namespace svoscope {

struct MethodInfo {
  const char* id;     ///< "pl-svo": on the command line, in files
  const char* label;  ///< "PL-SVO": for people
  FilterRule rule;    ///< of the depth filter
  bool segments;      ///< uses line segments beside points
  Look look;
};

inline constexpr std::array kMethods{
    MethodInfo{"svo", "SVO", FilterRule::kl, false, {0xe69f00, Dash::dashed}},
    MethodInfo{"pl-svo", "PL-SVO", FilterRule::kl, true, {0xcc79a7, Dash::dotted}},
    MethodInfo{"it-svo", "IT-SVO", FilterRule::js, true, {0x56b4e9, Dash::solid}},
};

/// Where none is asked for.
inline constexpr const char* kDefaultMethod = "it-svo";

/// Null if there is no such method.
const MethodInfo* findMethod(std::string_view id);

/// Colour and pattern of a method; those of the default one for anything else.
Look methodLook(std::string_view id);

/// In the order of the table.
std::vector<std::string> methodIds();

/// "svo, pl-svo or it-svo", for messages.
std::string methodList();

}  // namespace svoscope
