// SPDX-License-Identifier: MIT
#include "engine/runner/make_runner.h"

#include <gtest/gtest.h>

#include "engine/base/methods.h"

namespace svoscope {
namespace {

TEST(ApplyMethod, SetsRuleAndSegmentsOfEveryRow) {
  for (const MethodInfo& method : kMethods) {
    Parameters parameters;
    ASSERT_TRUE(applyMethod(parameters, method.id).ok()) << method.id;
    EXPECT_EQ(parameters.tracker.mapping.filter.rule, method.rule) << method.id;
    EXPECT_EQ(parameters.tracker.mapping.segments.enabled, method.segments) << method.id;
  }
}

TEST(ApplyMethod, SaysWhichMethodsThereAre) {
  Parameters parameters;
  const Status status = applyMethod(parameters, "orb");
  ASSERT_FALSE(status.ok());
  EXPECT_EQ(status.error().what, "method 'orb' is not available");
  EXPECT_EQ(status.error().where, "--method");
  EXPECT_EQ(status.error().remedy, "use " + methodList());
  EXPECT_EQ(methodList().rfind("svo, pl-svo", 0), 0u) << methodList();
  EXPECT_FALSE(applyMethod(parameters, "").ok());
  EXPECT_FALSE(applyMethod(parameters, "SVO").ok());
}

}  // namespace
}  // namespace svoscope
