// SPDX-License-Identifier: MIT
#include "ui/harness/expectation.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace svoscope::ui {
namespace {

std::optional<ScriptValue> value(const std::string& name) {
  if (name == "frame") return ScriptValue(12.0);
  if (name == "playing") return ScriptValue(1.0);
  if (name == "state") return ScriptValue(std::string("tracking"));
  if (name == "labels") return ScriptValue(std::vector<std::string>{"Play", "Run to keyframe"});
  return std::nullopt;
}

std::string failure(const std::vector<std::string>& words) {
  const Status status = checkExpectation(words, value);
  return status ? "" : status.error().message();
}

TEST(Expectation, ComparesNumbersTextsAndLists) {
  EXPECT_EQ(failure({"frame", "==", "12"}), "");
  EXPECT_EQ(failure({"frame", "<=", "12.5"}), "");
  EXPECT_EQ(failure({"playing", "==", "true"}), "");
  EXPECT_EQ(failure({"state", "!=", "lost"}), "");
  EXPECT_EQ(failure({"state", "has", "track"}), "");
  EXPECT_EQ(failure({"labels", "has", "Run", "to", "keyframe"}), "");
  EXPECT_EQ(failure({"labels", "!has", "Stop"}), "");
}

TEST(Expectation, FailuresGiveTheActualValue) {
  EXPECT_THAT(failure({"frame", ">", "12"}), testing::HasSubstr("it is 12"));
  EXPECT_THAT(failure({"state", "==", "lost"}), testing::HasSubstr("it is tracking"));
  EXPECT_THAT(failure({"labels", "has", "Stop"}), testing::HasSubstr("[Play, Run to keyframe]"));
}

TEST(Expectation, NonsenseIsAnErrorNotFalse) {
  EXPECT_THAT(failure({"fraem", "==", "1"}), testing::HasSubstr("nothing is called 'fraem'"));
  EXPECT_THAT(failure({"frame", "~", "1"}), testing::HasSubstr("'~' does not compare"));
  EXPECT_THAT(failure({"frame", "==", "twelve"}), testing::HasSubstr("does not compare"));
}

}  // namespace
}  // namespace svoscope::ui
