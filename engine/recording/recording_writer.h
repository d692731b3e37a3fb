// SPDX-License-Identifier: MIT
// Writes the tables of a recording, in the caller's thread. What is written becomes part of the
// file with commit(): a process that is killed loses at most what came after.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <unordered_map>

#include "engine/base/result.h"
#include "engine/recording/schema.h"
#include "engine/recording/seed_states.h"
#include "engine/runner/runner.h"

namespace svoscope {

struct RecordingOptions {
  std::string version;    ///< of the program, for the file
  int jpeg_quality = 95;  ///< 1 .. 100
};

class RecordingWriter {
 public:
  /// Makes the file anew. Output error if the folder or the file cannot be written.
  static Result<std::unique_ptr<RecordingWriter>> create(const std::filesystem::path& file,
                                                         const RecordingOptions& options);

  // Each is an output error if the file cannot be written, for example on a full disk.
  Status run(const RunInfo& info);  ///< once, first
  Status parameters(const std::vector<ParameterView>& parameters, int from);
  Status frame(const Snapshot& snapshot);
  Status event(const Event& event);
  /// Forgets all frames, events and parameters.
  Status reset();
  Status commit();
  /// Marks the recording as complete and makes one file of it.
  Status close();

 private:
  RecordingWriter(std::filesystem::path file, std::unique_ptr<Database> database,
                  const RecordingOptions& options);
  Status begin();
  bool writeRun(const RunInfo& info);
  bool writeGroundTruth(const Trajectory& truth);
  bool prepare();
  bool started();  ///< a transaction
  bool writeRecord(const Snapshot& s);
  bool writeLists(const Snapshot& s);
  bool writeImage(const Snapshot& s);
  bool writeSeeds(const Snapshot& s);
  bool writeNewSeed(const SeedView& seed, int frame);
  bool writeEnding(const SeedView& seed, const char* ending, int frame);
  bool writeKeyframes(const Snapshot& s);
  bool writePoints(const Snapshot& s);
  bool writeEvent(const Event& event, int shown_in);
  Status failure() const;

  std::unique_ptr<Database> database_;  ///< first: outlives the statements
  std::filesystem::path file_;
  RecordingOptions options_;
  Query insert_frame_, insert_feature_, insert_update_, insert_seed_, end_seed_, insert_states_,
      insert_keyframe_, insert_pose_, insert_point_, insert_event_, insert_image_,
      insert_parameter_;
  bool in_transaction_ = false, levels_written_ = false;
  int events_ = 0, since_key_ = 0;
  std::vector<ParameterView> last_parameters_;
  SeedIndex seeds_;                        ///< of the last frame
  std::map<int, KeyframeView> keyframes_;  ///< as last written
  std::map<std::int64_t, MapPointView> points_;
  std::shared_ptr<const std::vector<KeyframeView>> last_keyframes_;
  std::shared_ptr<const std::vector<MapPointView>> last_points_;
  ByteWriter blob_;
  std::vector<unsigned char> jpeg_;
};

}  // namespace svoscope
