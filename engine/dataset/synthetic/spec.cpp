// SPDX-License-Identifier: MIT
#include "engine/dataset/synthetic/spec.h"

#include <cmath>
#include <optional>

#include "engine/base/text_rows.h"

namespace svoscope {
namespace {

std::string known(const char* what, const std::vector<NamedText>& list) {
  std::string text = std::string(what) + " are ";
  for (size_t i = 0; i < list.size(); ++i) text += (i ? ", " : "") + list[i].name;
  return text;
}

std::vector<std::string> splitAt(const std::string& text, char separator) {
  std::vector<std::string> parts(1);
  for (char c : text) {
    if (c == separator)
      parts.emplace_back();
    else
      parts.back() += c;
  }
  return parts;
}

struct Range {
  double low, high;
};

std::optional<double> numberIn(const std::string& value, Range range) {
  const auto number = parseNumber(value);
  if (!number || !(*number >= range.low && *number <= range.high)) return std::nullopt;
  return number;
}

std::optional<int> integerIn(const std::string& value, Range range) {
  const auto number = numberIn(value, range);
  if (!number || std::floor(*number) != *number) return std::nullopt;
  return static_cast<int>(*number);
}

template <typename T>
bool store(const std::optional<T>& value, T& target) {
  if (value) target = *value;
  return value.has_value();
}

/// Two integers "A:B" or "AxB".
bool storePair(const std::string& value, char separator, Range first, Range second, int& a,
               int& b) {
  const auto parts = splitAt(value, separator);
  return parts.size() == 2 && store(integerIn(parts[0], first), a) &&
         store(integerIn(parts[1], second), b);
}

bool storeSeed(const std::string& value, std::uint64_t& seed) {
  const auto number = integerIn(value, {0, 2147483647});
  if (number) seed = static_cast<std::uint64_t>(*number);
  return number.has_value();
}

/// False if the value is not acceptable.
bool setOption(SyntheticSpec& spec, const std::string& name, const std::string& value) {
  if (name == "frames") return store(integerIn(value, {1, 100000}), spec.frames);
  if (name == "noise") return store(numberIn(value, {0, 50}), spec.noise);
  if (name == "blur") return store(numberIn(value, {0, 1}), spec.blur);
  if (name == "step") return store(numberIn(value, {1, 3}), spec.step);
  if (name == "light") return store(numberIn(value, {0, 3}), spec.light);
  if (name == "occlude") return store(numberIn(value, {0, 0.9}), spec.occlude);
  if (name == "movers") return store(integerIn(value, {0, 12}), spec.movers);
  if (name == "texture") return store(numberIn(value, {0, 1}), spec.texture);
  if (name == "travel") return store(numberIn(value, {0, 1}), spec.travel);
  if (name == "speed") return store(numberIn(value, {0, 10}), spec.speed);
  if (name == "seed") return storeSeed(value, spec.seed);
  if (name == "blackout")
    return storePair(value, ':', {0, 100000}, {1, 100000}, spec.blackout_first,
                     spec.blackout_count);
  return storePair(value, 'x', {32, 4096}, {32, 4096}, spec.width, spec.height);  // size
}

const NamedText* find(const std::vector<NamedText>& list, const std::string& name) {
  for (const NamedText& item : list)
    if (item.name == name) return &item;
  return nullptr;
}

}  // namespace

const std::vector<NamedText>& syntheticPresets() {
  static const std::vector<NamedText> presets = {
      {"room", "hand-held camera circling boxes in a room"},
      {"floor", "flight over a floor with low boxes, looking down, 752 x 480"},
      {"desk", "translation along the axes in front of a desk"},
      {"corridor", "walk along a corridor: blank walls, long edges"},
      {"spin", "turning on the spot in a room, little translation"},
      {"still", "the room from a camera that stands still"},
      {"forward", "drive along a street, 0.8 m per frame at 10 Hz"}};
  return presets;
}

const std::vector<NamedText>& syntheticOptions() {
  static const std::vector<NamedText> options = {
      {"frames", "number of frames, 1..100000, default 300"},
      {"noise", "image noise, standard deviation in grey levels, 0..50, default 1.5"},
      {"blur", "motion blur: exposure as a fraction of the frame interval, 0..1, default 0"},
      {"step", "brightness steps every 25 frames by exactly this ratio, 1..3, default 1"},
      {"light", "brightness steps every 25 frames by ratios up to 1.3^light, 0..3, default 0"},
      {"occlude", "fraction of the image covered by a moving object, 0..0.9, default 0"},
      {"movers", "textured boxes that move through the scene, 0..12, default 0"},
      {"texture", "contrast of all surfaces, 0..1, default 1"},
      {"blackout", "FIRST:COUNT, frames that are black"},
      {"travel", "fraction of the camera's translation that is left, 0..1, default 1"},
      {"speed", "motion of the camera is this many times as fast, 0..10, default 1"},
      {"seed", "other textures, layout and noise, 0..2147483647, default 1"},
      {"size", "WIDTHxHEIGHT in pixels, 32..4096; focal length and texture detail follow"}};
  return options;
}

Result<SyntheticSpec> parseSyntheticSpec(const std::string& text) {
  const std::string prefix = "synthetic:";
  const size_t question = text.find('?');
  SyntheticSpec spec;
  spec.text = text;
  if (text.rfind(prefix, 0) == 0)
    spec.preset =
        text.substr(prefix.size(),
                    question == std::string::npos ? std::string::npos : question - prefix.size());
  if (!find(syntheticPresets(), spec.preset))
    return usageError("unknown synthetic sequence '" + spec.preset + "'", text,
                      known("presets", syntheticPresets()));
  if (spec.preset == "floor") spec.width = 752;
  if (spec.preset == "forward") spec.rate_hz = 10;
  if (question == std::string::npos) return spec;
  for (const std::string& part : splitAt(text.substr(question + 1), '&')) {
    const size_t equals = part.find('=');
    const std::string name = part.substr(0, equals);
    const NamedText* option = find(syntheticOptions(), name);
    if (!option)
      return usageError("unknown option '" + name + "'", text,
                        known("options", syntheticOptions()));
    if (equals == std::string::npos || !setOption(spec, name, part.substr(equals + 1)))
      return usageError("'" + part + "' has no valid value", text, name + ": " + option->text);
  }
  return spec;
}

}  // namespace svoscope
