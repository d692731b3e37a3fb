// SPDX-License-Identifier: MIT
#include "ui/widgets/text.h"

#include <gmock/gmock.h>

#include <cmath>
#include <vector>

#include "tests/ui/render/render_fixture.h"
#include "ui/palette.h"

namespace svoscope::ui {
namespace {

using testing::ElementsAre;

/// Runs `check` where fonts are known.
void inFrame(const std::function<void()>& check) {
  const auto host = openHost(SurfaceKind::null, 640, 480);
  DrawFunction content(check);
  host->frame(content, false);
}

float widthOf(const std::string& text) { return ImGui::CalcTextSize(text.c_str()).x; }

TEST(Text, ElidedEndsInAnEllipsisAndFits) {
  inFrame([] {
    const std::string text = "median disparity 0.5 px < 11.3 px";
    EXPECT_EQ(elided(text, 1e6f), text);
    for (const float width : {40.0f, 80.0f, 150.0f}) {
      const std::string shown = elided(text, width);
      EXPECT_LE(widthOf(shown), width);
      EXPECT_EQ(shown.substr(shown.size() - 3), "…");
      EXPECT_EQ(text.rfind(shown.substr(0, shown.size() - 3), 0), 0u) << shown;
    }
    EXPECT_EQ(elided(text, 0), "…");
  });
}

TEST(Text, ElidedNeverCutsACharacter) {
  inFrame([] {
    const std::string text = "σσσσσσσσσσ";
    for (float width = 0; width < widthOf(text); width += 1) {
      EXPECT_EQ(elided(text, width).size() % 2, 1u) << "letters have two bytes, the ellipsis three";
    }
  });
}

// A number cut at the cell's border looks like another number.
TEST(Text, FittedWrapsNumbersOrShowsThatTheyAreCut) {
  inFrame([] {
    const std::string text = "0.54402 → 0.53117";
    EXPECT_EQ(fitted(text, widthOf("0.54402 → ") + 1), "0.54402 →\n0.53117");
    const std::string narrow = fitted(text, widthOf("0.544"));
    EXPECT_EQ(narrow.find("0.54402"), std::string::npos);
    EXPECT_NE(narrow.find("…"), std::string::npos);
  });
}

TEST(Text, CountsAgreeWithTheirNoun) {
  EXPECT_EQ(counted(1, "message"), "1 message");
  EXPECT_EQ(counted(0, "message"), "0 messages");
  EXPECT_EQ(counted(2, "seed"), "2 seeds");
}

TEST(Text, TheWidestGiveWayFirst) {
  EXPECT_THAT(sharedWidths({50, 80, 20}, 200), ElementsAre(50, 80, 20));
  EXPECT_THAT(sharedWidths({50, 80, 20}, 110), ElementsAre(45, 45, 20));
  EXPECT_THAT(sharedWidths({50, 80, 20}, 30), ElementsAre(10, 10, 10));
  EXPECT_THAT(sharedWidths({50}, -5), ElementsAre(0));
  EXPECT_TRUE(sharedWidths({}, 10).empty());
}

struct Extent {
  float lo, hi;
};

// Horizontal extent of every line of text: a new one begins where letters go back to the left.
std::vector<Extent> extents(const ImDrawList& list) {
  std::vector<Extent> lines;
  for (int i = 0; i + 3 < list.VtxBuffer.Size; i += 4) {  // a letter each
    const float lo = list.VtxBuffer[i].pos.x, hi = list.VtxBuffer[i + 2].pos.x;
    if (lines.empty() || lo < lines.back().hi - 10) lines.push_back({lo, hi});
    lines.back().hi = hi;
  }
  return lines;
}

TEST(Text, EveryLineOfAnEmptyPanelIsCentred) {
  inFrame([] {
    const float font = ImGui::GetFontSize();
    ImGui::SetNextWindowPos({0, 0});
    ImGui::SetNextWindowSize({font * 14, 400});
    ImGui::Begin("##narrow", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoBackground);
    const int before = ImGui::GetWindowDrawList()->VtxBuffer.Size;
    EXPECT_EQ(before, 0);
    emptyState("Only one run is open",
               "Open several on this sequence with --method all, or add a recording");
    const float middle = font * 7;
    const auto lines = extents(*ImGui::GetWindowDrawList());
    EXPECT_GE(lines.size(), 4u);
    for (const Extent& line : lines) EXPECT_NEAR((line.lo + line.hi) / 2, middle, 0.35f * font);
    ImGui::End();
  });
}

double luminance(ImU32 color) {
  const ImVec4 c = toVec4(color);
  const auto linear = [](double v) {
    return v <= 0.03928 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
  };
  return 0.2126 * linear(c.x) + 0.7152 * linear(c.y) + 0.0722 * linear(c.z);
}

TEST(Text, InkOfTextsIsReadableOnEveryGround) {
  for (const ImU32 ground : {ink::window, ink::panel, ink::title, ink::canvas}) {
    for (const ImU32 text : {ink::text, ink::dim}) {
      EXPECT_GE((luminance(text) + 0.05) / (luminance(ground) + 0.05), 4.5);
    }
  }
}

}  // namespace
}  // namespace svoscope::ui
