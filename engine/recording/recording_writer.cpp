// SPDX-License-Identifier: MIT
#include "engine/recording/recording_writer.h"

#include <fmt/format.h>

namespace svoscope {

namespace {

/// INSERT of the columns of a list and of further ones behind them.
std::string insert(const std::string& table, const ColumnList& list,
                   const std::vector<std::string>& further) {
  ColumnList all = list;
  for (const std::string& name : further) all.add(name, "");
  return "INSERT OR REPLACE INTO " + table + " (" + all.names + ") VALUES (" + all.marks + ")";
}

std::string joined(const std::vector<double>& values) {
  std::string text;
  for (const double v : values) text += (text.empty() ? "" : " ") + fmt::format("{}", v);
  return text;
}

Status cannotWrite(const std::filesystem::path& file, const std::string& why) {
  return outputError("the recording cannot be written: " + why, file.string(),
                     "check the folder and the space on its disk");
}

}  // namespace

Result<std::unique_ptr<RecordingWriter>> RecordingWriter::create(const std::filesystem::path& file,
                                                                 const RecordingOptions& options) {
  std::error_code ec;
  for (const char* suffix : {"", "-wal", "-shm", "-journal"})
    std::filesystem::remove(file.string() + suffix, ec);
  std::string problem;
  auto database = Database::open(file, Database::Mode::create, problem);
  if (!database) return cannotWrite(file, problem).error();
  std::unique_ptr<RecordingWriter> writer(new RecordingWriter(file, std::move(database), options));
  const Status begun = writer->begin();
  if (!begun.ok()) return begun.error();
  return writer;
}

RecordingWriter::RecordingWriter(std::filesystem::path file, std::unique_ptr<Database> database,
                                 const RecordingOptions& options)
    : database_(std::move(database)), file_(std::move(file)), options_(options) {}

Status RecordingWriter::failure() const { return cannotWrite(file_, database_->problem()); }

Status RecordingWriter::begin() {
  // WAL: a killed process leaves every committed frame behind, and a reader may look on meanwhile.
  const std::string settings = fmt::format(
      "PRAGMA page_size = 8192; PRAGMA journal_mode = WAL; PRAGMA synchronous = NORMAL;"
      "PRAGMA wal_autocheckpoint = 2000; PRAGMA locking_mode = NORMAL; PRAGMA temp_store = MEMORY;"
      "BEGIN; PRAGMA application_id = {}; PRAGMA user_version = {};",
      kRecordingId, kSchemaVersion);
  in_transaction_ = true;
  if (!database_->run(settings) || !database_->run(schemaSql()) || !prepare()) return failure();
  return commit();
}

Status RecordingWriter::run(const RunInfo& info) {
  if (!started() || !writeRun(info) || !writeGroundTruth(info.ground_truth)) return failure();
  return commit();
}

bool RecordingWriter::writeRun(const RunInfo& info) {
  Query query(*database_, insert("run", runColumns(), {}));
  if (!query.valid()) return false;
  RunRow row;
  row.info = info;
  row.version = options_.version;
  row.jpeg_quality = options_.jpeg_quality;
  PutColumns put(query);
  visitRun(row, put);
  const std::string coefficients = joined(info.original_camera.coefficients);
  query.put(distortionName(info.original_camera.distortion)).put(coefficients);
  return query.run();
}

bool RecordingWriter::writeGroundTruth(const Trajectory& truth) {
  Query query(*database_, "INSERT INTO ground_truth VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?)");
  int n = 0;
  for (const StampedPose& pose : truth) {
    query.put(n++).put(pose.timestamp);
    PutColumns put(query);
    put("", pose.T_world_cam);
    if (!query.run()) return false;
  }
  return query.valid();
}

bool RecordingWriter::prepare() {
  const auto make = [this](Query& query, const std::string& sql) {
    query = Query(*database_, sql);
    return query.valid();
  };
  return make(insert_frame_, insert("frames", recordColumns(), {"snapshot", "readable"})) &&
         make(insert_feature_, insert("features", featureColumns(), {"row", "frame"})) &&
         make(insert_update_, insert("seed_updates", seedUpdateColumns(), {"row", "frame"})) &&
         make(insert_pose_, insert("keyframe_poses", keyframeColumns(), {"frame", "gone"})) &&
         make(insert_point_, insert("map_points", pointColumns(), {"frame", "gone"})) &&
         make(insert_event_, insert("events", eventColumns(), {"n", "shown_in"})) &&
         make(insert_parameter_, insert("parameters", parameterColumns(), {"from_frame", "n"})) &&
         make(insert_keyframe_, "INSERT OR IGNORE INTO keyframes VALUES (?, ?)") &&
         make(insert_image_, "INSERT INTO images VALUES (?, ?)") &&
         make(insert_states_, "INSERT INTO seed_states VALUES (?, ?, ?, ?)") &&
         make(insert_seed_,
              "INSERT OR IGNORE INTO seeds (seed_id, first_frame, keyframe_id, type, level, "
              "px_ref_x, px_ref_y,"
              " px_ref_end_x, px_ref_end_y, direction, range, true_inv_distance)"
              " VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)") &&
         make(end_seed_,
              "UPDATE seeds SET ended_frame = ?, ending = ?, updates = ?, failures = ?, mu = ?, "
              "sigma = ?,"
              " a = ?, b = ? WHERE seed_id = ?");
}

bool RecordingWriter::started() {
  if (in_transaction_) return true;
  in_transaction_ = database_->run("BEGIN");
  return in_transaction_;
}

Status RecordingWriter::parameters(const std::vector<ParameterView>& parameters, int from) {
  bool good = started();
  for (std::size_t i = 0; good && i < parameters.size(); ++i) {
    // After the first time only what changed.
    if (i < last_parameters_.size() && last_parameters_[i].value == parameters[i].value) continue;
    PutColumns put(insert_parameter_);
    visitParameter(parameters[i], put);
    good = insert_parameter_.put(from).put(static_cast<int>(i)).run();
  }
  last_parameters_ = parameters;
  return good ? Status(Done{}) : failure();
}

Status RecordingWriter::event(const Event& event) {
  return started() && writeEvent(event, -1) ? Status(Done{}) : failure();
}

Status RecordingWriter::reset() {
  bool good = started();
  for (const char* table :
       {"parameters", "frames", "features", "seed_updates", "seeds", "seed_states", "keyframes",
        "keyframe_poses", "map_points", "events", "images"}) {
    good = good && database_->run(fmt::format("DELETE FROM {}", table));
  }
  events_ = since_key_ = 0;
  last_parameters_.clear();
  seeds_ = SeedIndex();
  keyframes_.clear();
  points_.clear();
  last_keyframes_.reset();
  last_points_.reset();
  return good ? Status(Done{}) : failure();
}

Status RecordingWriter::commit() {
  if (!in_transaction_) return Done{};
  if (!database_->run("COMMIT")) return failure();
  in_transaction_ = false;
  return Done{};
}

Status RecordingWriter::close() {
  if (!started() || !database_->run("UPDATE run SET complete = 1")) return failure();
  const Status committed = commit();
  if (!committed.ok()) return committed;
  for (Query* query : {&insert_frame_, &insert_feature_, &insert_update_, &insert_seed_, &end_seed_,
                       &insert_states_, &insert_keyframe_, &insert_pose_, &insert_point_,
                       &insert_event_, &insert_image_, &insert_parameter_})
    *query = Query();
  // Fails only if someone reads meanwhile; the file is as good with its log beside it.
  (void)database_->run("PRAGMA wal_checkpoint(TRUNCATE)");
  (void)database_->run("PRAGMA journal_mode = DELETE");
  return Done{};
}

}  // namespace svoscope
