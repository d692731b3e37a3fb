// SPDX-License-Identifier: MIT
// The part of RecordingFile that brings back a single frame.
#include <fmt/format.h>

#include <opencv2/imgcodecs.hpp>

#include "engine/frame/pyramid.h"
#include "engine/recording/recording_file.h"
#include "engine/runner/make_runner.h"
#include "engine/snapshot/seed_placement.h"

namespace svoscope {

namespace {

std::size_t bytesOf(const Snapshot& s) {
  std::size_t bytes = sizeof(Snapshot) + s.features.size() * sizeof(FeatureView);
  if (s.seeds) bytes += s.seeds->size() * sizeof(SeedView);
  if (s.seed_updates) bytes += s.seed_updates->size() * sizeof(SeedUpdateView);
  return bytes;
}

const KeyframeView* findKeyframe(const std::vector<KeyframeView>& keyframes, int id) {
  const auto it = std::lower_bound(keyframes.begin(), keyframes.end(), id,
                                   [](const KeyframeView& k, int wanted) { return k.id < wanted; });
  return it != keyframes.end() && it->id == id ? &*it : nullptr;
}

}  // namespace

std::shared_ptr<Snapshot> RecordingFile::rowOnly(std::size_t row) const {
  const FrameRow& frame = frames_[row];
  auto s = std::make_shared<Snapshot>();
  s->sequence_number = frame.snapshot;
  s->record = frame.record;
  for (const EventRow& event : events_) {
    if (event.shown_in == frame.record.index) s->events.push_back(event.event);
  }
  s->bytes = sizeof(Snapshot);
  return s;
}

Result<std::shared_ptr<Snapshot>> RecordingFile::values(std::size_t row) {
  auto s = rowOnly(row);
  const int index = s->record.index;
  if (frames_[row].readable) {
    s->keyframes = keyframes_.at(index);
    s->points = points_.at(index);
    s->mapping = mapping(index);
    if (!readFeatures(*s) || !readUpdates(*s) || !readSeeds(*s)) {
      seeds_frame_ = -1;
      return damaged(fmt::format("frame {} cannot be read", index));
    }
  }
  s->bytes = bytesOf(*s);
  return s;
}

bool RecordingFile::readFeatures(Snapshot& s) {
  select_features_.put(rowKey(s.record.index, 0)).put(rowKey(s.record.index + 1, 0));
  while (select_features_.next()) {
    s.features.emplace_back();
    GetColumns get(select_features_);
    visitFeature(s.features.back(), get);
  }
  return !select_features_.failed();
}

bool RecordingFile::readUpdates(Snapshot& s) {
  auto updates = std::make_shared<std::vector<SeedUpdateView>>();
  select_updates_.put(rowKey(s.record.index, 0)).put(rowKey(s.record.index + 1, 0));
  while (select_updates_.next()) {
    updates->emplace_back();
    GetColumns get(select_updates_);
    visitSeedUpdate(updates->back(), get);
  }
  s.seed_updates = std::move(updates);
  return !select_updates_.failed();
}

/// Goes on from what was unpacked last, or from the last blob that stands for itself.
bool RecordingFile::unpackSeeds(int frame) {
  const auto after = std::upper_bound(complete_seeds_.begin(), complete_seeds_.end(), frame);
  if (after == complete_seeds_.begin()) return false;
  const int complete = *std::prev(after);
  int from = complete - 1;
  if (seeds_frame_ >= complete && seeds_frame_ <= frame)
    from = seeds_frame_;
  else
    seeds_ = SeedIndex();
  select_states_.put(from).put(frame);
  bool good = true;
  while (select_states_.next()) {
    if (!good) continue;
    seeds_frame_ = static_cast<int>(select_states_.integer());
    std::size_t size = 0;
    const unsigned char* data = select_states_.blob(size);
    ByteReader in(data, size);
    auto seeds = std::make_shared<std::vector<SeedView>>();
    good = data && decodeSeeds(in, seeds_, *seeds);
    seeds_.set(std::move(seeds));
  }
  return good && !select_states_.failed() && seeds_frame_ == frame;
}

bool RecordingFile::readSeeds(Snapshot& s) {
  if (!unpackSeeds(s.record.index)) return false;
  auto seeds = std::make_shared<std::vector<SeedView>>(*seeds_.list());
  place(*seeds, s, s.mapping->search.search_sigmas);
  s.seeds = std::move(seeds);
  return true;
}

void RecordingFile::place(std::vector<SeedView>& seeds, const Snapshot& s, double sigmas) const {
  SeedPlacement placement{SE3(), s.record.T_world_cam.inverse(), run_.info.camera, sigmas, true};
  int keyframe = -1;
  for (SeedView& seed : seeds) {
    if (seed.keyframe_id != keyframe || keyframe < 0) {
      keyframe = seed.keyframe_id;
      const KeyframeView* known = findKeyframe(*s.keyframes, keyframe);
      placement.T_world_kf = known ? known->T_world_cam : poseOfGone(keyframe, s.record.index);
    }
    placeSeed(seed, placement);
  }
}

SE3 RecordingFile::poseOfGone(int keyframe, int frame) const {
  SE3 pose;
  for (const auto& change : keyframes_.changes()) {
    if (change.frame > frame) break;
    if (change.value.id == keyframe) pose = change.value.T_world_cam;
  }
  return pose;
}

std::shared_ptr<const MappingParameters> RecordingFile::mapping(int frame) {
  const auto end = std::upper_bound(parameters_.begin(), parameters_.end(), frame,
                                    [](int f, const ParameterChange& c) { return f < c.from; });
  const auto wanted = static_cast<std::size_t>(end - parameters_.begin());
  if (mapping_ && wanted == mapping_changes_) return mapping_;
  Parameters parameters;
  for (std::size_t i = 0; i < wanted; ++i) {
    // Keys that this version does not know are shown, but nothing is recomputed with them.
    (void)setParameter(parameters, parameters_[i].view.key, parameters_[i].view.value);
  }
  (void)applyMethod(parameters, run_.info.method);
  mapping_changes_ = wanted;
  mapping_ = std::make_shared<const MappingParameters>(parameters.tracker.mapping);
  return mapping_;
}

std::shared_ptr<const std::vector<cv::Mat>> RecordingFile::pyramid(int frame) {
  select_image_.put(frame);
  cv::Mat image;
  while (select_image_.next()) {
    std::size_t size = 0;
    const unsigned char* data = select_image_.blob(size);
    if (!data) continue;
    const cv::Mat bytes(1, static_cast<int>(size), CV_8UC1, const_cast<unsigned char*>(data));
    image = cv::imdecode(bytes, cv::IMREAD_GRAYSCALE);
  }
  if (image.empty() || image.cols != run_.info.camera.width ||
      image.rows != run_.info.camera.height)
    return nullptr;
  return buildPyramid(image, std::clamp(run_.pyramid_levels, 1, 12));
}

}  // namespace svoscope
