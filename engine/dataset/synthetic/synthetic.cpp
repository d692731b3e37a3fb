// SPDX-License-Identifier: MIT
#include "engine/dataset/synthetic/synthetic.h"

#include <cmath>
#include <opencv2/core.hpp>

#include "engine/dataset/synthetic/exposure.h"
#include "engine/dataset/synthetic/patterns.h"
#include "engine/dataset/synthetic/random.h"
#include "engine/dataset/synthetic/renderer.h"
#include "engine/dataset/synthetic/world.h"

namespace svoscope {
namespace {

using namespace synthetic;

const int kSubExposures = 8;         ///< for motion blur
const double kOccluderDepth = 0.45;  ///< m, nearer than the scenes

class SyntheticSequence : public Sequence {
 public:
  explicit SyntheticSequence(const SyntheticSpec& spec);

  const std::string& name() const override { return spec_.text; }
  int size() const override { return spec_.frames; }
  const Camera& camera() const override { return camera_; }
  double timestamp(int index) const override { return index / spec_.rate_hz; }
  Result<SequenceImage> read(int index) override;
  const Trajectory& groundTruth() const override { return truth_; }
  Result<cv::Mat> readDepth(int index) override;

 private:
  SE3 poseAt(double time) const;
  std::vector<Quad> occluderAt(double time) const;
  /// All that is not part of the resting scene, in the camera frame.
  std::vector<Quad> movingAt(double time) const;
  cv::Mat renderLight(int index) const;
  bool black(int index) const {
    return index >= spec_.blackout_first && index < spec_.blackout_first + spec_.blackout_count;
  }
  std::uint64_t frameSeed(int index) const { return mixSeed(spec_.seed, 1000003u + index); }

  SyntheticSpec spec_;
  World world_;
  Camera camera_;
  Trajectory truth_;
  std::vector<float> gains_;
  int occluder_texture_ = -1;
};

SyntheticSequence::SyntheticSequence(const SyntheticSpec& spec)
    : spec_(spec),
      world_(buildWorld(spec)),
      gains_(illumination(spec.frames, spec.light, spec.seed)) {
  const double f = world_.focal * spec.width / world_.preset_width;
  camera_.pinhole = {
      spec.width, spec.height, f, f, 0.5 * (spec.width - 1), 0.5 * (spec.height - 1)};
  camera_.rate_hz = spec.rate_hz;
  const std::vector<float> steps = illuminationSteps(spec.frames, spec.step);
  for (int i = 0; i < spec.frames; ++i) gains_[i] *= steps[i];
  truth_.reserve(spec.frames);
  for (int i = 0; i < spec.frames; ++i) truth_.push_back({timestamp(i), poseAt(timestamp(i))});
  if (spec.occlude > 0) {
    const Surface surface{0.5, 0.4, 0.001, mixSeed(spec.seed, 77)};
    occluder_texture_ = world_.scene.addTexture(shapes(surface, 110, 80, 0.08));
  }
}

SE3 SyntheticSequence::poseAt(double time) const {
  const SE3 pose = world_.motion(time * spec_.speed);
  if (spec_.travel == 1) return pose;
  const Vec3 start = world_.motion(0).translation();
  return SE3(pose.quaternion(), start + spec_.travel * (pose.translation() - start));
}

/// A card before the lens that sweeps to and fro; always whole in the image, so that the covered
/// fraction is the one asked for.
std::vector<Quad> SyntheticSequence::occluderAt(double time) const {
  if (occluder_texture_ < 0) return {};
  const Pinhole& p = camera_.pinhole;
  const double side = std::sqrt(spec_.occlude), w = side * p.width, h = side * p.height;
  const double x = (p.width - w) * (0.5 + 0.5 * std::sin(1.9 * time - 1.2)) - 0.5;
  const double y = (p.height - h) * (0.5 + 0.5 * std::sin(1.3 * time + 0.4)) - 0.5;
  const Vec3 corner = kOccluderDepth * p.unproject({x, y});
  return {{corner, Vec3(kOccluderDepth * w / p.fx, 0, 0), Vec3(0, kOccluderDepth * h / p.fy, 0),
           occluder_texture_, 1.f}};
}

std::vector<Quad> SyntheticSequence::movingAt(double time) const {
  std::vector<Quad> quads = occluderAt(time);
  const SE3 T_cam_world = poseAt(time).inverse();
  for (const Mover& mover : world_.movers) {
    const SE3 T_cam_mover = T_cam_world * mover.motion(time);
    for (Quad quad : mover.quads) {
      quad.corner = T_cam_mover * quad.corner;
      quad.edge_u = T_cam_mover.quaternion() * quad.edge_u;
      quad.edge_v = T_cam_mover.quaternion() * quad.edge_v;
      quads.push_back(quad);
    }
  }
  return quads;
}

cv::Mat SyntheticSequence::renderLight(int index) const {
  const double t = timestamp(index), exposure = spec_.blur / spec_.rate_hz;
  if (exposure <= 0) return render(world_.scene, camera_.pinhole, poseAt(t), movingAt(t)).gray;
  cv::Mat sum(spec_.height, spec_.width, CV_32FC1, cv::Scalar(0));
  for (int i = 0; i < kSubExposures; ++i) {
    // Centred on the time stamp: the true pose is the one in the middle of the exposure.
    const double ti = t + exposure * ((i + 0.5) / kSubExposures - 0.5);
    cv::add(sum, render(world_.scene, camera_.pinhole, poseAt(ti), movingAt(ti)).gray, sum);
  }
  sum.convertTo(sum, CV_32F, 1.0 / kSubExposures);
  return sum;
}

Result<SequenceImage> SyntheticSequence::read(int index) {
  const cv::Mat light = black(index) ? cv::Mat(spec_.height, spec_.width, CV_32FC1, cv::Scalar(0))
                                     : renderLight(index);
  return SequenceImage{index, timestamp(index),
                       expose(light, gains_.at(index), spec_.noise, frameSeed(index))};
}

Result<cv::Mat> SyntheticSequence::readDepth(int index) {
  const double t = timestamp(index);
  return renderDepth(world_.scene, camera_.pinhole, poseAt(t), movingAt(t));
}

}  // namespace

bool isSyntheticSpec(const std::string& text) { return text.rfind("synthetic:", 0) == 0; }

Result<std::unique_ptr<Sequence>> openSyntheticSequence(const std::string& text) {
  const auto spec = parseSyntheticSpec(text);
  if (!spec) return spec.error();
  return std::unique_ptr<Sequence>(std::make_unique<SyntheticSequence>(spec.value()));
}

}  // namespace svoscope
