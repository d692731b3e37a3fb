// SPDX-License-Identifier: MIT
// Named stresses on built-in sequences, each in strengths from light to severe
// (docs/robustness.md).
#pragma once

#include <string>
#include <vector>

namespace svoscope {

struct StressLevel {
  std::string strength;  ///< as shown: "x2", "30 %"
  std::string sequence;  ///< "synthetic:room?frames=300&speed=2"
};

struct Stress {
  std::string name;                 ///< "speed"
  std::string meaning;              ///< one short phrase
  std::vector<StressLevel> levels;  ///< by rising strength
};

struct StressSize {
  int frames = 300;  ///< of each sequence
  int width = 640, height = 480;
};

/// All stresses; blackouts lie in the middle of the sequence.
std::vector<Stress> stressTable(const StressSize& size = {});

}  // namespace svoscope
