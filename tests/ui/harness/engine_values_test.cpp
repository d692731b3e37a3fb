// SPDX-License-Identifier: MIT
#include "ui/harness/engine_values.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/snapshot/frame_fields.h"
#include "tests/support/fake_runner.h"

namespace svoscope::ui {
namespace {

TEST(EngineValues, EveryFieldOfAFrameButItsPoseCanBeAskedFor) {
  FakeRunner runner;
  runner.runTo(12);
  const FrameRecord record = runner.records(0).back();
  visitFrameFields(record, [&](const FrameField& field, const auto& value) {
    using T = std::decay_t<decltype(value)>;
    if constexpr (!std::is_same_v<T, SE3>) {
      const auto known = engineValue(runner, record.index, field.name);
      ASSERT_TRUE(known) << field.name;
      if constexpr (std::is_arithmetic_v<T>)
        EXPECT_EQ(std::get<double>(*known), static_cast<double>(value)) << field.name;
      else
        EXPECT_FALSE(std::get<std::string>(*known).empty() && field.name == std::string("state"));
      EXPECT_THAT(engineValueNames(), testing::HasSubstr(field.name));
    }
  });
  EXPECT_EQ(std::get<double>(*engineValue(runner, record.index, "frame")), record.index);
  EXPECT_FALSE(engineValue(runner, record.index, ""));
  EXPECT_FALSE(engineValue(runner, record.index, "nonsense"));
}

}  // namespace
}  // namespace svoscope::ui
