// SPDX-License-Identifier: MIT
#include "tests/support/fake_runner.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <random>

#include "engine/study/lab.h"

namespace svoscope {

namespace {

constexpr double kRate = 30;

// The same numbers on every machine, unlike the distributions of <random>.
double unit(std::mt19937& rng) { return static_cast<double>(rng()) / 4294967296.0; }

double noise(int a, int b) {
  std::mt19937 rng(static_cast<unsigned>(a * 7919 + b * 104729 + 13));
  rng.discard(3);
  return unit(rng) + unit(rng) + unit(rng) - 1.5;
}

}  // namespace

FakeRunner::FakeRunner(const FakeOptions& options) : options_(options) {
  info_.sequence = "synthetic:fake";
  info_.method = options.method;
  info_.frames = options.frames;
  info_.rate_hz = kRate;
  info_.camera = {options.width, options.height, options.width * 0.8, options.width * 0.8,
                  options.width / 2.0 - 0.5, options.height / 2.0 - 0.5};
  info_.original_camera.pinhole = info_.camera;
  makeRoom();
  if (options.ground_truth) makeTruth();
  makeParameters();
}

void FakeRunner::makeRoom() {
  std::mt19937 rng(7);
  for (int i = 0; i < options_.landmarks; ++i) {
    Landmark l;
    const double u = unit(rng) * 2 - 1, v = unit(rng) * 2 - 1;
    switch (i % 5) {  // far wall twice, side walls, floor
      case 0:
      case 1: l.position = Vec3(4 * u, 2.6 * v, 6.5); break;
      case 2: l.position = Vec3(-4, 2.4 * u, 3.5 + 3 * v); break;
      case 3: l.position = Vec3(4, 2.4 * u, 3.5 + 3 * v); break;
      default: l.position = Vec3(3.8 * u, 1.6, 3.6 + 2.8 * v);
    }
    const double kind = unit(rng);
    l.type = kind < 0.62 ? FeatureType::corner : kind < 0.94 ? FeatureType::edgelet : FeatureType::segment;
    l.direction = unit(rng) * 6.28;
    l.noise = 0.25 + unit(rng);
    room_.push_back(l);
  }
  background_ = cv::Mat(options_.height, options_.width, CV_8UC1);
  for (int y = 0; y < options_.height; ++y) {
    for (int x = 0; x < options_.width; ++x) {
      const double wave = std::sin(x * 0.021) * std::cos(y * 0.027) + 0.4 * std::sin(x * 0.11 + y * 0.07);
      background_.at<unsigned char>(y, x) = cv::saturate_cast<unsigned char>(92 + 26 * wave - y * 0.04);
    }
  }
}

void FakeRunner::makeTruth() {
  for (int i = 0; i < options_.frames; ++i) info_.ground_truth.push_back({i / kRate, truth(i)});
}

void FakeRunner::makeParameters() {
  const auto add = [this](ParameterView p) { parameters_.push_back(std::move(p)); };
  add({"tracking.min_inliers", "40", "40", "", "inliers below this: lost", "int", 5, 500, {}, false});
  add({"tracking.max_iterations", "10", "10", "", "Gauss-Newton iterations per level", "int", 1, 50, {}, false});
  add({"reproject.cell_px", "28", "25", "px", "one feature is tried per cell", "int", 8, 100, {}, false});
  add({"reproject.max_features", "180", "180", "", "features matched per frame", "int", 20, 1000, {}, false});
  add({"seeds.rule", "js", "js", "", "divergence that weights a measurement", "choice", 0, 0, {"kl", "js"}, true});
  add({"seeds.convergence", "0.005", "0.005", "", "sigma over range at which a seed has converged", "float", 0, 1, {}, false});
  add({"seeds.edgelets", "true", "true", "", "make seeds on edges, too", "bool", 0, 0, {}, false});
  add({"pyramid.levels", "4", "4", "", "image pyramid levels", "int", 1, 8, {}, true});
}

SE3 FakeRunner::estimate(int frame) const {
  const double t = frame * 0.035;
  const Vec3 p(1.4 * std::sin(t), 0.12 * std::sin(1.7 * t), 0.9 * (1 - std::cos(0.8 * t)));
  const double yaw = 0.22 * std::sin(0.7 * t);
  const Eigen::Quaterniond q(Eigen::AngleAxisd(yaw, Vec3::UnitY()));
  return SE3(q, p);
}

// Another frame and scale, and a slow drift: something to align and to measure.
SE3 FakeRunner::truth(int frame) const {
  const SE3 e = estimate(frame);
  const SE3 T(Eigen::Quaterniond(Eigen::AngleAxisd(0.6, Vec3(0.2, 1, 0.1).normalized())), Vec3(3, -1, 2));
  const double d = frame * 0.0006;
  const Vec3 drifted = e.translation() + Vec3(0.05 * std::sin(frame * 0.02), 0.03 * std::sin(frame * 0.05), d * 0.4);
  const SE3 moved = T * SE3(e.quaternion(), drifted);
  return SE3(moved.quaternion(), 1.7 * moved.translation());
}

TrackingState FakeRunner::stateOf(int frame) const {
  if (frame < options_.start) return TrackingState::initializing;
  if (frame >= options_.lost_from && frame <= options_.lost_to) return TrackingState::lost;
  return TrackingState::tracking;
}

std::shared_ptr<const std::vector<cv::Mat>> FakeRunner::draw(int frame) const {
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
      cv::rectangle(image, c, cv::Point2f(c.x + static_cast<float>(r * 2), c.y + static_cast<float>(r * 1.5)), ink, -1, cv::LINE_AA);
    } else {
      const double a = room_[i].direction + 1.5708;
      const cv::Point2f d(static_cast<float>(std::cos(a) * r * 2), static_cast<float>(std::sin(a) * r * 2));
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

void FakeRunner::fillTracks(Snapshot& s) const {
  const SE3 now = estimate(s.record.index).inverse(), first = estimate(0).inverse();
  for (std::size_t i = 0; i < room_.size(); i += 3) {
    const Vec3 p = now * room_[i].position, q = first * room_[i].position;
    if (p.z() < 0.3 || q.z() < 0.3) continue;
    FeatureView f;
    f.id = static_cast<std::int64_t>(i);
    f.origin = FeatureOrigin::track;
    f.px = info_.camera.project(p).cast<float>();
    f.predicted_px = info_.camera.project(q).cast<float>();
    if (info_.camera.inside(f.px.cast<double>(), 8)) s.features.push_back(f);
  }
  s.record.disparity_tracks = static_cast<int>(s.features.size());
  s.record.disparity_px = 3.6 * s.record.index;
}

void FakeRunner::fillFeatures(Snapshot& s) const {
  const SE3 T = estimate(s.record.index).inverse();
  Funnel& n = s.record.funnel;
  const bool lost = s.record.state == TrackingState::lost;
  for (std::size_t i = 0; i < room_.size(); i += 2) {
    const Vec3 p = T * room_[i].position;
    ++n.candidates;
    if (p.z() < 0.3) continue;
    const Vec2 px = info_.camera.project(p);
    if (!info_.camera.inside(px, 8)) continue;
    ++n.projected;
    FeatureView f;
    f.id = static_cast<std::int64_t>(1000 + i);
    f.type = room_[i].type;
    f.origin = i % 9 == 0   ? FeatureOrigin::converged_seed
               : i % 7 == 0 ? FeatureOrigin::unconverged_seed
                            : FeatureOrigin::landmark;
    const double luck = noise(static_cast<int>(i), s.record.index);
    f.status = std::abs(luck) > 1.0 || (lost && i % 8) ? FeatureStatus::not_aligned
               : luck > 0.8                           ? FeatureStatus::outlier
                                                      : FeatureStatus::inlier;
    f.level = static_cast<std::uint8_t>(i % 3);
    f.predicted_px = px.cast<float>();
    const double size = f.status == FeatureStatus::outlier ? 4 : room_[i].noise;
    f.px = f.predicted_px + Vec2f(static_cast<float>(size * noise(static_cast<int>(i), s.record.index + 500)),
                                  static_cast<float>(size * noise(static_cast<int>(i), s.record.index + 900)));
    f.direction = static_cast<float>(room_[i].direction);
    const double a = room_[i].direction + 1.5708, length = 60 / p.z();
    f.px_end = f.px + Vec2f(static_cast<float>(std::cos(a) * length), static_cast<float>(std::sin(a) * length));
    f.depth = static_cast<float>(p.z());
    f.residual_px = (f.px - f.predicted_px).norm();
    f.observations = 2 + static_cast<int>(i % 11);
    f.reference_keyframe = std::max(0, (s.record.index - options_.start) / 9 - static_cast<int>(i % 3));
    ++n.tried;
    n.matched += f.status != FeatureStatus::not_aligned;
    n.inliers += f.status == FeatureStatus::inlier;
    n.inlier_seeds += f.status == FeatureStatus::inlier && f.origin != FeatureOrigin::landmark;
    n.inlier_edgelets += f.status == FeatureStatus::inlier && f.type == FeatureType::edgelet;
    n.inlier_segments += f.status == FeatureStatus::inlier && f.type == FeatureType::segment;
    s.features.push_back(f);
  }
  n.inlier_landmarks = n.inliers - n.inlier_seeds;
  n.required = 40;
  n.aligned_sparse = n.matched;
}

namespace {

// Both rules converge on the truth, JS faster.
BeliefView fakeBelief(int i, int updates, double truth, bool js) {
  BeliefView b;
  const double sigma = 0.25 / (1 + (js ? 0.8 : 0.6) * updates);
  b.sigma = static_cast<float>(sigma);
  b.mu = static_cast<float>(truth + 0.6 * sigma * noise(i, js ? 2 : 1));
  b.a = 10 + static_cast<float>(updates) * (js ? 0.85f : 0.8f);
  b.b = 10 + static_cast<float>(updates) * 0.15f;
  return b;
}

SeedUpdateView fakeUpdate(const SeedView& seed, int i, int frame, double truth) {
  SeedUpdateView u;
  u.seed_id = seed.id;
  u.keyframe_id = seed.keyframe_id;
  u.frame_index = frame;
  u.outcome = seed.outcome;
  u.px = seed.px;
  u.kl_before = fakeBelief(i, seed.updates - 1, truth, false);
  u.js_before = fakeBelief(i, seed.updates - 1, truth, true);
  u.kl_after = seed.kl;
  u.js_after = seed.js;
  if (u.outcome != SearchOutcome::matched) return u;
  u.score = 120;
  u.x = seed.last_x;
  u.tau = seed.last_tau;
  const LabPair pair = comparePair(u.kl_before.mu, u.kl_before.sigma, u.x, u.tau);
  u.kl_belief_measurement = static_cast<float>(pair.kl_pq);
  u.kl_measurement_belief = static_cast<float>(pair.kl_qp);
  u.jsd = static_cast<float>(pair.jsd);
  u.affinity = static_cast<float>(pair.affinity);
  return u;
}

}  // namespace

void FakeRunner::fillSeeds(Snapshot& s) const {
  auto seeds = std::make_shared<std::vector<SeedView>>();
  auto updates = std::make_shared<std::vector<SeedUpdateView>>();
  const SE3 T = estimate(s.record.index).inverse();
  const auto project = [&](const Vec3& world, Vec2f& px) {
    const Vec3 p = T * world;
    if (p.z() < 0.1) return false;
    const Vec2 at = info_.camera.project(p);
    px = at.cast<float>();
    return info_.camera.inside(at, 2);
  };
  for (int i = 0; i < options_.seeds && !room_.empty(); ++i) {
    const std::size_t k = (static_cast<std::size_t>(i) * 2 + 1) % room_.size();
    SeedView v;
    const bool shared = k % 9 == 0 || k % 7 == 0;
    v.id = static_cast<std::int64_t>(shared ? 1000 + k : 5000 + static_cast<std::size_t>(i));
    v.keyframe_id = std::max(0, (s.record.index - options_.start) / 9 - 1);
    v.type = room_[k].type;
    const int age = s.record.index - options_.start - (i % 20) * 9;
    if (age < 0 || (!shared && age > 70)) continue;
    v.updates = std::min(40, age);
    v.failures = i % 5;
    const Vec3 origin = estimate(options_.start).translation();
    const Vec3 ray = room_[k].position - origin;
    const double distance = ray.norm();
    v.kl = fakeBelief(i, v.updates, 1 / distance, false);
    v.js = fakeBelief(i, v.updates, 1 / distance, true);
    const double sigma = v.kl.sigma;
    v.sigma = v.kl.sigma;
    v.mu = v.kl.mu;
    v.range = 1.2f;
    v.a = v.kl.a;
    v.b = v.kl.b;
    if (options_.ground_truth) v.true_inv_distance = static_cast<float>(1 / (1.7 * distance));
    v.status = v.updates > 34 ? SeedStatus::converged : SeedStatus::active;
    v.outcome = i % 6 == 0 ? SearchOutcome::no_match : SearchOutcome::matched;
    const auto along = [&](double inverse) { return Vec3(origin + ray.normalized() / std::max(0.05, inverse)); };
    v.position = along(v.mu).cast<float>();
    v.position_near = along(v.mu + sigma).cast<float>();
    v.position_far = along(v.mu - sigma).cast<float>();
    v.visible = project(along(v.mu), v.px);
    project(along(v.mu + sigma), v.px_near);
    project(along(v.mu - sigma), v.px_far);
    v.last_x = static_cast<float>(1 / distance + 0.05 * noise(i, v.updates + 50));
    v.last_tau = 0.05f;
    v.px_ref = v.px;
    seeds->push_back(v);
    if (age > 0 && age <= 40) updates->push_back(fakeUpdate(v, i, s.record.index, 1 / distance));
  }
  s.seeds = seeds;
  s.seed_updates = updates;
}

void FakeRunner::fillMap(Snapshot& s) const {
  auto points = std::make_shared<std::vector<MapPointView>>();
  auto keyframes = std::make_shared<std::vector<KeyframeView>>();
  if (s.record.index >= options_.start) {
    const std::size_t known = std::min(room_.size(), 150 + static_cast<std::size_t>(s.record.index) * 4);
    for (std::size_t i = 0; i < known; ++i) {
      MapPointView p;
      p.id = static_cast<std::int64_t>(1000 + i);
      p.position = (room_[i].position * (1 + 0.02 * noise(static_cast<int>(i), 3))).cast<float>();
      p.type = room_[i].type;
      p.sigma = static_cast<float>(0.002 + 0.004 * room_[i].noise);
      p.observations = 2 + static_cast<int>(i % 11);
      points->push_back(p);
    }
    for (int f = options_.start, id = 0; f <= s.record.index; f += 9, ++id) {
      if (stateOf(f) == TrackingState::tracking) {
        const SnapshotPtr held = f == s.record.index ? nullptr : at(f);
        keyframes->push_back({id, f, estimate(f), held ? held->pyramid : s.pyramid, true});
      }
    }
  }
  s.record.landmarks = static_cast<int>(points->size());
  s.record.keyframes = static_cast<int>(keyframes->size());
  s.points = points;
  s.keyframes = keyframes;
}

void FakeRunner::fillRecord(Snapshot& s) const {
  FrameRecord& r = s.record;
  r.timestamp = r.index / kRate;
  r.state = stateOf(r.index);
  r.pose_good = r.state == TrackingState::tracking;
  r.T_world_cam = estimate(r.index);
  const Vec3 bent(0, options_.bend * r.index * r.index, 0);
  r.T_world_cam = SE3(r.T_world_cam.quaternion(), r.T_world_cam.translation() + bent);
  r.is_keyframe = r.pose_good && (r.index - options_.start) % 9 == 0;
  r.keyframe_id = r.is_keyframe ? (r.index - options_.start) / 9 : -1;
  r.keyframe_reason = r.is_keyframe ? "moved 12 % of the median depth" : "moved 4 % of the median depth, needs 12 %";
  r.relocalized = r.index == options_.lost_to + 1 && options_.lost_to >= options_.lost_from;
  const double wobble = 0.3 * noise(r.index, 77);
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
  for (int i = static_cast<int>(Stage::pyramid); i <= static_cast<int>(Stage::relocalize); ++i) sum += r.time_ms[i];
  set(Stage::tracking, sum);
  set(Stage::mapping, start ? 0 : (r.is_keyframe ? 19 : 9) + wobble * 4);
  set(Stage::snapshot, 0.3);
}

void FakeRunner::fillEvents(Snapshot& s) const {
  const int i = s.record.index;
  const auto add = [&](EventKind kind, const std::string& text) { s.events.push_back({i, kind, text}); };
  if (i == options_.start) add(EventKind::initialized, "Two-view start with homography, 212 inliers of 236 tracks");
  if (s.record.is_keyframe) add(EventKind::keyframe, "Keyframe " + std::to_string(s.record.keyframe_id) + ", " + s.record.keyframe_reason);
  if (i == options_.lost_from && options_.lost_to >= i) add(EventKind::lost, "Lost, 31 inliers < 40 required");
  if (s.record.relocalized) add(EventKind::relocalized, "Relocalized against keyframe 14");
  if (i == 80) add(EventKind::warning, "Frame took 41 ms, budget is 33 ms");
  if (i == options_.frames - 1) add(EventKind::finished, "All frames processed");
}

void FakeRunner::process() {
  auto s = std::make_shared<Snapshot>();
  s->sequence_number = ++sequence_;
  s->record.index = static_cast<int>(records_.size());
  fillRecord(*s);
  s->pyramid = draw(s->record.index);
  if (options_.features) {
    if (s->record.state == TrackingState::initializing) fillTracks(*s);
    else fillFeatures(*s);
    if (s->record.state != TrackingState::initializing) fillSeeds(*s);
  }
  if (!s->seeds) s->seeds = std::make_shared<std::vector<SeedView>>();
  fillMap(*s);
  FrameRecord& r = s->record;
  r.seeds = static_cast<int>(s->seeds->size());
  r.seed_updates = r.seeds * 2 / 3;
  r.seeds_converged = r.seeds ? 3 + r.index % 5 : 0;
  r.seeds_rejected = r.index % 3;
  r.reason = r.state == TrackingState::initializing
                 ? "disparity " + std::to_string(static_cast<int>(r.disparity_px)) + " px < 43 px required"
             : r.state == TrackingState::lost ? std::to_string(r.funnel.inliers) + " inliers < 40 required"
                                              : "tracking";
  fillEvents(*s);
  s->bytes = 600000;
  records_.push_back(r);
  events_.insert(events_.end(), s->events.begin(), s->events.end());
  history_.push_back(s);
  while (static_cast<int>(history_.size()) > options_.history) history_.pop_front();
}

void FakeRunner::send(const Command& command) {
  sent_.push_back(command);
  switch (command.kind) {
    case Command::Kind::step: ++pending_steps_; break;
    case Command::Kind::play: playing_ = true; run_to_ = Command::Kind::pause; break;
    case Command::Kind::pause: playing_ = false; break;
    case Command::Kind::reset:
      history_.clear();
      records_.clear();
      events_.clear();
      playing_ = false;
      ++generation_;
      break;
    case Command::Kind::set_parameter:
      for (ParameterView& p : parameters_) {
        if (p.key == command.key) p.value = command.value;
      }
      break;
    case Command::Kind::set_speed: break;
    default:
      playing_ = true;
      run_to_ = command.kind;
      stop_after_ = command.frame;
  }
}

bool FakeRunner::pump() {
  if (static_cast<int>(records_.size()) >= options_.frames) playing_ = false;
  if (static_cast<int>(records_.size()) >= options_.frames || (!playing_ && pending_steps_ == 0)) return false;
  if (pending_steps_ > 0) --pending_steps_;
  process();
  const FrameRecord& r = records_.back();
  const bool reached = (run_to_ == Command::Kind::run_to_keyframe && r.is_keyframe) ||
                       (run_to_ == Command::Kind::run_to_loss && r.state == TrackingState::lost) ||
                       (run_to_ == Command::Kind::run_to_start && r.index == options_.start) ||
                       (run_to_ == Command::Kind::run_to_frame && r.index >= stop_after_);
  if (reached) playing_ = false;
  return true;
}

void FakeRunner::runTo(int frames) {
  while (static_cast<int>(records_.size()) < std::min(frames, options_.frames)) process();
}

RunnerStatus FakeRunner::status() const {
  RunnerStatus s;
  s.playing = playing_;
  s.finished = static_cast<int>(records_.size()) >= options_.frames;
  s.next_frame = static_cast<int>(records_.size());
  s.history_bytes = history_.size() * 600000;
  s.history_budget = 512u << 20;
  s.history_first = history_.empty() ? 0 : history_.front()->record.index;
  s.fps = 41.3;
  return s;
}

SnapshotPtr FakeRunner::at(int frame_index) const {
  if (history_.empty()) return nullptr;
  const int i = frame_index - history_.front()->record.index;
  return i >= 0 && i < static_cast<int>(history_.size()) ? history_[static_cast<std::size_t>(i)] : nullptr;
}

std::vector<FrameRecord> FakeRunner::records(int first) const {
  if (first >= static_cast<int>(records_.size())) return {};
  return {records_.begin() + first, records_.end()};
}

std::vector<Event> FakeRunner::events(int first) const {
  if (first >= static_cast<int>(events_.size())) return {};
  return {events_.begin() + first, events_.end()};
}

}  // namespace svoscope
