// SPDX-License-Identifier: MIT
#include "ui/model/runs.h"

#include <algorithm>
#include <cstdlib>

#include "engine/base/methods.h"
#include "ui/palette.h"

namespace svoscope::ui {

namespace {

// The first run of a method has the method's looks, all others have their own.
std::vector<RunStyle> stylesOf(const LockstepRunner& lockstep) {
  std::vector<RunStyle> styles;
  std::vector<std::string> seen;
  int others = 0;
  for (int i = 0; i < lockstep.size(); ++i) {
    RunStyle style;
    style.name = lockstep.label(i);
    style.poses_only = lockstep.posesOnly(i);
    style.label = methodName(style.name);
    const std::string& method = lockstep.run(i).info().method;
    const bool first = !style.poses_only && findMethod(method) &&
                       std::find(seen.begin(), seen.end(), method) == seen.end();
    if (first) {
      seen.push_back(method);
      style.color = methodColor(method);
      style.dash = methodLook(method).dash;
    } else {
      style.color = otherRunColor(others);
      style.dash = others % 2 == 0 ? Dash::dashed : Dash::dotted;
      ++others;
    }
    styles.push_back(style);
  }
  return styles;
}

}  // namespace

Runs::Runs(Runner& runner) : runner_(&runner), lockstep_(dynamic_cast<LockstepRunner*>(&runner)) {
  if (lockstep_) {
    styles_ = stylesOf(*lockstep_);
    return;
  }
  const std::string& method = runner.info().method;
  styles_.push_back({methodName(method), method, methodColor(method), Dash::solid, false});
}

Status Runs::setCurrent(int i) {
  if (lockstep_) return lockstep_->setCurrent(i);
  if (i == 0) return Done{};
  return usageError("only one run is open", "", "open more with --method all or --with");
}

std::optional<int> Runs::find(const std::string& name) const {
  for (int i = 0; i < size(); ++i) {
    if (style(i).name == name || style(i).label == name) return i;
  }
  const bool number =
      !name.empty() && name.size() < 4 && name.find_first_not_of("0123456789") == std::string::npos;
  const int i = number ? std::atoi(name.c_str()) : -1;
  if (i < 0 || i >= size()) return std::nullopt;
  return i;
}

int Runs::neighbour(int by) const {
  int i = current();
  do i = (i + by + size()) % size();
  while (style(i).poses_only && i != current());
  return i;
}

int Runs::frame() const {
  if (lockstep_) return lockstep_->frame();
  const SnapshotPtr latest = runner_->latest();
  return latest ? latest->record.index : -1;
}

}  // namespace svoscope::ui
