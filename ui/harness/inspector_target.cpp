// SPDX-License-Identifier: MIT
#include "ui/harness/inspector_target.h"

#include <algorithm>
#include <cstdlib>
#include <utility>
#include <variant>

#include "ui/harness/inspector_options.h"
#include "ui/harness/seed_values.h"
#include "ui/model/seed_trace.h"
#include "ui/panels/panel.h"
#include "ui/widgets/probe.h"

namespace svoscope::ui {
namespace {

Selection::Kind kindOf(FeatureOrigin origin) {
  switch (origin) {
    case FeatureOrigin::landmark:
      return Selection::Kind::landmark;
    case FeatureOrigin::track:
      return Selection::Kind::track;
    default:
      return Selection::Kind::seed;
  }
}

const char* kindName(Selection::Kind kind) {
  switch (kind) {
    case Selection::Kind::landmark:
      return "landmark";
    case Selection::Kind::seed:
      return "seed";
    case Selection::Kind::track:
      return "track";
    default:
      return "none";
  }
}

Error notThere(const std::string& what, int frame, const std::string& remedy) {
  return usageError("frame " + std::to_string(frame) + " has no " + what, "", remedy);
}

std::string listed(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return "known: " + text;
}

Error noSuchPanel(const std::string& name) {
  std::vector<std::string> names;
  for (const Panel* panel : panels()) names.emplace_back(panel->name);
  return usageError("no panel is called '" + name + "'", "", listed(names));
}

bool contains(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

}  // namespace

SnapshotPtr InspectorTarget::shown() const {
  return state_.viewed_frame < 0 && runs_.size() == 1 ? runner_.latest() : runner_.at(shownFrame());
}

Status InspectorTarget::showFrame(int index) {
  const int newest = runs_.frame();
  if (index > newest) {
    return usageError("frame " + std::to_string(index) + " was not processed yet", "",
                      "`run-to " + std::to_string(index) + "` first");
  }
  state_.viewed_frame = index < 0 || index == newest ? -1 : index;
  return Done{};
}

Status InspectorTarget::selectFeature(std::int64_t id) {
  const SnapshotPtr snapshot = shown();
  if (!snapshot) return usageError("there is no frame in view", "", "`step` first");
  const FeatureView* best = nullptr;
  for (const FeatureView& feature : snapshot->features) {
    const bool wanted = id >= 0 ? feature.id == id : feature.status == FeatureStatus::inlier;
    if (wanted && (!best || (id < 0 && feature.observations > best->observations))) best = &feature;
  }
  if (!best) {
    return notThere(id < 0 ? "inlier" : "feature " + std::to_string(id), snapshot->record.index,
                    "`select feature any` takes the one seen most often");
  }
  state_.selection = {kindOf(best->origin), best->id};
  return Done{};
}

Status InspectorTarget::selectSeed(std::int64_t id) {
  const SnapshotPtr snapshot = shown();
  if (!snapshot || !snapshot->seeds) return usageError("there are no seeds in view", "", "");
  const SeedView* best = nullptr;
  for (const SeedView& seed : *snapshot->seeds) {
    const bool wanted = id >= 0 ? seed.id == id : seed.visible;
    if (wanted && (!best || (id < 0 && showsMore(seed, *best, true)))) best = &seed;
  }
  if (!best) {
    return notThere(id < 0 ? "visible seed" : "seed " + std::to_string(id), snapshot->record.index,
                    "`select seed any` takes a visible one");
  }
  state_.selection = {Selection::Kind::seed, best->id};
  return Done{};
}

Status InspectorTarget::selectNothing() {
  state_.selection = {};
  return Done{};
}

std::optional<ImVec2> InspectorTarget::screenPosition(float x, float y) const {
  const std::optional<ProbeRect> area = Probe::find("image:view");
  if (!area) return std::nullopt;
  ImageView view;
  view.lo = area->min;
  view.hi = area->max;
  view.zoom = state_.image.view.zoom > 0 ? state_.image.view.zoom : state_.image_fit;
  view.center = state_.image.view.center;
  const ImVec2 place = view.toScreen({x, y});
  if (!view.onScreen(place, 0)) return std::nullopt;
  return place;
}

Status InspectorTarget::showPanel(const std::string& name) {
  if (name == "all") {
    state_.maximized.clear();
    return Done{};
  }
  if (!findPanel(name)) return noSuchPanel(name);
  if (!hasPanel(state_.layout.root, name)) ui::showPanel(state_.layout.root, name);
  raisePanel(state_.layout.root, name);
  state_.maximized = name;
  return Done{};
}

Status InspectorTarget::panelOnScreen(const std::string& name) const {
  if (!findPanel(name)) return noSuchPanel(name);
  if (!state_.maximized.empty() && state_.maximized != name) {
    return usageError(
        "the panel " + name + " is not on screen: " + state_.maximized + " is shown alone", "",
        "`panel all` first, or `panel " + name + "`");
  }
  if (state_.maximized.empty() && !hasPanel(state_.layout.root, name)) {
    return usageError("the panel " + name + " is not in the layout " + state_.layout.name, "",
                      "`panel " + name + "` shows it alone");
  }
  if (state_.maximized.empty() && !isRaised(state_.layout.root, name)) {
    return usageError("the panel " + name + " is behind its tab", "",
                      "`click tab:" + name + "` first, or `panel " + name + "` to show it alone");
  }
  return Done{};
}

Status InspectorTarget::setLayout(const std::string& name) {
  if (!contains(presetNames(), name)) {
    return usageError("no layout is called '" + name + "'", "", listed(presetNames()));
  }
  state_.layout = presetLayout(name);
  state_.maximized.clear();
  return Done{};
}

Status InspectorTarget::requestExport(const std::string& panel, const std::string& file) {
  if (!findPanel(panel)) return noSuchPanel(panel);
  state_.export_request = ExportRequest{panel, file, true, true};
  state_.export_error = "the panel was not drawn";
  return Done{};
}

Status InspectorTarget::exportResult() const {
  if (state_.export_error.empty()) return Done{};
  return usageError(state_.export_error, "", "");
}

Status InspectorTarget::showRun(const std::string& name) {
  std::vector<std::string> names;
  for (int i = 0; i < runs_.size(); ++i) names.push_back(runs_.style(i).name);
  const std::optional<int> run = runs_.find(name);
  if (!run) return usageError("no run is called '" + name + "'", "", listed(names));
  if (runs_.style(*run).poses_only) {
    return usageError("'" + name + "' has poses only", "", "it is shown in the Compare panels");
  }
  state_.run_request = *run;
  return Done{};
}

const RunView* InspectorTarget::findRun(const std::string& name) const {
  const std::optional<int> run = runs_.find(name);
  return run ? &runs_.run(*run) : nullptr;
}

Status InspectorTarget::set(const std::string& key, const std::string& value) {
  return setOption(state_, key, value);
}

std::optional<ScriptValue> InspectorTarget::value(const std::string& name) const {
  if (name == "selected.id") return ScriptValue(static_cast<double>(state_.selection.id));
  if (name == "selected.kind") return ScriptValue(std::string(kindName(state_.selection.kind)));
  if (name == "panel") return ScriptValue(state_.maximized.empty() ? "all" : state_.maximized);
  if (name == "layout") return ScriptValue(state_.layout.name);
  if (name == "run") return ScriptValue(runs_.style(runs_.current()).name);
  if (name == "runs") {
    std::vector<std::string> names;
    for (int i = 0; i < runs_.size(); ++i) names.push_back(runs_.style(i).name);
    return ScriptValue(names);
  }
  if (name == "live") return ScriptValue(state_.viewed_frame < 0 ? 1.0 : 0.0);
  if (name == "image.zoom") return ScriptValue(static_cast<double>(state_.image.view.zoom));
  if (const auto option = optionValue(state_, name)) return option;
  const SnapshotPtr snapshot = shown();
  return seedValue(snapshot.get(), state_, name);
}

}  // namespace svoscope::ui
