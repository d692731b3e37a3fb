// SPDX-License-Identifier: MIT
#include "ui/harness/seed_values.h"

#include "ui/model/selection_history.h"

namespace svoscope::ui {
namespace {

ScriptValue number(double value) { return value; }

std::optional<ScriptValue> beliefValue(const BeliefView& b, const std::string& name) {
  if (name == "mu") return number(b.mu);
  if (name == "sigma") return number(b.sigma);
  if (name == "a") return number(b.a);
  if (name == "b") return number(b.b);
  if (name == "ratio") return number(b.a / (b.a + b.b));
  return std::nullopt;
}

std::optional<ScriptValue> fieldValue(const SeedView& s, const std::string& name) {
  const auto dot = name.find('.');
  for (const FilterRule rule : kRules) {
    if (dot != std::string::npos && name.substr(0, dot) == ruleInfo(rule).id)
      return beliefValue(s.belief[rule], name.substr(dot + 1));
  }
  if (name == "id") return number(static_cast<double>(s.id));
  if (name == "updates") return number(s.updates);
  if (name == "failures") return number(s.failures);
  if (name == "range") return number(s.range);
  if (name == "x") return number(s.last_x);
  if (name == "tau") return number(s.last_tau);
  if (name == "keyframe") return number(s.keyframe_id);
  if (name == "visible") return number(s.visible);
  if (name == "px_x") return number(s.px.x());
  if (name == "px_y") return number(s.px.y());
  if (name == "status") return ScriptValue(std::string(seedStatusName(s.status)));
  if (name == "outcome") return ScriptValue(std::string(searchOutcomeName(s.outcome)));
  return beliefValue({s.mu, s.sigma, s.a, s.b}, name);
}

}  // namespace

std::optional<ScriptValue> seedValue(const Snapshot* snapshot, const UiState& state,
                                     const std::string& name) {
  if (name == "highlighted") return number(static_cast<double>(state.highlighted.size()));
  if (name == "pinned") return number(static_cast<double>(state.seed.pinned.size()));
  if (name == "seed.update") return number(state.seed.shown_update);
  if (name == "seed.held") return number(state.seed.held_updates);
  if (name.rfind("seed.", 0) != 0 || !snapshot || state.selection.kind != Selection::Kind::seed)
    return std::nullopt;
  const SeedView* seed = findSeed(*snapshot, state.selection.id);
  if (!seed) return std::nullopt;
  return fieldValue(*seed, name.substr(5));
}

}  // namespace svoscope::ui
