// SPDX-License-Identifier: MIT
#include "engine/io/stress_writer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

namespace svoscope {
namespace {

using testing::HasSubstr;
using testing::Not;

StressRow row(const std::string& strength, const std::string& method, double tracked, double error,
              StressOutcome outcome) {
  StressRow r;
  r.stress = "speed";
  r.strength = strength;
  r.sequence = "synthetic:room?speed=" + strength;
  r.method = method;
  r.visible = 300;
  r.start_s = 0.2;
  r.tracked_fraction = tracked;
  r.relative_ate = error;
  r.outcome = outcome;
  return r;
}

std::vector<Stress> twoStresses() {
  return {{"speed", "motion so many times as fast", {{"1", ""}, {"2", ""}, {"3", ""}}},
          {"noise", "image noise", {{"3", ""}}}};
}

TEST(StressWriter, CsvHasAFieldForEachColumn) {
  const std::string header = stressCsvHeader();
  StressRow never = row("2", "svo", 0, 0, StressOutcome::broken);
  never.start_s = never.tracked_fraction = never.relative_ate = std::nullopt;
  for (const StressRow& r : {row("1", "svo", 1, 0.001, StressOutcome::held), never}) {
    const std::string text = stressCsvRow(r);
    EXPECT_EQ(std::count(text.begin(), text.end(), ','),
              std::count(header.begin(), header.end(), ','));
  }
  EXPECT_EQ(stressCsvRow(row("1", "svo", 0.995, 0.001, StressOutcome::held)),
            "speed,1,svo,held,300,0.2,0.995,0,0.001,,synthetic:room?speed=1");
  EXPECT_THAT(stressCsvRow(never), HasSubstr("broken,300,,,0,,,"));
}

TEST(StressWriter, TheFirstTableSaysWhatHoldsAndWhatBreaks) {
  std::vector<StressRow> rows = {row("1", "svo", 1, 0.001, StressOutcome::held),
                                 row("1", "it-svo", 1, 0.001, StressOutcome::shaky),
                                 row("2", "svo", 0.95, 0.01, StressOutcome::shaky),
                                 row("2", "it-svo", 1, 0.001, StressOutcome::held),
                                 row("3", "svo", 0.4, 0.3, StressOutcome::broken),
                                 row("3", "it-svo", 1, 0.001, StressOutcome::held)};
  rows[4].losses = 2;
  const std::string text = stressMarkdown(twoStresses(), rows);
  EXPECT_THAT(text, HasSubstr("| stress | svo | it-svo |"));
  EXPECT_THAT(text, HasSubstr("| speed | 1 / 3 | - / - |"));  // shaky at once: held to nothing
  EXPECT_THAT(text, HasSubstr("| 3 | 40 %, 30 %, 2 losses, broken | 100 %, 0.1 % |"));
  EXPECT_THAT(text, Not(HasSubstr("noise"))) << "no rows";
  EXPECT_THAT(stressText(twoStresses(), rows), HasSubstr("1 / 3"));
}

TEST(StressWriter, BlackoutsSayWhenTrackingWasBack) {
  StressRow back = row("1", "svo", 1, 0.001, StressOutcome::held), gone = back;
  back.blackout = gone.blackout = true;
  back.recovery_s = 0.133;
  gone.method = "it-svo";
  const std::string text = stressMarkdown(twoStresses(), {back, gone});
  EXPECT_THAT(text, HasSubstr("back in 0.13 s"));
  EXPECT_THAT(text, HasSubstr("not back"));
}

TEST(StressWriter, NoRowsNoTables) {
  EXPECT_THAT(stressMarkdown(twoStresses(), {}), Not(HasSubstr("speed")));
}

}  // namespace
}  // namespace svoscope
