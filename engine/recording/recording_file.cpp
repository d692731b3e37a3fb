// SPDX-License-Identifier: MIT
#include "engine/recording/recording_file.h"

#include <fmt/format.h>

#include <sstream>

namespace svoscope {

namespace fs = std::filesystem;

namespace {

Error notARecording(const fs::path& file, const std::string& why) {
  return inputError("is not a recording: " + why, file.string(),
                    "recordings are made by svoscope run --record");
}

std::vector<double> numbersOf(const std::string& text) {
  std::istringstream in(text);
  std::vector<double> values;
  for (double v = 0; in >> v;) values.push_back(v);
  return values;
}

std::string select(const ColumnList& columns, const std::string& further, const std::string& rest) {
  return "SELECT " + columns.names + further + " FROM " + rest;
}

}  // namespace

Result<std::unique_ptr<RecordingFile>> RecordingFile::open(const fs::path& file) {
  std::error_code ec;
  if (!fs::is_regular_file(file, ec))
    return inputError("there is no such file", file.string(), "check the path");
  if (!isSqliteFile(file))
    return notARecording(
        file, fs::file_size(file, ec) == 0 ? "the file is empty" : "it is no SQLite file");
  std::string problem;
  auto database = Database::open(file, Database::Mode::read, problem);
  if (!database)
    return inputError("cannot be opened: " + problem, file.string(), "check its permissions");
  std::unique_ptr<RecordingFile> recording(new RecordingFile(file, std::move(database)));
  const Status known = recording->identify();
  if (!known.ok()) return known.error();
  if (!recording->load()) {
    const bool by_sqlite = recording->database_->failed();
    return recording->damaged(by_sqlite ? recording->database_->problem()
                                        : "its tables hold what no run writes");
  }
  if (recording->frames_.empty())
    return inputError("the recording has no frames", file.string(),
                      "the run ended before its first frames were written");
  return recording;
}

RecordingFile::RecordingFile(fs::path file, std::unique_ptr<Database> database)
    : database_(std::move(database)), file_(std::move(file)) {}

Error RecordingFile::damaged(const std::string& what) const {
  return inputError("the recording is damaged: " + what, file_.string(),
                    "copy it anew, or record the run again");
}

Status RecordingFile::identify() {
  std::error_code ec;
  const auto size = static_cast<std::int64_t>(fs::file_size(file_, ec));
  const bool has_log = fs::exists(file_.string() + "-wal", ec);  // may hold what the file lacks
  if (const std::int64_t wanted = sizeByHeader(file_); !has_log && size < wanted)
    return damaged(fmt::format("it ends after {} of {} bytes", size, wanted));
  const std::int64_t id = database_->integer("PRAGMA application_id"),
                     version = database_->integer("PRAGMA user_version");
  if (id < 0 && database_->damaged()) return damaged(database_->problem());
  if (id < 0) {
    return inputError("cannot be read: " + database_->problem(), file_.string(),
                      "a recording that was not closed needs a folder that can be written");
  }
  if (id != kRecordingId) return notARecording(file_, "another program's SQLite file");
  if (version > kSchemaVersion) {
    return inputError(
        fmt::format("written by a newer svoscope (format {}, this one reads up to {})", version,
                    kSchemaVersion),
        file_.string(), "update svoscope");
  }
  if (version < kSchemaVersion) {
    return inputError(fmt::format("written by an older svoscope (format {}, this one reads {})",
                                  version, kSchemaVersion),
                      file_.string(), "record the run again");
  }
  // Larger than any recording's index, small against its images: pages are read in place.
  (void)database_->run("PRAGMA mmap_size = 1073741824");
  return Done{};
}

bool RecordingFile::load() {
  return loadRun() && loadFrames() && loadParameters() && loadKeyframes() && loadPoints() &&
         prepare();
}

bool RecordingFile::loadRun() {
  Query query(*database_, select(runColumns(), "", "run"));
  if (!query.next()) return false;
  GetColumns get(query);
  visitRun(run_, get);
  Camera& original = run_.info.original_camera;
  const Result<Distortion> distortion = parseDistortion(query.text());
  original.distortion = distortion.ok() ? distortion.value() : Distortion::none;
  original.coefficients = numbersOf(query.text());
  Query truth(*database_,
              "SELECT timestamp, tx, ty, tz, qx, qy, qz, qw FROM ground_truth ORDER BY n");
  while (truth.next()) {
    StampedPose pose;
    pose.timestamp = truth.real();
    GetColumns get_pose(truth);
    get_pose("", pose.T_world_cam);
    run_.info.ground_truth.push_back(pose);
  }
  return truth.valid() && !truth.failed();
}

bool RecordingFile::loadFrames() {
  Query query(*database_, select(recordColumns(), ", snapshot, readable", "frames ORDER BY frame"));
  while (query.next()) {
    FrameRow row;
    GetColumns get(query);
    visitRecord(row.record, get);
    row.snapshot = static_cast<std::uint64_t>(query.integer());
    row.readable = query.integer() != 0;
    frames_.push_back(std::move(row));
  }
  Query events(*database_, select(eventColumns(), ", ifnull(shown_in, -1)", "events ORDER BY n"));
  while (events.next()) {
    EventRow row;
    GetColumns get(events);
    visitEvent(row.event, get);
    row.shown_in = static_cast<int>(events.integer());
    events_.push_back(std::move(row));
  }
  return query.valid() && !query.failed() && events.valid() && !events.failed();
}

bool RecordingFile::loadParameters() {
  Query query(*database_,
              select(parameterColumns(), ", from_frame", "parameters ORDER BY from_frame, n"));
  while (query.next()) {
    ParameterChange change;
    GetColumns get(query);
    visitParameter(change.view, get);
    change.from = static_cast<int>(query.integer());
    parameters_.push_back(std::move(change));
  }
  return query.valid() && !query.failed();
}

bool RecordingFile::loadKeyframes() {
  Query query(
      *database_,
      select(
          keyframeColumns(), ", keyframes.frame, p.frame, gone",
          "keyframe_poses AS p JOIN keyframes USING (keyframe_id) ORDER BY p.frame, keyframe_id"));
  while (query.next()) {
    ChangeLog<KeyframeView>::Change change;
    GetColumns get(query);
    visitKeyframe(change.value, get);
    change.value.frame_index = static_cast<int>(query.integer());
    change.frame = static_cast<int>(query.integer());
    change.gone = query.integer() != 0;
    keyframes_.add(std::move(change));
  }
  return query.valid() && !query.failed();
}

bool RecordingFile::loadPoints() {
  Query query(*database_, select(pointColumns(), ", frame, gone", "map_points ORDER BY frame, id"));
  while (query.next()) {
    ChangeLog<MapPointView>::Change change;
    GetColumns get(query);
    visitPoint(change.value, get);
    change.frame = static_cast<int>(query.integer());
    change.gone = query.integer() != 0;
    points_.add(std::move(change));
  }
  return query.valid() && !query.failed();
}

bool RecordingFile::prepare() {
  Query complete(*database_, "SELECT frame FROM seed_states WHERE complete ORDER BY frame");
  while (complete.next()) complete_seeds_.push_back(static_cast<int>(complete.integer()));
  const auto make = [this](Query& query, const std::string& sql) {
    query = Query(*database_, sql);
    return query.valid();
  };
  return complete.valid() && !complete.failed() &&
         make(select_features_,
              select(featureColumns(), "", "features WHERE row >= ? AND row < ? ORDER BY row")) &&
         make(select_updates_, select(seedUpdateColumns(), "",
                                      "seed_updates WHERE row >= ? AND row < ? ORDER BY row")) &&
         make(
             select_states_,
             "SELECT frame, data FROM seed_states WHERE frame > ? AND frame <= ? ORDER BY frame") &&
         make(select_image_, "SELECT jpeg FROM images WHERE frame = ?");
}

std::vector<ParameterView> RecordingFile::parameters(int frame) const {
  std::vector<ParameterView> views;
  for (const ParameterChange& change : parameters_) {
    const auto known = std::find_if(views.begin(), views.end(), [&](const ParameterView& v) {
      return v.key == change.view.key;
    });
    if (known == views.end())
      views.push_back(change.view);
    else if (change.from <= frame)
      *known = change.view;
  }
  return views;
}

}  // namespace svoscope
