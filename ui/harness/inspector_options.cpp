// SPDX-License-Identifier: MIT
#include "ui/harness/inspector_options.h"

#include <cstdlib>
#include <functional>
#include <map>

namespace svoscope::ui {
namespace {

struct Option {
  std::function<double(const UiState&)> get;
  std::function<void(UiState&, double)> set;
};

/// Reads and writes one member of one part of the state as a number; choices count from 0.
template <typename Part, typename T>
Option member(Part UiState::*part, T Part::*field) {
  return {[=](const UiState& s) { return static_cast<double>(s.*part.*field); },
          [=](UiState& s, double v) { s.*part.*field = static_cast<T>(v); }};
}

template <typename T>
Option member(T UiState::*field) {
  return {[=](const UiState& s) { return static_cast<double>(s.*field); },
          [=](UiState& s, double v) { s.*field = static_cast<T>(v); }};
}

const std::map<std::string, Option>& options() {
  constexpr auto image = &UiState::image;
  constexpr auto scene = &UiState::scene;
  static const std::map<std::string, Option> table = {
      {"image.level", member(image, &ImageOptions::level)},
      {"image.color_by", member(image, &ImageOptions::color_by)},
      {"image.seed_color", member(image, &ImageOptions::seed_color)},
      {"seed.distance", member(&UiState::seed, &SeedOptions::distance)},
      {"seed.whole_range", member(&UiState::seed, &SeedOptions::whole_range)},
      {"seed.image_follows", member(&UiState::seed, &SeedOptions::image_follows)},
      {"search.pixels", member(&UiState::seed, &SeedOptions::profile_in_pixels)},
      {"divergence.whole_run", member(&UiState::divergence, &DivergenceOptions::whole_run)},
      {"lab.section", member(&UiState::lab_section)},
      {"lab.wait", member(&UiState::lab_wait)},
      {"lab.mu", member(&UiState::lab, &LabSettings::mu)},
      {"lab.sigma", member(&UiState::lab, &LabSettings::sigma)},
      {"lab.offset", member(&UiState::lab, &LabSettings::offset)},
      {"lab.tau", member(&UiState::lab, &LabSettings::tau)},
      {"lab.baseline", member(&UiState::lab, &LabSettings::baseline)},
      {"lab.depth", member(&UiState::lab, &LabSettings::depth)},
      {"lab.pixel_noise", member(&UiState::lab, &LabSettings::pixel_noise)},
      {"lab.seeds", member(&UiState::lab, &LabSettings::seeds)},
      {"lab.outliers", member(&UiState::lab, &LabSettings::outliers)},
      {"lab.hopeless", member(&UiState::lab, &LabSettings::hopeless)},
      {"image.corners", member(image, &ImageOptions::corners)},
      {"image.edgelets", member(image, &ImageOptions::edgelets)},
      {"image.segments", member(image, &ImageOptions::segments)},
      {"image.outliers", member(image, &ImageOptions::outliers)},
      {"image.not_aligned", member(image, &ImageOptions::not_aligned)},
      {"image.residuals", member(image, &ImageOptions::residuals)},
      {"image.residual_scale", member(image, &ImageOptions::residual_scale)},
      {"image.predicted", member(image, &ImageOptions::predicted)},
      {"image.ids", member(image, &ImageOptions::ids)},
      {"image.trails", member(image, &ImageOptions::trails)},
      {"image.seeds", member(image, &ImageOptions::seeds)},
      {"image.spans", member(image, &ImageOptions::spans)},
      {"image.tracks", member(image, &ImageOptions::tracks)},
      {"scene.color_by", member(scene, &SceneOptions::color_by)},
      {"scene.points", member(scene, &SceneOptions::points)},
      {"scene.keyframes", member(scene, &SceneOptions::keyframes)},
      {"scene.estimate", member(scene, &SceneOptions::estimate)},
      {"scene.ground_truth", member(scene, &SceneOptions::ground_truth)},
      {"scene.seeds", member(scene, &SceneOptions::seeds)},
      {"scene.grid", member(scene, &SceneOptions::grid)},
      {"scene.follow", member(scene, &SceneOptions::follow)},
      {"scene.point_size", member(scene, &SceneOptions::point_size)},
      {"scene.distance", member(scene, &SceneOptions::distance)},
      {"scene.yaw", member(scene, &SceneOptions::yaw)},
      {"scene.pitch", member(scene, &SceneOptions::pitch)},
      {"compare.features", member(&UiState::compare, &CompareOptions::features)},
      {"compare.seeds", member(&UiState::compare, &CompareOptions::seeds)},
      {"compare.grid", member(&UiState::compare_scene, &SceneOptions::grid)},
      {"compare.yaw", member(&UiState::compare_scene, &SceneOptions::yaw)},
      {"compare.pitch", member(&UiState::compare_scene, &SceneOptions::pitch)},
      {"help", member(&UiState::show_help)},
      {"align_mode", member(&UiState::align_mode)},
  };
  return table;
}

std::optional<double> asNumber(const std::string& text) {
  if (text == "on" || text == "true" || text == "yes") return 1;
  if (text == "off" || text == "false" || text == "no") return 0;
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  if (text.empty() || *end != '\0') return std::nullopt;
  return value;
}

}  // namespace

Status setOption(UiState& state, const std::string& name, const std::string& value) {
  const auto option = options().find(name);
  if (option == options().end()) {
    std::string known;
    for (const auto& [key, unused] : options()) known += (known.empty() ? "" : ", ") + key;
    return usageError("no parameter or option is called '" + name + "'", "",
                      "options: " + known + "; parameters: those of the panel Parameters");
  }
  const std::optional<double> number = asNumber(value);
  if (!number) return usageError("'" + value + "' is neither a number nor on or off", "", "");
  option->second.set(state, *number);
  return Done{};
}

std::optional<ScriptValue> optionValue(const UiState& state, const std::string& name) {
  const auto option = options().find(name);
  if (option == options().end()) return std::nullopt;
  return ScriptValue(option->second.get(state));
}

}  // namespace svoscope::ui
