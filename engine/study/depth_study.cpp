// SPDX-License-Identifier: MIT
#include "engine/study/depth_study.h"

#include <algorithm>
#include <cmath>

#include "engine/base/quantile.h"
#include "engine/frame/rectifier.h"
#include "engine/study/depth_study_judge.h"
#include "engine/study/rule_variants.h"

namespace svoscope {

namespace {

struct StudyKeyframe {
  JobKeyframe view;
  std::vector<std::vector<StudySeed>> seeds;  // by rule, then the same order
};

/// Nearest true depth, if the surroundings lie on one surface.
std::optional<double> trueDepth(const cv::Mat& depth, const Vec2& px, double max_spread) {
  const int x = static_cast<int>(std::lround(px.x())), y = static_cast<int>(std::lround(px.y()));
  if (x < 2 || y < 2 || x >= depth.cols - 2 || y >= depth.rows - 2) return std::nullopt;
  float low = depth.at<float>(y, x), high = low;
  for (int v = y - 2; v <= y + 2; ++v) {
    for (int u = x - 2; u <= x + 2; ++u) {
      low = std::min(low, depth.at<float>(v, u));
      high = std::max(high, depth.at<float>(v, u));
    }
  }
  if (!(low > 0) || !std::isfinite(high) || high - low > max_spread * low) return std::nullopt;
  return depth.at<float>(y, x);
}

class Study {
 public:
  Study(Sequence& sequence, const DepthStudyOptions& o)
      : sequence_(sequence), o_(o), rectifier_(sequence.camera()) {
    for (const RuleVariant& rule : ruleVariants()) {
      MappingParameters p = o.mapping;
      p.filter.rule = rule.rule;
      p.filter.rules = rule.settings;
      p.filter.shadow = false;
      parameters_.push_back(p);
    }
    finished_.resize(parameters_.size());
  }

  Result<DepthStudyResult> run() {
    result_.sequence = sequence_.name();
    result_.poses_from = o_.poses_from;
    const int end =
        o_.max_frames < 0 ? sequence_.size() : std::min(sequence_.size(), o_.start + o_.max_frames);
    for (int i = o_.start; i < end; ++i) {
      frame(i);
      if (o_.progress && !o_.progress(i + 1 - o_.start, end - o_.start)) break;
    }
    retire(end + o_.max_age + 1);
    if (result_.frames == 0)
      return inputError("no frame has a pose", result_.sequence,
                        "use a sequence with ground truth");
    if (finished_[0].empty())
      return inputError("has no depth to hold the seeds against", result_.sequence,
                        "use a sequence with depth images");
    for (std::size_t r = 0; r < finished_.size(); ++r)
      result_.rows.push_back(
          judgeSeeds(ruleVariants()[r].name, finished_[r], parameters_[r].filter, o_));
    return result_;
  }

 private:
  void frame(int index) {
    const auto at = static_cast<std::size_t>(index);
    if (at >= o_.poses.size() || !o_.poses[at]) return;
    const Result<SequenceImage> image = sequence_.read(index);
    if (!image.ok()) return;
    const cv::Mat gray = rectifier_.rectify(image.value().gray);
    const JobKeyframe view{index, buildPyramid(gray, pyramidLevels(gray.cols)),
                           o_.poses[at]->inverse(), index};
    ++result_.frames;
    retire(index);
    for (std::size_t rule = 0; rule < parameters_.size(); ++rule) measure(view, rule);
    if (next_keyframe_ <= index) addKeyframe(view);
  }

  /// The engine's own mapping job over the seeds of one rule.
  void measure(const JobKeyframe& view, std::size_t rule) {
    MappingJob job;
    job.frame_index = view.frame_index;
    job.pyramid = view.pyramid;
    job.T_cam_world = view.T_cam_world;
    job.camera = rectifier_.pinhole();
    std::vector<StudySeed*> targets;
    for (StudyKeyframe& keyframe : keyframes_) {
      const int slot = static_cast<int>(job.keyframes.size());
      job.keyframes.push_back(keyframe.view);
      for (StudySeed& s : keyframe.seeds[rule]) {
        if (s.converged_after > 0 || s.seed.ending != SeedEnding::none) continue;
        const double sigma = std::sqrt(s.seed.belief.sigma2);
        job.seeds.push_back({static_cast<std::int64_t>(targets.size()), slot, s.seed.anchor,
                             s.seed.belief.mu, sigma});
        targets.push_back(&s);
      }
    }
    const MappingResult found = runMappingJob(job, parameters_[rule]);
    for (std::size_t i = 0; i < targets.size(); ++i)
      targets[i]->apply(found.measurements[i], parameters_[rule].filter);
  }

  void addKeyframe(const JobKeyframe& view) {
    const Result<cv::Mat> read = sequence_.readDepth(view.frame_index);
    if (!read.ok() || read.value().empty()) return;
    const cv::Mat depth = rectifier_.rectifyDepth(read.value());
    const Pinhole& camera = rectifier_.pinhole();
    const OccupancyGrid empty(camera.width, camera.height,
                              scaledCell(o_.mapping.detector.cell_px, camera.width));
    std::vector<std::pair<DetectedFeature, double>> features;
    std::vector<double> depths;
    for (const DetectedFeature& f : detectFeatures(*view.pyramid, o_.mapping.detector, empty)) {
      const auto z = trueDepth(depth, f.px, o_.max_spread);
      result_.edge_seeds += !z;
      if (!z || static_cast<int>(features.size()) >= o_.seeds_per_keyframe) continue;
      features.emplace_back(f, *z);
      depths.push_back(*z);
    }
    if (features.empty()) return;
    // The prior of a new seed, as a tracker that knows the scene's depth range would set it.
    const double median = *interpolatedQuantile(depths, 0.5),
                 near = *interpolatedQuantile(depths, 0.05);
    StudyKeyframe keyframe{view, {}};
    for (const MappingParameters& p : parameters_) {
      keyframe.seeds.emplace_back();
      for (const auto& [f, z] : features) {
        StudySeed s;
        s.seed = makeSeed(f, camera, median, near, p.filter);
        s.seed.has_shadow = false;
        s.true_inverse =
            s.seed.anchor.f.z() / z;  // depth images hold z, seeds measure along the ray
        s.born = view.frame_index;
        keyframe.seeds.back().push_back(s);
      }
    }
    keyframes_.push_back(std::move(keyframe));
    next_keyframe_ = view.frame_index + o_.keyframe_every;
    ++result_.keyframes;
  }

  /// Keyframes whose seeds had their time.
  void retire(int now) {
    while (!keyframes_.empty() && now - keyframes_.front().view.frame_index > o_.max_age) {
      for (std::size_t r = 0; r < finished_.size(); ++r) {
        const auto& seeds = keyframes_.front().seeds[r];
        finished_[r].insert(finished_[r].end(), seeds.begin(), seeds.end());
      }
      keyframes_.erase(keyframes_.begin());
    }
  }

  Sequence& sequence_;
  const DepthStudyOptions& o_;
  Rectifier rectifier_;
  std::vector<MappingParameters> parameters_;  // by rule
  std::vector<std::vector<StudySeed>> finished_;
  std::vector<StudyKeyframe> keyframes_;
  DepthStudyResult result_;
  int next_keyframe_ = 0;
};

}  // namespace

Status depthStudyPossible(Sequence& sequence) {
  if (sequence.groundTruth().empty())
    return inputError("has no ground truth, which a depth study needs for the scale",
                      sequence.name(), "use a sequence with ground truth and depth images");
  for (int i = 0; i < sequence.size(); ++i) {
    const Result<cv::Mat> depth = sequence.readDepth(i);
    if (depth.ok() && !depth.value().empty()) return Done{};
  }
  return inputError("has no depth to hold the seeds against", sequence.name(),
                    "use a sequence with depth images");
}

Result<DepthStudyResult> runDepthStudy(Sequence& sequence, const DepthStudyOptions& options) {
  return Study(sequence, options).run();
}

}  // namespace svoscope
