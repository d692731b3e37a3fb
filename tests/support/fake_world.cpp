// SPDX-License-Identifier: MIT
#include "tests/support/fake_world.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <random>

namespace svoscope {

namespace {

constexpr double kRate = 30;

// The same numbers on every machine, unlike the distributions of <random>.
double unit(std::mt19937& rng) { return static_cast<double>(rng()) / 4294967296.0; }

}  // namespace

double fakeNoise(int a, int b) {
  std::mt19937 rng(static_cast<unsigned>(a * 7919 + b * 104729 + 13));
  rng.discard(3);
  return unit(rng) + unit(rng) + unit(rng) - 1.5;
}

FakeWorld::FakeWorld(const FakeOptions& options) : options_(options) {
  info_.sequence = "synthetic:fake";
  info_.method = options.method;
  info_.frames = options.frames;
  info_.rate_hz = kRate;
  info_.camera = {options.width,
                  options.height,
                  options.width * 0.8,
                  options.width * 0.8,
                  options.width / 2.0 - 0.5,
                  options.height / 2.0 - 0.5};
  info_.original_camera.pinhole = info_.camera;
  makeRoom();
  if (!options.ground_truth) return;
  for (int i = 0; i < options.frames; ++i) info_.ground_truth.push_back({i / kRate, truth(i)});
}

void FakeWorld::makeRoom() {
  std::mt19937 rng(7);
  for (int i = 0; i < options_.landmarks; ++i) {
    Landmark l;
    const double u = unit(rng) * 2 - 1, v = unit(rng) * 2 - 1;
    switch (i % 5) {  // far wall twice, side walls, floor
      case 0:
      case 1:
        l.position = Vec3(4 * u, 2.6 * v, 6.5);
        break;
      case 2:
        l.position = Vec3(-4, 2.4 * u, 3.5 + 3 * v);
        break;
      case 3:
        l.position = Vec3(4, 2.4 * u, 3.5 + 3 * v);
        break;
      default:
        l.position = Vec3(3.8 * u, 1.6, 3.6 + 2.8 * v);
    }
    const double kind = unit(rng);
    l.type = kind < 0.62   ? FeatureType::corner
             : kind < 0.94 ? FeatureType::edgelet
                           : FeatureType::segment;
    l.direction = unit(rng) * 6.28;
    l.noise = 0.25 + unit(rng);
    room_.push_back(l);
  }
  background_ = cv::Mat(options_.height, options_.width, CV_8UC1);
  for (int y = 0; y < options_.height; ++y) {
    for (int x = 0; x < options_.width; ++x) {
      const double wave =
          std::sin(x * 0.021) * std::cos(y * 0.027) + 0.4 * std::sin(x * 0.11 + y * 0.07);
      background_.at<unsigned char>(y, x) =
          cv::saturate_cast<unsigned char>(92 + 26 * wave - y * 0.04);
    }
  }
}

SE3 FakeWorld::estimate(int frame) const {
  const double t = frame * 0.035;
  const Vec3 p(1.4 * std::sin(t), 0.12 * std::sin(1.7 * t), 0.9 * (1 - std::cos(0.8 * t)));
  const double yaw = 0.22 * std::sin(0.7 * t);
  const Eigen::Quaterniond q(Eigen::AngleAxisd(yaw, Vec3::UnitY()));
  return SE3(q, p);
}

// Another frame and scale, and a slow drift: something to align and to measure.
SE3 FakeWorld::truth(int frame) const {
  const SE3 e = estimate(frame);
  const SE3 T(Eigen::Quaterniond(Eigen::AngleAxisd(0.6, Vec3(0.2, 1, 0.1).normalized())),
              Vec3(3, -1, 2));
  const double d = frame * 0.0006;
  const Vec3 drifted =
      e.translation() + Vec3(0.05 * std::sin(frame * 0.02), 0.03 * std::sin(frame * 0.05), d * 0.4);
  const SE3 moved = T * SE3(e.quaternion(), drifted);
  return SE3(moved.quaternion(), 1.7 * moved.translation());
}

TrackingState FakeWorld::stateOf(int frame) const {
  if (frame < options_.start) return TrackingState::initializing;
  if (frame >= options_.lost_from && frame <= options_.lost_to) return TrackingState::lost;
  return TrackingState::tracking;
}

std::shared_ptr<const std::vector<cv::Mat>> FakeWorld::draw(int frame) const {
  cv::Mat image = background_.clone();
  const SE3 T = estimate(frame).inverse();
  for (std::size_t i = 0; i < room_.size(); ++i) {
    const Vec3 p = T * room_[i].position;
    if (p.z() < 0.3) continue;
    const Vec2 px = info_.camera.project(p);
    if (!info_.camera.inside(px, 2)) continue;
    const double r = 26 / p.z();
    const cv::Scalar ink(static_cast<double>(60 + (i * 67) % 170));
    const cv::Point2f c(static_cast<float>(px.x()), static_cast<float>(px.y()));
    if (room_[i].type == FeatureType::corner) {
      cv::rectangle(image, c,
                    cv::Point2f(c.x + static_cast<float>(r * 2), c.y + static_cast<float>(r * 1.5)),
                    ink, -1, cv::LINE_AA);
    } else {
      const double a = room_[i].direction + 1.5708;
      const cv::Point2f d(static_cast<float>(std::cos(a) * r * 2),
                          static_cast<float>(std::sin(a) * r * 2));
      cv::line(image, c - d, c + d, ink, 2, cv::LINE_AA);
    }
  }
  auto pyramid = std::make_shared<std::vector<cv::Mat>>();
  pyramid->push_back(image);
  for (int l = 1; l < 4; ++l) {
    cv::Mat half;
    cv::resize(pyramid->back(), half, {}, 0.5, 0.5, cv::INTER_AREA);
    pyramid->push_back(half);
  }
  return pyramid;
}

void FakeWorld::fillMap(Snapshot& s, const HeldPyramid& held) const {
  auto points = std::make_shared<std::vector<MapPointView>>();
  auto keyframes = std::make_shared<std::vector<KeyframeView>>();
  if (s.record.index >= options_.start) {
    const std::size_t known =
        std::min(room_.size(), 150 + static_cast<std::size_t>(s.record.index) * 4);
    for (std::size_t i = 0; i < known; ++i) {
      MapPointView p;
      p.id = static_cast<std::int64_t>(1000 + i);
      p.position =
          (room_[i].position * (1 + 0.02 * fakeNoise(static_cast<int>(i), 3))).cast<float>();
      p.type = room_[i].type;
      p.sigma = static_cast<float>(0.002 + 0.004 * room_[i].noise);
      p.observations = 2 + static_cast<int>(i % 11);
      points->push_back(p);
    }
    for (int f = options_.start, id = 0; f <= s.record.index; f += 9, ++id) {
      if (stateOf(f) == TrackingState::tracking) {
        const FakePyramid kept = f == s.record.index ? nullptr : held(f);
        keyframes->push_back({id, f, estimate(f), kept ? kept : s.pyramid, true});
      }
    }
  }
  s.record.landmarks = static_cast<int>(points->size());
  s.record.keyframes = static_cast<int>(keyframes->size());
  s.points = points;
  s.keyframes = keyframes;
}

void FakeWorld::fillRecord(Snapshot& s) const {
  FrameRecord& r = s.record;
  r.timestamp = r.index / kRate;
  r.state = stateOf(r.index);
  r.pose_good = r.state == TrackingState::tracking;
  r.T_world_cam = estimate(r.index);
  const Vec3 bent(0, options_.bend * r.index * r.index, 0);
  r.T_world_cam = SE3(r.T_world_cam.quaternion(), r.T_world_cam.translation() + bent);
  r.is_keyframe = r.pose_good && (r.index - options_.start) % 9 == 0;
  r.keyframe_id = r.is_keyframe ? (r.index - options_.start) / 9 : -1;
  r.keyframe_reason = r.is_keyframe ? "moved 12 % of the median depth"
                                    : "moved 4 % of the median depth, needs 12 %";
  r.relocalized = r.index == options_.lost_to + 1 && options_.lost_to >= options_.lost_from;
  const double wobble = 0.3 * fakeNoise(r.index, 77);
  r.align_rmse = 6 + wobble * 4;
  r.reprojection_px = 0.32 + 0.2 * std::abs(wobble);
  r.gain = 1 + 0.05 * std::sin(r.index * 0.1);
  r.offset = wobble * 3;
  r.median_depth = 4.2 + 0.6 * std::sin(r.index * 0.04);
  const auto set = [&](Stage stage, double ms) { r.time_ms[static_cast<int>(stage)] = ms; };
  const bool start = r.state == TrackingState::initializing;
  set(Stage::pyramid, 0.6 + 0.1 * wobble);
  set(Stage::initialize, start ? 7 + wobble * 3 : 0);
  set(Stage::sparse_align, start ? 0 : 3.1 + wobble);
  set(Stage::reproject, start ? 0 : 4.4 + wobble * 3);
  set(Stage::pose, start ? 0 : 0.7);
  set(Stage::structure, start ? 0 : 0.9);
  set(Stage::keyframe, r.is_keyframe ? 6.5 : 0.1);
  set(Stage::relocalize, r.state == TrackingState::lost ? 22 + wobble * 8 : 0);
  double sum = 0;
  for (int i = static_cast<int>(Stage::pyramid); i <= static_cast<int>(Stage::relocalize); ++i)
    sum += r.time_ms[i];
  set(Stage::tracking, sum);
  set(Stage::mapping, start ? 0 : (r.is_keyframe ? 19 : 9) + wobble * 4);
  set(Stage::snapshot, 0.3);
}

void FakeWorld::fillEvents(Snapshot& s) const {
  const int i = s.record.index;
  const auto add = [&](EventKind kind, const std::string& text) {
    s.events.push_back({i, kind, text});
  };
  if (i == options_.start)
    add(EventKind::initialized, "Two-view start with homography, 212 inliers of 236 tracks");
  if (s.record.is_keyframe)
    add(EventKind::keyframe,
        "Keyframe " + std::to_string(s.record.keyframe_id) + ", " + s.record.keyframe_reason);
  if (i == options_.lost_from && options_.lost_to >= i)
    add(EventKind::lost, "Lost, 31 inliers < 40 required");
  if (s.record.relocalized) add(EventKind::relocalized, "Relocalized against keyframe 14");
  if (i == 80) add(EventKind::warning, "Frame took 41 ms, budget is 33 ms");
  if (i == options_.frames - 1) add(EventKind::finished, "All frames processed");
}

std::shared_ptr<Snapshot> FakeWorld::snapshot(int frame, const HeldPyramid& held) const {
  auto s = std::make_shared<Snapshot>();
  s->record.index = frame;
  fillRecord(*s);
  s->pyramid = draw(frame);
  if (options_.features) {
    if (s->record.state == TrackingState::initializing)
      fillTracks(*s);
    else
      fillFeatures(*s);
    if (s->record.state != TrackingState::initializing) fillSeeds(*s);
  }
  if (!s->seeds) s->seeds = std::make_shared<std::vector<SeedView>>();
  fillMap(*s, held);
  FrameRecord& r = s->record;
  r.seeds = static_cast<int>(s->seeds->size());
  r.seed_updates = r.seeds * 2 / 3;
  r.seeds_converged = r.seeds ? 3 + r.index % 5 : 0;
  r.seeds_rejected = r.index % 3;
  r.reason =
      r.state == TrackingState::initializing
          ? "disparity " + std::to_string(static_cast<int>(r.disparity_px)) + " px < 43 px required"
      : r.state == TrackingState::lost ? std::to_string(r.funnel.inliers) + " inliers < 40 required"
                                       : "tracking";
  fillEvents(*s);
  s->bytes = 600000;
  return s;
}

}  // namespace svoscope
