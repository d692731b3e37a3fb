// SPDX-License-Identifier: MIT
// The part of RecordingWriter that writes a frame.
#include <fmt/format.h>

#include <opencv2/imgcodecs.hpp>

#include "engine/recording/recording_writer.h"

namespace svoscope {

namespace {

bool samePose(const SE3& a, const SE3& b) {
  return a.translation() == b.translation() && a.quaternion().coeffs() == b.quaternion().coeffs();
}

bool samePoint(const MapPointView& a, const MapPointView& b) {
  return a.position == b.position && a.position_end == b.position_end && a.type == b.type &&
         a.sigma == b.sigma && a.observations == b.observations &&
         a.reference_keyframe == b.reference_keyframe;
}

}  // namespace

Status RecordingWriter::frame(const Snapshot& s) {
  const bool good = started() && writeRecord(s) && writeLists(s) && writeSeeds(s) &&
                    writeKeyframes(s) && writePoints(s) && writeImage(s);
  return good ? Status(Done{}) : failure();
}

bool RecordingWriter::writeEvent(const Event& event, int shown_in) {
  PutColumns put(insert_event_);
  visitEvent(event, put);
  insert_event_.put(events_++);
  if (shown_in < 0)
    insert_event_.putNull();
  else
    insert_event_.put(shown_in);
  return insert_event_.run();
}

bool RecordingWriter::writeRecord(const Snapshot& s) {
  PutColumns put(insert_frame_);
  visitRecord(s.record, put);
  insert_frame_.put(static_cast<std::int64_t>(s.sequence_number)).put(s.keyframes != nullptr);
  if (!insert_frame_.run()) return false;
  for (const Event& event : s.events) {
    if (!writeEvent(event, s.record.index)) return false;
  }
  return true;
}

bool RecordingWriter::writeLists(const Snapshot& s) {
  int n = 0;
  for (const FeatureView& feature : s.features) {
    PutColumns put(insert_feature_);
    visitFeature(feature, put);
    if (!insert_feature_.put(rowKey(s.record.index, n++)).put(s.record.index).run()) return false;
  }
  if (!s.seed_updates) return true;
  n = 0;
  for (const SeedUpdateView& update : *s.seed_updates) {
    PutColumns put(insert_update_);
    visitSeedUpdate(update, put);
    if (!insert_update_.put(rowKey(s.record.index, n++)).put(s.record.index).run()) return false;
  }
  return true;
}

bool RecordingWriter::writeSeeds(const Snapshot& s) {
  if (!s.seeds) return true;
  const int frame = s.record.index;
  SeedIndex now;
  now.set(s.seeds);
  if (seeds_.list()) {
    for (const SeedView& seed : *seeds_.list()) {
      // Ended seeds are shown once; others vanish only with their map.
      if (seed.ending == SeedEnding::none && !now.find(seed.id) &&
          !writeEnding(seed, "map_given_up", frame))
        return false;
    }
  }
  for (const SeedView& seed : *s.seeds) {
    if (!seeds_.find(seed.id) && !writeNewSeed(seed, frame)) return false;
    if (seed.ending != SeedEnding::none && !writeEnding(seed, nameOf(seed.ending), frame))
      return false;
  }
  const bool complete = since_key_ == 0;
  since_key_ = (since_key_ + 1) % kSeedKeyInterval;
  blob_.clear();
  encodeSeeds(*s.seeds, complete ? SeedIndex() : seeds_, blob_);
  seeds_ = std::move(now);
  return insert_states_.put(frame)
      .put(complete)
      .put(static_cast<std::int64_t>(s.seeds->size()))
      .putBlob(blob_.data(), blob_.size())
      .run();
}

bool RecordingWriter::writeNewSeed(const SeedView& v, int frame) {
  insert_seed_.put(v.id)
      .put(frame)
      .put(v.keyframe_id)
      .put(nameOf(v.type))
      .put(static_cast<int>(v.level));
  PutColumns put(insert_seed_);
  put("", v.px_ref);
  if (v.type == FeatureType::segment)
    put("", v.px_ref_end);
  else
    insert_seed_.putNull().putNull();
  put("", v.direction);
  put("", v.range);
  if (v.true_inv_distance > 0)
    put("", v.true_inv_distance);
  else
    insert_seed_.putNull();
  return insert_seed_.run();
}

bool RecordingWriter::writeEnding(const SeedView& v, const char* ending, int frame) {
  end_seed_.put(frame).put(ending).put(v.updates).put(v.failures);
  PutColumns put(end_seed_);
  for (const float value : {v.mu, v.sigma, v.a, v.b}) put("", value);
  return end_seed_.put(v.id).run();
}

bool RecordingWriter::writeKeyframes(const Snapshot& s) {
  if (!s.keyframes || s.keyframes == last_keyframes_) return true;
  last_keyframes_ = s.keyframes;
  const auto writePose = [&](const KeyframeView& k, bool gone) {
    PutColumns put(insert_pose_);
    visitKeyframe(k, put);
    return insert_pose_.put(s.record.index).put(gone).run();
  };
  std::map<int, KeyframeView> now;
  for (const KeyframeView& view : *s.keyframes) {
    KeyframeView k = view;
    k.pyramid.reset();
    const auto old = keyframes_.find(k.id);
    const bool same = old != keyframes_.end() && old->second.in_map == k.in_map &&
                      samePose(old->second.T_world_cam, k.T_world_cam);
    if (old == keyframes_.end() && !insert_keyframe_.put(k.id).put(k.frame_index).run())
      return false;
    if (!same && !writePose(k, false)) return false;
    now.emplace(k.id, std::move(k));
  }
  for (const auto& [id, k] : keyframes_) {
    if (!now.count(id) && !writePose(k, true)) return false;
  }
  keyframes_ = std::move(now);
  return true;
}

bool RecordingWriter::writePoints(const Snapshot& s) {
  if (!s.points || s.points == last_points_) return true;
  last_points_ = s.points;
  const auto write = [&](const MapPointView& p, bool gone) {
    PutColumns put(insert_point_);
    visitPoint(p, put);
    return insert_point_.put(s.record.index).put(gone).run();
  };
  std::map<std::int64_t, MapPointView> now;
  for (const MapPointView& p : *s.points) {
    const auto old = points_.find(p.id);
    if ((old == points_.end() || !samePoint(old->second, p)) && !write(p, false)) return false;
    now.emplace_hint(now.end(), p.id, p);
  }
  for (const auto& [id, p] : points_) {
    if (!now.count(id) && !write(p, true)) return false;
  }
  points_ = std::move(now);
  return true;
}

bool RecordingWriter::writeImage(const Snapshot& s) {
  if (!s.pyramid || s.pyramid->empty()) return true;
  if (!levels_written_) {
    levels_written_ =
        database_->run(fmt::format("UPDATE run SET pyramid_levels = {}", s.pyramid->size()));
    if (!levels_written_) return false;
  }
  if (!cv::imencode(".jpg", s.pyramid->front(), jpeg_,
                    {cv::IMWRITE_JPEG_QUALITY, options_.jpeg_quality}))
    return true;
  return insert_image_.put(s.record.index).putBlob(jpeg_.data(), jpeg_.size()).run();
}

}  // namespace svoscope
