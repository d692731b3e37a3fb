// SPDX-License-Identifier: MIT
#include "engine/io/frames_csv.h"

#include <fmt/format.h>

#include "engine/snapshot/frame_fields.h"

namespace svoscope {

namespace {

std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"') result += '"';
    result += c == '\n' || c == '\r' ? ' ' : c;
  }
  return result + "\"";
}

void addText(const FrameField& field, double value, std::string& row) {
  row += field.decimals < 0 ? fmt::format("{:.9g}", value)
                            : fmt::format("{:.{}f}", value, field.decimals);
}
void addText(const FrameField&, int value, std::string& row) { row += fmt::format("{}", value); }
void addText(const FrameField&, bool value, std::string& row) { row += value ? '1' : '0'; }
void addText(const FrameField&, TrackingState value, std::string& row) { row += stateName(value); }
void addText(const FrameField&, const std::string& value, std::string& row) {
  row += quoted(value);
}
void addText(const FrameField& field, const SE3& T, std::string& row) {
  for (int i = 0; i < 7; ++i) {
    if (i > 0) row += ',';
    if (!field.applies) continue;
    row += fmt::format("{:.9g}", i < 3 ? T.translation()[i] : T.quaternion().coeffs()[i - 3]);
  }
}

}  // namespace

std::string framesCsvHeader() {
  const FrameRecord record;
  std::string header;
  const auto add = [&](const char* name) {
    if (!header.empty()) header += ',';
    header += name;
  };
  visitFrameFields(record, [&](const FrameField& field, const auto& value) {
    if constexpr (std::is_same_v<std::decay_t<decltype(value)>, SE3>)
      for (const char* name : kPoseColumns) add(name);
    else
      add(field.name);
  });
  return header;
}

std::string framesCsvRow(const FrameRecord& record) {
  std::string row;
  bool first = true;
  visitFrameFields(record, [&](const FrameField& field, const auto& value) {
    if (!first) row += ',';
    first = false;
    addText(field, value, row);
  });
  return row;
}

}  // namespace svoscope
