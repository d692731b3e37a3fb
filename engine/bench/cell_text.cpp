// SPDX-License-Identifier: MIT
#include "engine/bench/cell_text.h"

#include <fmt/format.h>

#include <fstream>
#include <nlohmann/json.hpp>

namespace svoscope {

namespace fs = std::filesystem;

std::string lastError(const fs::path& log) {
  std::ifstream in(log);
  std::string line, last;
  const std::string mark = "svoscope: error: ";
  while (std::getline(in, line)) {
    if (line.rfind(mark, 0) == 0) last = line.substr(mark.size());
  }
  // What helps stands in the log; a table has room for what is wrong.
  const std::size_t remedy = last.rfind(" (");
  if (remedy != std::string::npos && last.back() == ')') last.resize(remedy);
  return last;
}

std::string reasonOf(const CellRecord& record, const fs::path& folder, double timeout_s) {
  if (record.timed_out) return fmt::format("took longer than {:g} s", timeout_s);
  if (record.signal != 0) return fmt::format("ended by signal {}", record.signal);
  if (record.exit_code == 0) return "";
  if (record.exit_code == 5) return "never initialised";
  const std::string error = lastError(folder / "log.txt");
  return error.empty() ? fmt::format("exit code {}", record.exit_code) : error;
}

std::string headline(const fs::path& folder) {
  std::ifstream in(folder / "metrics.json");
  const auto json = nlohmann::json::parse(in, nullptr, false);
  if (!json.is_object()) return "no figures";
  const auto ate = json.value("ate", nlohmann::json());
  const auto tracked = json.value("tracked_fraction_after_init", nlohmann::json());
  std::string text =
      ate.is_object() ? fmt::format("ATE {:.4f} m", ate.value("rmse_m", 0.0)) : "no ATE";
  if (tracked.is_number()) text += fmt::format(", {:.0f} % tracked", 100 * tracked.get<double>());
  return text;
}

}  // namespace svoscope
