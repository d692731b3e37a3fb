// SPDX-License-Identifier: MIT
// The tables of a recording (docs/recording.md) and how a file tells that it is one.
#pragma once

#include <string>

#include "engine/recording/column_io.h"
#include "engine/runner/runner.h"

namespace svoscope {

constexpr std::int64_t kRecordingId = 0x53564f53;  ///< PRAGMA application_id: "SVOS"
/// PRAGMA user_version; the 2 grows when the tables change. Every rule of the depth filter beyond
/// the first two adds columns of its own, so that files of other rule tables are told apart.
constexpr std::int64_t kSchemaVersion = 2 + 1000 * (static_cast<std::int64_t>(kRuleCount) - 2);
constexpr int kSeedKeyInterval = 32;  ///< frames from one complete seed blob to the next

/// Key of the n-th feature or seed update of a frame: those of a frame lie side by side, without an
/// index.
constexpr std::int64_t kRowsPerFrame = 1 << 16;
constexpr std::int64_t rowKey(int frame, int n) { return frame * kRowsPerFrame + n; }

/// Columns of a kind of rows; `visit` is one of the lists of columns.h.
template <typename Row, typename Visit>
ColumnList columnsOf(const Visit& visit) {
  ColumnList list;
  visit(Row{}, list);
  return list;
}

const ColumnList& recordColumns();
const ColumnList& featureColumns();
const ColumnList& seedUpdateColumns();
const ColumnList& pointColumns();
const ColumnList& keyframeColumns();
const ColumnList& eventColumns();
const ColumnList& parameterColumns();
/// Columns of the table `run`.
const ColumnList& runColumns();

/// CREATE TABLE of all tables, and the rows of `codes`.
std::string schemaSql();

/// What is in the row of table `run` beside the ground truth.
struct RunRow {
  RunInfo info;
  std::string version;  ///< of the program that wrote it
  int jpeg_quality = 0;
  int pyramid_levels = 0;
  bool complete = false;  ///< the recording was closed in order
};

template <typename R, typename F>
void visitRun(R& r, F&& f) {
  f("sequence", r.info.sequence);
  f("method", r.info.method);
  f("version", r.version);
  f("frames", r.info.frames);
  f("rate_hz", r.info.rate_hz);
  visitPinhole(r.info.camera, f);
  const auto original = [&](const char* name, auto& field) {
    f((std::string("original_") + name).c_str(), field);
  };
  visitPinhole(r.info.original_camera.pinhole, original);
  f("original_rate_hz", r.info.original_camera.rate_hz);
  f("jpeg_quality", r.jpeg_quality);
  f("pyramid_levels", r.pyramid_levels);
  f("complete", r.complete);
}

}  // namespace svoscope
