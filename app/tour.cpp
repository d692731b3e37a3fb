// SPDX-License-Identifier: MIT
#include "app/tour.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>

namespace svoscope {

Result<std::filesystem::path> writeTour(const std::filesystem::path& folder, const RunInfo& info,
                                        bool several) {
  std::error_code ec;
  std::filesystem::create_directories(folder, ec);
  const auto file = folder / "tour.script";
  std::ofstream out(file);
  const int early = std::min(4, info.frames - 1), middle = std::min(150, info.frames - 1);
  out << fmt::format(
      "# The main screens; run again with: svoscope shot SEQUENCE --script tour.script --out DIR\n"
      "run-to {}\n"
      "layout Tracking\n"
      "shot 1-start.png\n"
      "run-to {}\n"
      "select feature any or none\n"
      "shot 2-tracking.png\n"
      "layout Seeds\n"
      "select seed any or none\n"
      "shot 3-seeds.png\n"
      "layout Evaluation\n"
      "shot 4-evaluation.png\n",
      early, middle);
  if (several) out << "layout Compare\nshot 5-compare.png\n";
  out.close();
  if (!out) return outputError("cannot be written", file.string(), "choose another folder with --out");
  return file;
}

}  // namespace svoscope
