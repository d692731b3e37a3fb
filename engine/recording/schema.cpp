// SPDX-License-Identifier: MIT
#include "engine/recording/schema.h"

namespace svoscope {

namespace {

template <typename T>
std::string codesOf(const char* field) {
  std::string sql;
  const auto& names = namesOf<T>();
  for (std::size_t i = 0; i < names.size(); ++i) {
    sql += "INSERT INTO codes VALUES ('" + std::string(field) + "', " + std::to_string(i) + ", '" +
           names[i] + "');\n";
  }
  return sql;
}

ColumnList makeRunColumns() {
  ColumnList list;
  const RunRow row;
  visitRun(row, list);
  list.add("original_distortion", "TEXT");
  list.add("original_coefficients", "TEXT");
  return list;
}

}  // namespace

const ColumnList& recordColumns() {
  static const ColumnList list = columnsOf<FrameRecord>(
      [](const FrameRecord& row, ColumnList& columns) { visitRecord(row, columns); });
  return list;
}

const ColumnList& featureColumns() {
  static const ColumnList list = columnsOf<FeatureView>(
      [](const FeatureView& row, ColumnList& columns) { visitFeature(row, columns); });
  return list;
}

const ColumnList& seedUpdateColumns() {
  static const ColumnList list = columnsOf<SeedUpdateView>(
      [](const SeedUpdateView& row, ColumnList& columns) { visitSeedUpdate(row, columns); });
  return list;
}

const ColumnList& pointColumns() {
  static const ColumnList list = columnsOf<MapPointView>(
      [](const MapPointView& row, ColumnList& columns) { visitPoint(row, columns); });
  return list;
}

const ColumnList& keyframeColumns() {
  static const ColumnList list = columnsOf<KeyframeView>(
      [](const KeyframeView& row, ColumnList& columns) { visitKeyframe(row, columns); });
  return list;
}

const ColumnList& eventColumns() {
  static const ColumnList list =
      columnsOf<Event>([](const Event& row, ColumnList& columns) { visitEvent(row, columns); });
  return list;
}

const ColumnList& parameterColumns() {
  static const ColumnList list = columnsOf<ParameterView>(
      [](const ParameterView& row, ColumnList& columns) { visitParameter(row, columns); });
  return list;
}

const ColumnList& runColumns() {
  static const ColumnList list = makeRunColumns();
  return list;
}

std::string schemaSql() {
  const std::string pose = "tx REAL, ty REAL, tz REAL, qx REAL, qy REAL, qz REAL, qw REAL";
  // Rows come frame by frame: tables in the order of frames only grow at their end.
  std::string sql =
      "CREATE TABLE run (" + runColumns().declarations +
      ");\n"
      "CREATE TABLE parameters (from_frame INTEGER, n INTEGER, " +
      parameterColumns().declarations +
      ", PRIMARY KEY (from_frame, key)) WITHOUT ROWID;\n"
      "CREATE TABLE ground_truth (n INTEGER PRIMARY KEY, timestamp REAL, " +
      pose +
      ");\n"
      "CREATE TABLE frames (" +
      recordColumns().declarations +
      ", snapshot INTEGER, readable INTEGER, PRIMARY KEY (frame)) WITHOUT ROWID;\n"
      "CREATE TABLE features (row INTEGER PRIMARY KEY, frame INTEGER, " +
      featureColumns().declarations +
      ");\n"
      "CREATE TABLE seed_updates (row INTEGER PRIMARY KEY, frame INTEGER, " +
      seedUpdateColumns().declarations +
      ");\n"
      "CREATE TABLE seeds (seed_id INTEGER PRIMARY KEY, first_frame INTEGER, keyframe_id INTEGER, "
      "type TEXT,"
      " level INTEGER, px_ref_x REAL, px_ref_y REAL, px_ref_end_x REAL, px_ref_end_y REAL, "
      "direction REAL,"
      " range REAL, true_inv_distance REAL, ended_frame INTEGER, ending TEXT, updates INTEGER,"
      " failures INTEGER, mu REAL, sigma REAL, a REAL, b REAL);\n"
      "CREATE TABLE seed_states (frame INTEGER PRIMARY KEY, complete INTEGER, seeds INTEGER, data "
      "BLOB);\n"
      "CREATE TABLE keyframes (keyframe_id INTEGER PRIMARY KEY, frame INTEGER);\n"
      "CREATE TABLE keyframe_poses (frame INTEGER, " +
      keyframeColumns().declarations +
      ", gone INTEGER, PRIMARY KEY (frame, keyframe_id)) WITHOUT ROWID;\n"
      "CREATE TABLE map_points (frame INTEGER, " +
      pointColumns().declarations +
      ", gone INTEGER, PRIMARY KEY (frame, id)) WITHOUT ROWID;\n"
      "CREATE TABLE events (n INTEGER PRIMARY KEY, " +
      eventColumns().declarations +
      ", shown_in INTEGER);\n"
      "CREATE TABLE images (frame INTEGER PRIMARY KEY, jpeg BLOB);\n"
      "CREATE TABLE codes (field TEXT, code INTEGER, name TEXT, PRIMARY KEY (field, code)) WITHOUT "
      "ROWID;\n";
  return sql + codesOf<FeatureType>("type") + codesOf<FeatureOrigin>("origin") +
         codesOf<FeatureStatus>("status") + codesOf<SearchOutcome>("outcome");
}

}  // namespace svoscope
