// SPDX-License-Identifier: MIT
// Axes of plots and charts: shared frames, labels that stay apart, nothing made up.
#include "ui/widgets/plot.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/ui/drawn_text.h"
#include "tests/ui/render/render_fixture.h"
#include "ui/theme.h"
#include "ui/widgets/chart.h"

namespace svoscope::ui {
namespace {

class PlotTest : public testing::Test {
 protected:
  /// What is drawn in a window of that height.
  std::vector<DrawnText> drawn(const std::function<void()>& draw, float height = 300) {
    const auto host = openHost(SurfaceKind::null, 640, 480);
    DrawFunction content([&] {
      applyTheme(1);
      ImGui::SetNextWindowPos({0, 0});
      ImGui::SetNextWindowSize({500, height});
      ImGui::Begin("##plots", nullptr, ImGuiWindowFlags_NoDecoration);
      draw();
      ImGui::End();
    });
    host->frame(content, false);
    return drawnTexts([&] { host->frame(content, false); });
  }
  PlotSpec spec(const char* id, const std::vector<float>& y, float height) {
    PlotSpec s;
    s.id = id;
    s.y_label = "y";
    s.size = {0, height};
    if (!y.empty()) s.series.push_back({"a", &frames, &y, 0xFFFFFFFF});
    return s;
  }
  std::vector<float> frames, values, none;
  PlotState states[3];
  LinkedX linked;

  void SetUp() override {
    for (int i = 0; i < 60; ++i) {
      frames.push_back(static_cast<float>(i));
      values.push_back(0.004f * static_cast<float>(i));
    }
    none.assign(60, NAN);
  }
};

TEST_F(PlotTest, APlotWithoutDataKeepsTheSharedFrames) {
  drawn([&] {
    plot(spec("full", values, 80), states[0], linked);
    plot(spec("empty", {}, 80), states[1], linked);
  });
  EXPECT_EQ(linked.range.lo, 0);
  EXPECT_EQ(linked.range.hi, 59);
  linked.known = {0, 99};
  const auto texts = drawn([&] { plot(spec("empty", {}, 80), states[1], linked); });
  EXPECT_EQ(linked.range.hi, 99) << "the frames known, before any plot has data";
  EXPECT_EQ(countOf(texts, "80"), 1);
}

TEST_F(PlotTest, WithoutAValueThereAreNoNumbersOnTheAxis) {
  linked.known = {0, 99};
  const auto texts = drawn([&] {
    PlotSpec s = spec("nan", none, 120);
    s.levels.push_back({40, 0xFFFFFFFF, "lost below"});
    s.show_x_labels = false;
    plot(s, states[0], linked);
  });
  EXPECT_EQ(countOf(texts, "no value"), 1);
  for (const DrawnText& t : texts)
    EXPECT_EQ(t.text.find_first_of("0123456789"), std::string::npos) << t.text;
  EXPECT_EQ(countOf(texts, "lost below"), 0);
}

// Labels of the values stand in the same column: none may touch the next.
void expectApart(std::vector<DrawnText> labels) {
  ASSERT_GE(labels.size(), 2u);
  std::sort(labels.begin(), labels.end(),
            [](const DrawnText& a, const DrawnText& b) { return a.y < b.y; });
  for (std::size_t i = 1; i < labels.size(); ++i) {
    EXPECT_GE(labels[i].y - labels[i - 1].y, labels[i].size)
        << labels[i - 1].text << " and " << labels[i].text;
  }
}

TEST_F(PlotTest, LabelsOfLowPlotsStayApart) {
  for (const float height : {40.0f, 48.0f, 56.0f, 64.0f, 90.0f, 200.0f}) {
    auto texts = drawn([&] {
      PlotSpec s = spec("low", values, height);
      s.zero_based = true;
      s.show_x_labels = false;
      plot(s, states[0], linked);
    });
    texts.erase(std::remove_if(texts.begin(), texts.end(),
                               [](const DrawnText& t) { return t.text == "y" || t.text == "a"; }),
                texts.end());
    expectApart(texts);
  }
}

TEST_F(PlotTest, StackedPlotsFillTheRoom) {
  drawn([&] {
    const float spacing = ImGui::GetStyle().ItemSpacing.y;
    float sum = 0;
    for (int i = 0; i < 4; ++i) sum += stackedHeight(i, 4, 400, 30) + spacing;
    EXPECT_LE(sum, 400);
    EXPECT_GT(sum, 390);
    EXPECT_GT(stackedHeight(3, 4, 400, 30), stackedHeight(0, 4, 400, 30)) << "labels of the frames";
    EXPECT_EQ(stackedHeight(0, 4, 10, 30), 30);
  });
}

TEST_F(PlotTest, LabelsAboveAChartStayApartAndOutside) {
  float top = 0;
  const auto texts = drawn([&] {
    ChartSpec s;
    s.x = {0, 10};
    s.y = {0, 10};
    s.mark_rows = 2;
    s.size = {0, 150};
    Chart chart(s);
    top = chart.lo().y;
    for (const double x : {4.9, 5.0, 9.9}) chart.markX(x, {0xFFFFFFFF}, "mark");
    chart.markY(9, {0xFFFFFFFF}, "accepted below");
  });
  std::vector<DrawnText> marks;
  const DrawnText* level = nullptr;
  for (const DrawnText& t : texts) {
    if (t.text == "mark") marks.push_back(t);
    if (t.text == "accepted below") level = &t;
  }
  ASSERT_EQ(marks.size(), 3u);
  ASSERT_TRUE(level);
  for (const DrawnText& m : marks) EXPECT_LT(m.y, level->y - level->size) << "above the data area";
  EXPECT_NE(marks[0].y, marks[1].y) << "next to each other they take two rows";
  EXPECT_LT(level->x + level->width, marks[2].x)
      << "the level's label makes way for the line at the right end";
  EXPECT_GT(top, 0);
}

}  // namespace
}  // namespace svoscope::ui
