// SPDX-License-Identifier: MIT
// Start of monocular odometry: tracks features from a first frame until two views, and then all
// frames between them, give camera motion and depth reliably. The first map decides the accuracy
// of the whole run, so a doubtful start is refused and waited out.
#pragma once

#include <deque>
#include <memory>
#include <opencv2/core/mat.hpp>
#include <string>
#include <vector>

#include "engine/base/kinds.h"
#include "engine/geometry/camera.h"
#include "engine/geometry/se3.h"
#include "engine/geometry/two_view.h"
#include "engine/tracking/initializer_parameters.h"
#include "engine/tracking/initializer_reference.h"

namespace svoscope {

/// A rectified frame. The pyramid (CV_8UC1, 2x2 means) is kept while the frame is a reference.
struct InitializerFrame {
  int index = 0;
  double timestamp = 0;  ///< s
  std::shared_ptr<const std::vector<cv::Mat>> pyramid;
};

/// A track while collecting, for display. Pixels of level 0.
struct InitializerTrack {
  std::int64_t id = -1;
  FeatureType type = FeatureType::corner;
  Vec2 px_ref = Vec2::Zero(), px_cur = Vec2::Zero();
};

/// A point of the first map. Depths are in units of the median depth in the reference frame.
struct InitializerPoint {
  Vec2 px_ref = Vec2::Zero();  ///< level 0, reference frame
  Vec2 px_cur = Vec2::Zero();  ///< level 0, current frame: measured (edgelets: projected)
  int level = 0;
  FeatureType type = FeatureType::corner;
  Vec2 gradient_dir = Vec2::Zero();  ///< unit vector in the reference image; zero for corners
  Vec3 p_ref = Vec3::Zero();         ///< in the reference camera's frame
  double sigma_inv_depth = 0;        ///< of 1 / z in the reference
  double residual_px = 0;            ///< rms over the frames used
};

struct InitializerPose {
  int frame_index = -1;
  double timestamp = 0;
  SE3 T_frame_ref;
};

struct InitializerOutput {
  bool initialized = false;
  TwoViewVerdict verdict = TwoViewVerdict::too_few_tracks;
  TwoViewModel model = TwoViewModel::none;
  std::string reason;        ///< one line: what is waited for, or what was found
  int reference_index = -1;  ///< frame the tracks below start in
  std::vector<InitializerTrack> tracks;
  int tracks_alive = 0;
  double disparity_px = 0;  ///< median over tracks
  int inliers = 0;
  double rms_px = 0;        ///< over all frames used
  double parallax_deg = 0;  ///< median of inliers, reference to current
  double depth_sigma = 0;   ///< median relative uncertainty of the points' depths

  // On success only.
  SE3 T_cur_ref;
  double reference_timestamp = 0;
  std::shared_ptr<const std::vector<cv::Mat>> reference_pyramid;
  std::vector<InitializerPoint> points;
  std::vector<InitializerPose> poses;  ///< from the reference (identity) to the current frame
};

class Initializer {
 public:
  Initializer(const Pinhole& camera, const InitializerParameters& parameters);

  /// Takes the next frame. After success the initializer is reset.
  InitializerOutput process(const InitializerFrame& frame);
  /// Forgets all references.
  void reset();

 private:
  void renewReferences(const InitializerFrame& frame);
  bool dueForAttempt(const InitializerReference& reference) const;
  void fillTracks(InitializerOutput& out) const;

  Pinhole camera_;
  InitializerParameters parameters_;
  std::deque<std::unique_ptr<InitializerReference>> references_;  ///< oldest first
  std::int64_t next_id_ = 0;
};

}  // namespace svoscope
