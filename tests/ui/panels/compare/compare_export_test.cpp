// SPDX-License-Identifier: MIT
// What the panels write into files, with several runs open.
#include <gmock/gmock.h>

#include "tests/ui/panels/compare/compare_fixture.h"

namespace svoscope::ui {
namespace {

using testing::HasSubstr;
using testing::Not;

class CompareExport : public Compare {};

TEST_P(CompareExport, PanelsExportNumbersAndCharts) {
  open();
  ASSERT_EQ(run("run-to 70\nlayout Compare\nwait 3\n"
                "export Compare plots plots.csv\nexport Compare plots plots.svg\n"
                "export Compare metrics metrics.csv\nexport Compare 3-D paths.csv\n"),
            "");
  EXPECT_THAT(written("plots.csv"),
              HasSubstr("frame,svo error_m,svo difference_m,svo inliers,svo tracking_ms,pl-svo"));
  EXPECT_THAT(written("plots.csv"), HasSubstr("\n70,"));
  EXPECT_THAT(written("plots.svg"), HasSubstr("Position error, m</text>"));
  EXPECT_THAT(written("plots.svg"), HasSubstr("PL-SVO</text>"));
  EXPECT_THAT(written("plots.svg"), Not(HasSubstr("nan")));
  EXPECT_THAT(written("metrics.csv"), HasSubstr("Start frame,12,5,,20\n"));
  EXPECT_THAT(written("paths.csv"), HasSubstr("\n30,pl-svo,"));
}

TEST_P(CompareExport, EveryPanelWithChartsExports) {
  open();
  ASSERT_EQ(run("run-to 50\nset lab.wait on\nset lab.seeds 200\nset lab.section 2\nselect seed "
                "any\nwait 3\n"),
            "");
  for (const std::string panel :
       {"Plots", "Timing", "Seed", "KL / JS", "Evaluation", "Filter lab", "Compare plots"}) {
    EXPECT_EQ(run("panel \"" + panel + "\"\nwait 2\nexport \"" + panel + "\" a.csv\nexport \"" +
                  panel + "\" a.svg\n"),
              "")
        << panel;
    EXPECT_THAT(written("a.csv"), HasSubstr(",")) << panel;
    EXPECT_THAT(written("a.svg"), HasSubstr("<polyline")) << panel;
  }
}

TEST_P(CompareExport, ImageMapAndFunnelExportTheirNumbers) {
  open();
  ASSERT_EQ(run("run-to 30\nexport Image i.csv\nexport 3-D p.csv\nexport Funnel f.csv\n"), "");
  EXPECT_THAT(written("i.csv"), HasSubstr(",Corner,Landmark,Inlier,"));
  EXPECT_THAT(written("p.csv"), HasSubstr(",Segment,"));
  EXPECT_THAT(written("f.csv"), HasSubstr("\n30,"));
}

TEST_P(CompareExport, WhatCannotBeExportedIsSaid) {
  open();
  ASSERT_EQ(run("run-to 30\nlayout Compare\n"), "");
  EXPECT_THAT(run("export Log log.csv\n"), HasSubstr("has no numbers"));
  EXPECT_THAT(run("export Image image.svg\n"), HasSubstr("has no charts"));
  EXPECT_THAT(run("export Timing timing.svg\n"), HasSubstr("not on screen"));
  EXPECT_THAT(run("export Plot plot.csv\n"), HasSubstr("no panel is called"));
  EXPECT_THAT(run("export Plots plots.pdf\n"), HasSubstr(".csv, .svg or .png"));
}

INSTANTIATE_TEST_SUITE_P(Surfaces, CompareExport,
                         testing::Values(SurfaceKind::null, SurfaceKind::osmesa),
                         [](const auto& test) {
                           return test.param == SurfaceKind::null ? "null" : "osmesa";
                         });

}  // namespace
}  // namespace svoscope::ui
