// SPDX-License-Identifier: MIT
// Plausible snapshots of a camera moving through a room, with a two-view start, keyframes, a loss
// and a relocalization.
#pragma once

#include <functional>
#include <memory>
#include <opencv2/core/mat.hpp>
#include <string>
#include <vector>

#include "engine/snapshot/snapshot.h"

namespace svoscope {

struct FakeOptions {
  int frames = 240;
  int width = 640, height = 480;
  int landmarks = 700;  ///< in the room
  int seeds = 300;      ///< per snapshot, about
  int start = 12;       ///< frame of the two-view start
  int lost_from = 140, lost_to = 148;
  int history = 1000;  ///< snapshots held
  bool ground_truth = true;
  bool features = true;  ///< else every frame is empty
  std::string method = "it-svo";
  double bend = 0;  ///< map units by which the estimate leaves the path per frame squared
};

using FakePyramid = std::shared_ptr<const std::vector<cv::Mat>>;
/// Pyramid of an earlier frame, null if it is no longer held.
using HeldPyramid = std::function<FakePyramid(int frame)>;

/// A number about -1.5..1.5 that depends on its arguments only.
double fakeNoise(int a, int b);

class FakeWorld {
 public:
  explicit FakeWorld(const FakeOptions& options);

  const RunInfo& info() const { return info_; }
  /// Everything but the sequence number. Keyframes have the pyramids of `held`.
  std::shared_ptr<Snapshot> snapshot(int frame, const HeldPyramid& held) const;

 private:
  struct Landmark {
    Vec3 position;
    FeatureType type;
    double direction;
    double noise;
  };

  void makeRoom();
  SE3 truth(int frame) const;
  SE3 estimate(int frame) const;
  TrackingState stateOf(int frame) const;
  void fillRecord(Snapshot& s) const;
  void fillFeatures(Snapshot& s) const;
  void fillTracks(Snapshot& s) const;
  void fillSeeds(Snapshot& s) const;
  void fillMap(Snapshot& s, const HeldPyramid& held) const;
  void fillEvents(Snapshot& s) const;
  FakePyramid draw(int frame) const;

  FakeOptions options_;
  RunInfo info_;
  std::vector<Landmark> room_;
  cv::Mat background_;
};

}  // namespace svoscope
