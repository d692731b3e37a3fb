// SPDX-License-Identifier: MIT
#include "engine/tracking/place_matching.h"

#include <gtest/gtest.h>

#include <opencv2/imgproc.hpp>

#include "engine/detect/feature_detector.h"
#include "tests/support/memory_sequence.h"
#include "tests/support/plane_scene.h"

namespace svoscope {
namespace {

constexpr int kLevels = 4;

/// The built-in room with one keyframe at its first frame; landmarks at their true places, in
/// metres.
struct Room {
  Room() : sequence(test::openBuiltIn("synthetic:room?frames=120&noise=1")) {
    map.camera = sequence->camera().pinhole;
    Keyframe& k = map.keyframes[0];
    k.id = 0;
    k.T_cam_world = pose(0);
    k.pyramid = pyramid(0);
    k.thumbnail = makeThumbnail(*k.pyramid);
    const cv::Mat depth = sequence->readDepth(0).value();
    const OccupancyGrid grid(map.camera.width, map.camera.height, 24);
    for (const DetectedFeature& f : detectFeatures(*k.pyramid, {}, grid)) {
      const double z =
          depth.at<float>(static_cast<int>(f.px.y() + 0.5), static_cast<int>(f.px.x() + 0.5));
      if (!(z > 0) || f.type != FeatureType::corner) continue;
      Landmark& landmark =
          map.addLandmark(k.T_cam_world.inverse() * (z * map.camera.unproject(f.px)), f.type);
      map.addObservation(landmark, k,
                         {f.px, map.camera.bearing(f.px), f.level, f.type, Vec2::Zero()});
    }
  }
  SE3 pose(int i) const {
    return sequence->groundTruth()[static_cast<std::size_t>(i)].T_world_cam.inverse();
  }
  PyramidPtr pyramid(int i) const { return buildPyramid(sequence->read(i).value().gray, kLevels); }
  std::vector<RelocalizationCandidate> find(const Pyramid& p) {
    PlaceIndex index;
    return matchPlaces(map, p, index, {});
  }
  std::unique_ptr<Sequence> sequence;
  Map map;
};

TEST(PlaceMatching, FindsThePoseFromAnotherPlace) {
  Room room;
  for (const int i : {25, 50}) {
    const SE3 T = room.pose(i);
    // Far enough that the points of the room move by tens of pixels.
    const double moved = (T.inverse().translation() - room.pose(0).inverse().translation()).norm();
    ASSERT_GT(moved, 0.1) << i;
    const auto found = room.find(*room.pyramid(i));
    ASSERT_FALSE(found.empty()) << i;
    EXPECT_EQ(found.front().keyframe_id, 0);
    EXPECT_LT(
        (found.front().T_cam_world.inverse().translation() - T.inverse().translation()).norm(),
        0.15 * moved)
        << i;
    EXPECT_LT(test::angleDeg(found.front().T_cam_world, T), 1.0) << i;
  }
}

TEST(PlaceMatching, TheImageMayBeTurned) {
  Room room;
  const cv::Mat gray = room.sequence->read(0).value().gray;
  const cv::Point2f centre(static_cast<float>(room.map.camera.cx),
                           static_cast<float>(room.map.camera.cy));
  cv::Mat turned;
  cv::warpAffine(gray, turned, cv::getRotationMatrix2D(centre, -30, 1), gray.size());
  const auto found = room.find(*buildPyramid(turned, kLevels));
  ASSERT_FALSE(found.empty());
  EXPECT_NEAR(test::angleDeg(found.front().T_cam_world, room.pose(0)), 30, 1);
}

TEST(PlaceMatching, AnotherPlaceIsNotTakenForThisOne) {
  Room room;
  const auto desk = test::openBuiltIn("synthetic:corridor?frames=2");
  EXPECT_TRUE(room.find(*buildPyramid(desk->read(0).value().gray, kLevels)).empty());
  EXPECT_TRUE(
      room.find(*buildPyramid(cv::Mat(480, 640, CV_8UC1, cv::Scalar(90)), kLevels)).empty());
}

TEST(PlaceMatching, EmptyMapsGiveNothing) {
  Room room;
  PlaceIndex index;
  EXPECT_TRUE(matchPlaces(Map{}, *room.pyramid(0), index, {}).empty());
}

}  // namespace
}  // namespace svoscope
