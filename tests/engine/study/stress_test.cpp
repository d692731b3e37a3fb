// SPDX-License-Identifier: MIT
#include "engine/study/stress.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "engine/dataset/synthetic/spec.h"
#include "engine/study/kept_sequence.h"

namespace svoscope {
namespace {

Stress oneLevel(const std::string& options) {
  return {"test", "", {{"s", "synthetic:room?size=320x240&" + options}}};
}

StressRow runOne(const Stress& stress, const std::string& method = "svo") {
  StressOptions options;
  options.methods = {method};
  const auto rows = runStresses({stress}, options);
  EXPECT_TRUE(rows.ok());
  EXPECT_EQ(rows.value().size(), 1u);
  return rows.value().front();
}

TEST(StressTable, EverySequenceIsKnownAndStrengthsDiffer) {
  std::set<std::string> names;
  for (const Stress& stress : stressTable({120, 160, 120})) {
    EXPECT_TRUE(names.insert(stress.name).second) << stress.name;
    EXPECT_FALSE(stress.meaning.empty()) << stress.name;
    EXPECT_GE(stress.levels.size(), 3u) << stress.name;
    std::set<std::string> texts;
    for (const StressLevel& level : stress.levels) {
      const auto spec = parseSyntheticSpec(level.sequence);
      ASSERT_TRUE(spec.ok()) << spec.error().message();
      EXPECT_EQ(spec.value().frames, 120);
      EXPECT_EQ(spec.value().width, 160);
      EXPECT_TRUE(texts.insert(level.sequence).second) << level.sequence;
      if (stress.name == "blackout") {
        EXPECT_EQ(spec.value().blackout_first, 60);
      }
    }
  }
  EXPECT_TRUE(names.count("blackout") && names.count("speed"));
}

TEST(Stress, AnEasySequenceHolds) {
  const StressRow row = runOne(oneLevel("frames=60"));
  ASSERT_TRUE(row.start_s && row.tracked_fraction && row.relative_ate);
  EXPECT_EQ(row.visible, 60);
  EXPECT_LT(*row.start_s, 1);
  EXPECT_GT(*row.tracked_fraction, 0.98);
  EXPECT_LT(*row.relative_ate, 0.005);
  EXPECT_EQ(row.losses, 0);
  EXPECT_FALSE(row.blackout);
  EXPECT_FALSE(row.recovery_s);
  EXPECT_EQ(row.outcome, StressOutcome::held);
}

TEST(Stress, BlackFramesAreNotHeldAgainstTheMethodButTheTimeAfterThemIs) {
  const StressRow row = runOne(oneLevel("frames=90&blackout=50:10"));
  EXPECT_EQ(row.visible, 80);
  EXPECT_TRUE(row.blackout);
  EXPECT_EQ(row.losses, 1);
  ASSERT_TRUE(row.recovery_s && row.tracked_fraction);
  EXPECT_GE(*row.recovery_s, 0);
  EXPECT_LE(*row.recovery_s, 0.5);
  const StressRow never = runOne(oneLevel("frames=90&blackout=50:40"));
  EXPECT_TRUE(never.blackout);
  EXPECT_FALSE(never.recovery_s);
}

TEST(Stress, WithoutAStartItIsBroken) {
  const StressRow row = runOne({"test", "", {{"s", "synthetic:still?size=160x120&frames=20"}}});
  EXPECT_FALSE(row.start_s || row.tracked_fraction || row.relative_ate);
  EXPECT_EQ(row.outcome, StressOutcome::broken);
}

TEST(Stress, RowsComeByStrengthThenMethodAndAreTheSameAgain) {
  Stress stress = oneLevel("frames=30");
  stress.levels.push_back({"t", "synthetic:room?size=160x120&frames=30&noise=3"});
  StressOptions options;
  options.methods = {"svo", "it-svo"};
  std::vector<std::string> order;
  options.finished = [&](const StressRow& r) {
    order.push_back(r.strength + " " + r.method);
    return Status(Done{});
  };
  const auto first = runStresses({stress}, options), second = runStresses({stress}, options);
  ASSERT_TRUE(first.ok() && second.ok());
  order.resize(4);
  EXPECT_THAT(order, testing::ElementsAre("s svo", "s it-svo", "t svo", "t it-svo"));
  for (int i = 0; i < 4; ++i) {
    EXPECT_EQ(first.value()[i].relative_ate, second.value()[i].relative_ate);
    EXPECT_EQ(first.value()[i].tracked_fraction, second.value()[i].tracked_fraction);
  }
}

TEST(Stress, StopsEarlyAndPassesErrorsOn) {
  std::atomic<bool> stop{true};
  StressOptions options;
  options.methods = {"svo"};
  options.stop = &stop;
  EXPECT_TRUE(runStresses({oneLevel("frames=30")}, options).value().empty());
  options.stop = nullptr;
  options.finished = [](const StressRow&) { return Status(outputError("full", "disk", "")); };
  EXPECT_FALSE(runStresses({oneLevel("frames=20")}, options).ok());
  options.methods = {"dso"};
  EXPECT_FALSE(runStresses({oneLevel("frames=20")}, options).ok());
  EXPECT_FALSE(runStresses({oneLevel("fog=1")}, options).ok());
}

TEST(KeptSequence, ReadsEachImageOnceForAllCopies) {
  KeptSequence a(openSequence("synthetic:still?size=64x48&frames=3").value());
  KeptSequence b(a);
  const cv::Mat first = a.read(1).value().gray, second = b.read(1).value().gray;
  EXPECT_EQ(first.data, second.data);
  EXPECT_EQ(b.read(1).value().index, 1);
  EXPECT_EQ(b.timestamp(2), a.timestamp(2));
}

}  // namespace
}  // namespace svoscope
