// SPDX-License-Identifier: MIT
#include "engine/study/stress_table.h"

#include <fmt/format.h>

namespace svoscope {

namespace {

/// What is written after "synthetic:PRESET?" for each strength.
struct Row {
  const char* name;
  const char* meaning;
  const char* preset;
  std::vector<std::pair<const char*, const char*>> levels;  ///< strength, options
};

// Blackout: MID is the middle of the sequence, where the camera is back near a view of the start.
const std::vector<Row>& rows() {
  static const std::vector<Row> table = {
      {"speed",
       "motion so many times as fast",
       "room",
       {{"x1", "speed=1"},
        {"x2", "speed=2"},
        {"x3", "speed=3"},
        {"x4", "speed=4"},
        {"x8", "speed=8"}}},
      {"blur",
       "motion blur, exposure as a fraction of the frame interval, at twice the speed",
       "room",
       {{"0.25", "speed=2&blur=0.25"},
        {"0.5", "speed=2&blur=0.5"},
        {"0.75", "speed=2&blur=0.75"},
        {"1", "speed=2&blur=1"}}},
      {"light",
       "brightness steps by this ratio every 25 frames",
       "room",
       {{"1.15", "step=1.15"},
        {"1.3", "step=1.3"},
        {"1.6", "step=1.6"},
        {"2", "step=2"},
        {"3", "step=3"}}},
      {"noise",
       "standard deviation of the image noise, grey levels",
       "room",
       {{"3", "noise=3"},
        {"6", "noise=6"},
        {"12", "noise=12"},
        {"24", "noise=24"},
        {"48", "noise=48"}}},
      {"occlusion",
       "part of the image covered by a card that sweeps before the lens",
       "room",
       {{"15 %", "occlude=0.15"},
        {"30 %", "occlude=0.3"},
        {"45 %", "occlude=0.45"},
        {"60 %", "occlude=0.6"}}},
      {"movers",
       "boxes that move through the scene on their own",
       "room",
       {{"2", "movers=2"}, {"4", "movers=4"}, {"8", "movers=8"}, {"12", "movers=12"}}},
      {"blackout",
       "black frames, after which the camera sees what it has seen before",
       "room",
       {{"5", "blackout=MID:5"},
        {"10", "blackout=MID:10"},
        {"20", "blackout=MID:20"},
        {"40", "blackout=MID:40"}}},
      {"texture",
       "contrast of all surfaces",
       "room",
       {{"50 %", "texture=0.5"},
        {"25 %", "texture=0.25"},
        {"12 %", "texture=0.12"},
        {"6 %", "texture=0.06"},
        {"3 %", "texture=0.03"}}},
      {"rotation",
       "turning on the spot, with this part of the translation left",
       "spin",
       {{"100 %", "travel=1"},
        {"75 %", "travel=0.75"},
        {"50 %", "travel=0.5"},
        {"25 %", "travel=0.25"}}},
      {"forward",
       "drive along a street at 10 Hz, motion so many times as fast (x1: 0.8 m per frame)",
       "forward",
       {{"x0.5", "speed=0.5"}, {"x1", "speed=1"}, {"x1.5", "speed=1.5"}, {"x2", "speed=2"}}}};
  return table;
}

std::string sequenceText(const Row& row, std::string options, const StressSize& size) {
  const std::size_t mid = options.find("MID");
  if (mid != std::string::npos) options.replace(mid, 3, std::to_string(size.frames / 2));
  return fmt::format("synthetic:{}?frames={}&size={}x{}&{}", row.preset, size.frames, size.width,
                     size.height, options);
}

}  // namespace

std::vector<Stress> stressTable(const StressSize& size) {
  std::vector<Stress> table;
  for (const Row& row : rows()) {
    Stress stress{row.name, row.meaning, {}};
    for (const auto& [strength, options] : row.levels)
      stress.levels.push_back({strength, sequenceText(row, options, size)});
    table.push_back(std::move(stress));
  }
  return table;
}

}  // namespace svoscope
