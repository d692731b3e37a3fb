// SPDX-License-Identifier: MIT
#include "app/tour.h"

#include <fmt/format.h>

#include <algorithm>

#include "engine/io/text_output.h"

namespace svoscope {

Result<std::filesystem::path> writeTour(const std::filesystem::path& folder, const RunInfo& info,
                                        bool several) {
  const int early = std::min(4, info.frames - 1), middle = std::min(150, info.frames - 1);
  std::string text = fmt::format(
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
  if (several) text += "layout Compare\nshot 5-compare.png\n";
  const Status made = makeFolder(folder);
  if (!made.ok()) return made.error();
  const auto file = folder / "tour.script";
  const Status written = writeWhole(file, text);
  return written.ok() ? Result<std::filesystem::path>(file) : written.error();
}

}  // namespace svoscope
