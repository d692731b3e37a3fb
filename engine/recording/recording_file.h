// SPDX-License-Identifier: MIT
// A recording opened for reading: rows of the whole run in memory, everything else frame by frame.
// Not for several threads at once.
#pragma once

#include <filesystem>
#include <memory>

#include "engine/base/result.h"
#include "engine/recording/change_log.h"
#include "engine/recording/schema.h"
#include "engine/recording/seed_states.h"
#include "engine/runner/parameters.h"
#include "engine/runner/runner.h"

namespace svoscope {

class RecordingFile {
 public:
  /// One row of the table `frames`.
  struct FrameRow {
    FrameRecord record;
    std::uint64_t snapshot = 0;
    bool readable = true;  ///< the frame's image could be read when the run was recorded
  };
  struct EventRow {
    Event event;
    int shown_in = -1;  ///< frame of the snapshot that has it; -1: none
  };

  /// Input error that tells apart: no recording, written by a newer version, damaged, cut off.
  static Result<std::unique_ptr<RecordingFile>> open(const std::filesystem::path& file);

  const std::filesystem::path& path() const { return file_; }
  const RunRow& run() const { return run_; }
  const std::vector<FrameRow>& frames() const { return frames_; }  ///< by frame
  const std::vector<EventRow>& events() const { return events_; }  ///< in their order
  /// Parameters as of a frame.
  std::vector<ParameterView> parameters(int frame) const;

  /// Snapshot of a row of frames(), without images. Input error if the file is damaged there.
  Result<std::shared_ptr<Snapshot>> values(std::size_t row);
  /// The same with the record and the events only.
  std::shared_ptr<Snapshot> rowOnly(std::size_t row) const;
  /// Pyramid of a frame; null if the recording has no image of it or it is damaged.
  std::shared_ptr<const std::vector<cv::Mat>> pyramid(int frame);

 private:
  struct ParameterChange {
    int from = 0;
    ParameterView view;
  };

  RecordingFile(std::filesystem::path file, std::unique_ptr<Database> database);
  Status identify();
  bool load();
  bool loadRun();
  bool loadFrames();
  bool loadParameters();
  bool loadKeyframes();
  bool loadPoints();
  bool prepare();
  bool readFeatures(Snapshot& s);
  bool readUpdates(Snapshot& s);
  bool readSeeds(Snapshot& s);
  bool unpackSeeds(int frame);
  void place(std::vector<SeedView>& seeds, const Snapshot& s, double sigmas) const;
  SE3 poseOfGone(int keyframe, int frame) const;
  std::shared_ptr<const MappingParameters> mapping(int frame);
  Error damaged(const std::string& what) const;

  std::unique_ptr<Database> database_;  ///< first: outlives the statements
  std::filesystem::path file_;
  Query select_features_, select_updates_, select_states_, select_image_;
  RunRow run_;
  std::vector<FrameRow> frames_;
  std::vector<EventRow> events_;
  std::vector<ParameterChange> parameters_;
  ChangeLog<KeyframeView> keyframes_;
  ChangeLog<MapPointView> points_;
  std::vector<int> complete_seeds_;  ///< frames whose blob stands for itself
  SeedIndex seeds_;                  ///< unpacked last
  int seeds_frame_ = -1;
  std::shared_ptr<const MappingParameters> mapping_;
  std::size_t mapping_changes_ = 0;  ///< parameters applied to mapping_
};

}  // namespace svoscope
