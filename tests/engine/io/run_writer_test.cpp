// SPDX-License-Identifier: MIT
#include "engine/io/run_writer.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>

#include "engine/eval/trajectory_file.h"
#include "engine/io/metrics_writer.h"
#include "tests/support/scripted_runner.h"
#include "tests/support/support.h"

namespace svoscope {
namespace {

namespace fs = std::filesystem;

RunInfo infoWithTruth(const std::vector<FrameRecord>& records) {
  RunInfo info;
  info.method = "it-svo";
  info.sequence = "fake";
  Sim3 S;
  S.scale = 2;
  S.T = SE3(so3Exp(Vec3(1, 0.5, 0)), Vec3(3, 2, 1));
  for (const FrameRecord& r : records)
    info.ground_truth.push_back({r.timestamp, S * r.T_world_cam});
  return info;
}

nlohmann::json metricsOf(const fs::path& folder) {
  return nlohmann::json::parse(test::readText(folder / "metrics.json"));
}

TEST(RunWriter, WritesTheWholeContract) {
  const test::TemporaryFolder folder;
  const auto records = test::fakeRecords(30);
  RunWriter writer;
  const fs::path out = folder / "new" / "results";
  ASSERT_TRUE(writer.begin(out, infoWithTruth(records), "method: it-svo\n").ok());
  for (const FrameRecord& record : records) ASSERT_TRUE(writer.frame(record).ok());
  const auto metrics = writer.finish(test::fakeSnapshot(records.back()), 30);
  ASSERT_TRUE(metrics.ok()) << metrics.error().message();

  for (const char* name : {"trajectory.txt", "keyframes.txt", "frames.csv", "map.ply",
                           "metrics.json", "config.yaml"}) {
    EXPECT_TRUE(fs::exists(out / name)) << name;
  }
  EXPECT_EQ(std::distance(fs::directory_iterator(out), fs::directory_iterator()), 6);
  EXPECT_EQ(loadTrajectory(out / "trajectory.txt").value().poses.size(), 26u);
  const auto keyframes = loadTrajectory(out / "keyframes.txt");
  ASSERT_TRUE(keyframes.ok());
  ASSERT_EQ(keyframes.value().poses.size(), 2u);
  EXPECT_NEAR(keyframes.value().poses[1].timestamp, 100.7, 1e-9);
  EXPECT_NE(metricsText(metrics.value()).find("align sim3, scale 2.0000, 26 of 26"),
            std::string::npos)
      << metricsText(metrics.value());
}

TEST(RunWriter, MetricsHaveExactlyTheKeysOfTheContract) {
  const test::TemporaryFolder folder;
  const auto records = test::fakeRecords(30);
  RunWriter writer;
  ASSERT_TRUE(writer.begin(folder.path(), infoWithTruth(records), "").ok());
  for (const FrameRecord& record : records) ASSERT_TRUE(writer.frame(record).ok());
  ASSERT_TRUE(writer.finish(test::fakeSnapshot(records.back()), 32).ok());
  const auto json = metricsOf(folder.path());
  std::set<std::string> keys;
  for (const auto& item : json.items()) keys.insert(item.key());
  EXPECT_EQ(keys,
            (std::set<std::string>{
                "times", "frames", "tracked", "maps", "init_frame", "tracked_fraction_after_init",
                "keyframes", "losses", "relocalisations", "relocalisation_time_s", "init_time_s",
                "ate", "rpe", "time_ms", "fps", "points", "segments", "seeds", "peak_rss_mb"}));
  EXPECT_EQ(json["frames"], 32);
  EXPECT_EQ(json["tracked"], 26);
  EXPECT_EQ(json["init_frame"], 2);
  EXPECT_NEAR(json["tracked_fraction_after_init"].get<double>(), 26.0 / 30, 1e-12);
  EXPECT_NEAR(json["init_time_s"].get<double>(), 0.2, 1e-9);
  EXPECT_EQ(json["losses"], 1);
  EXPECT_EQ(json["relocalisations"], 1);
  EXPECT_NEAR(json["relocalisation_time_s"].get<double>(), 0.2, 1e-9);
  EXPECT_EQ(json["keyframes"], 6);  // made during the run, not those left in the map
  EXPECT_EQ(json["points"], 3);
  EXPECT_EQ(json["segments"], 1);
  EXPECT_NEAR(json["ate"]["scale"].get<double>(), 2, 1e-6);
  EXPECT_LT(json["ate"]["rmse_m"].get<double>(), 1e-6);
  EXPECT_EQ(json["ate"]["alignment"], "sim3");
  EXPECT_EQ(json["rpe"]["delta"], "1s");
  EXPECT_TRUE(json["seeds"]["kl"].is_null());
  EXPECT_EQ(json["seeds"]["js"]["converged"], 60);
  EXPECT_EQ(json["seeds"]["js"]["updates_to_converge_median"], 11.0);
  EXPECT_NEAR(json["time_ms"]["tracking"]["median"].get<double>(), 24.5, 1e-9);
  EXPECT_TRUE(json["time_ms"]["mapping"].is_null());
  EXPECT_GT(json["peak_rss_mb"].get<double>(), 1);
}

TEST(RunWriter, PosesOfDifferentMapsAreInDifferentFiles) {
  for (const int second :
       {12, 22}) {  // where the second map begins, of 30 frames: it is the main one, or not
    const test::TemporaryFolder folder;
    auto records = test::fakeRecords(30);
    RunInfo info = infoWithTruth(records);
    std::size_t poses[2] = {0, 0};
    for (std::size_t i = 0; i < records.size(); ++i) {
      records[i].map_id = static_cast<int>(i) >= second;
      if (records[i].map_id)
        records[i].T_world_cam =
            SE3(records[i].T_world_cam.quaternion(), 3 * records[i].T_world_cam.translation());
      poses[records[i].map_id] += records[i].pose_good;
    }
    test::writeText(folder / "trajectory-map7.txt", "of an earlier run");
    RunWriter writer;
    ASSERT_TRUE(writer.begin(folder.path(), info, "").ok());
    for (const FrameRecord& record : records) ASSERT_TRUE(writer.frame(record).ok());
    EXPECT_EQ(loadTrajectory(folder / "trajectory.txt").value().poses.size(), poses[1])
        << "while it runs";
    ASSERT_TRUE(writer.finish(test::fakeSnapshot(records.back()), 30).ok());
    const int main_map = poses[1] >= poses[0];
    EXPECT_EQ(main_map, second == 12);
    EXPECT_EQ(loadTrajectory(folder / "trajectory.txt").value().poses.size(), poses[main_map]);
    EXPECT_EQ(loadTrajectory(folder / ("trajectory-map" + std::to_string(1 - main_map) + ".txt"))
                  .value()
                  .poses.size(),
              poses[1 - main_map]);
    EXPECT_FALSE(fs::exists(folder / "trajectory-map7.txt"));
    const auto json = metricsOf(folder.path());
    EXPECT_EQ(json["maps"], 2);
    EXPECT_EQ(json["tracked"], poses[main_map]);
    EXPECT_LT(json["ate"]["rmse_m"].get<double>(), 1e-6) << "both together would not fit";
  }
}

TEST(RunWriter, AKilledRunKeepsWhatWasWritten) {
  const test::TemporaryFolder folder;
  const auto records = test::fakeRecords(10);
  test::writeText(folder / "metrics.json", "of an earlier run");
  RunWriter writer;
  ASSERT_TRUE(writer.begin(folder.path(), infoWithTruth(records), "").ok());
  for (const FrameRecord& record : records) ASSERT_TRUE(writer.frame(record).ok());
  // The writer is still open: what is on disk now is what a kill would leave.
  EXPECT_EQ(loadTrajectory(folder / "trajectory.txt").value().poses.size(), 8u);
  EXPECT_NE(test::readText(folder / "frames.csv").find("\n9,100.900000,tracking"),
            std::string::npos);
  EXPECT_FALSE(fs::exists(folder / "metrics.json"));
}

TEST(RunWriter, WithoutTruthOrPosesTheErrorsAreNull) {
  const test::TemporaryFolder folder;
  RunWriter writer;
  ASSERT_TRUE(writer.begin(folder.path(), RunInfo(), "").ok());
  FrameRecord record;
  record.index = 0;
  ASSERT_TRUE(writer.frame(record).ok());
  ASSERT_TRUE(writer.finish(nullptr, 1).ok());
  const auto json = metricsOf(folder.path());
  for (const char* key : {"ate", "rpe", "init_frame", "tracked_fraction_after_init", "init_time_s",
                          "relocalisation_time_s"}) {
    EXPECT_TRUE(json.contains(key) && json[key].is_null()) << key;
  }
  EXPECT_EQ(json["tracked"], 0);
  EXPECT_TRUE(json["seeds"]["js"].is_null());
}

TEST(RunWriter, AFolderThatCannotBeMadeIsAnOutputError) {
  const test::TemporaryFolder folder;
  test::writeText(folder / "file", "");
  RunWriter writer;
  const Status status = writer.begin(folder / "file" / "out", RunInfo(), "");
  ASSERT_FALSE(status.ok());
  EXPECT_EQ(status.error().exitCode(), 4);
}

TEST(RunWriter, SameFramesGiveTheSameBytes) {
  const test::TemporaryFolder folder;
  const auto records = test::fakeRecords(20);
  for (const char* name : {"a", "b"}) {
    RunWriter writer;
    ASSERT_TRUE(writer.begin(folder / name, infoWithTruth(records), "x: 1\n").ok());
    for (const FrameRecord& record : records) ASSERT_TRUE(writer.frame(record).ok());
    ASSERT_TRUE(writer.finish(test::fakeSnapshot(records.back()), 20).ok());
  }
  for (const char* name : {"trajectory.txt", "keyframes.txt", "map.ply", "frames.csv"}) {
    EXPECT_EQ(test::readText(folder / "a" / name), test::readText(folder / "b" / name)) << name;
  }
}

TEST(RunMetrics, LossesAreCountedOncePerRow) {
  auto records = test::fakeRecords(30);
  for (int i = 20; i < 30; ++i) {
    records[i].state = TrackingState::lost;
    records[i].pose_good = false;
  }
  const RunMetrics metrics = metricsOfRecords(records, 30);
  EXPECT_EQ(metrics.losses, 2);
  EXPECT_EQ(metrics.relocalisations, 1);
}

}  // namespace
}  // namespace svoscope
