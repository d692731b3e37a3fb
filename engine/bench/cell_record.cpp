// SPDX-License-Identifier: MIT
#include "engine/bench/cell_record.h"

#include <fstream>
#include <nlohmann/json.hpp>

#include "engine/io/text_output.h"

namespace svoscope {

namespace fs = std::filesystem;

Status writeCellRecord(const fs::path& folder, const CellRecord& record) {
  const nlohmann::ordered_json json = {{"configuration", record.configuration},
                                       {"build", record.build},
                                       {"version", record.version},
                                       {"machine", record.machine},
                                       {"exit_code", record.exit_code},
                                       {"signal", record.signal},
                                       {"timed_out", record.timed_out},
                                       {"reason", record.reason},
                                       {"wall_s", record.wall_s}};
  // What ends up in the log of a run may be any bytes.
  return writeWhole(
      folder / "cell.json",
      json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n");
}

std::optional<CellRecord> readCellRecord(const fs::path& folder) {
  std::ifstream in(folder / "cell.json");
  const auto json = nlohmann::json::parse(in, nullptr, false);
  if (!json.is_object()) return std::nullopt;
  try {
    CellRecord record;
    json.at("configuration").get_to(record.configuration);
    json.at("build").get_to(record.build);
    json.at("version").get_to(record.version);
    json.at("machine").get_to(record.machine);
    json.at("exit_code").get_to(record.exit_code);
    json.at("signal").get_to(record.signal);
    json.at("timed_out").get_to(record.timed_out);
    json.at("reason").get_to(record.reason);
    json.at("wall_s").get_to(record.wall_s);
    return record;
  } catch (const nlohmann::json::exception&) {
    return std::nullopt;
  }
}

}  // namespace svoscope
