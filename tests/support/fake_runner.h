// SPDX-License-Identifier: MIT
// A runner without an engine: plausible snapshots of a camera moving through a room, with a
// two-view start, keyframes, a loss and a relocalization, for tests and pictures of the UI.
#pragma once

#include <deque>
#include <map>
#include <opencv2/core/mat.hpp>
#include <string>
#include <vector>

#include "engine/runner/runner.h"

namespace svoscope {

struct FakeOptions {
  int frames = 240;
  int width = 640, height = 480;
  int landmarks = 700;       ///< in the room
  int seeds = 300;           ///< per snapshot, about
  int start = 12;            ///< frame of the two-view start
  int lost_from = 140, lost_to = 148;
  int history = 1000;        ///< snapshots held
  bool ground_truth = true;
  bool features = true;      ///< else every frame is empty
  std::string method = "it-svo";
  double bend = 0;           ///< map units by which the estimate leaves the path per frame squared
};

class FakeRunner : public Runner {
 public:
  explicit FakeRunner(const FakeOptions& options = {});

  void send(const Command& command) override;
  bool pump() override;
  const RunInfo& info() const override { return info_; }
  RunnerStatus status() const override;
  SnapshotPtr latest() const override { return history_.empty() ? nullptr : history_.back(); }
  SnapshotPtr at(int frame_index) const override;
  std::vector<FrameRecord> records(int first) const override;
  std::vector<Event> events(int first) const override;
  std::vector<ParameterView> parameters() const override { return parameters_; }
  int generation() const override { return generation_; }

  /// Processes frames until `frames` were done.
  void runTo(int frames);
  const std::vector<Command>& sent() const { return sent_; }

 private:
  struct Landmark {
    Vec3 position;
    FeatureType type;
    double direction;
    double noise;
  };

  void makeRoom();
  void makeTruth();
  void makeParameters();
  void process();
  SE3 truth(int frame) const;
  SE3 estimate(int frame) const;
  TrackingState stateOf(int frame) const;
  void fillRecord(Snapshot& s) const;
  void fillFeatures(Snapshot& s) const;
  void fillTracks(Snapshot& s) const;
  void fillSeeds(Snapshot& s) const;
  void fillMap(Snapshot& s) const;
  void fillEvents(Snapshot& s) const;
  std::shared_ptr<const std::vector<cv::Mat>> draw(int frame) const;

  FakeOptions options_;
  RunInfo info_;
  std::vector<Landmark> room_;
  std::deque<SnapshotPtr> history_;
  std::vector<FrameRecord> records_;
  std::vector<Event> events_;
  std::vector<ParameterView> parameters_;
  std::vector<Command> sent_;
  cv::Mat background_;
  bool playing_ = false;
  int pending_steps_ = 0, generation_ = 1, stop_after_ = -1;
  std::uint64_t sequence_ = 0;
  Command::Kind run_to_ = Command::Kind::pause;
};

}  // namespace svoscope
