// SPDX-License-Identifier: MIT
#include "ui/render/imgui_renderer.h"

#include <opencv2/core.hpp>

#include "tests/ui/render/render_fixture.h"
#include "ui/render/fonts.h"

namespace svoscope::ui {
namespace {

cv::Vec3b at(const cv::Mat& picture, int x, int y) { return picture.at<cv::Vec3b>(y, x); }

TEST(ImGuiRenderer, DrawsMoreVerticesThan16BitIndicesReach) {
  SVOSCOPE_OSMESA_HOST(host, 320, 240);
  // 20 000 squares of 4 vertices each, all in one list: without VtxOffset the last ones would be
  // drawn at the place of the first ones.
  constexpr int kSquares = 20000, kPerRow = 160;
  DrawFunction content([] {
    ImDrawList& list = *ImGui::GetForegroundDrawList();
    list.AddRectFilled({0, 0}, {320, 240}, IM_COL32(0, 0, 0, 255));
    for (int i = 0; i < kSquares; ++i) {
      const float x = static_cast<float>(2 * (i % kPerRow)), y = static_cast<float>(i / kPerRow);
      const ImU32 color = i / kPerRow < 100 ? IM_COL32(255, 0, 0, 255) : IM_COL32(0, 255, 0, 255);
      list.AddRectFilled({x, y}, {x + 2, y + 1}, color);
    }
  });
  host->frame(content);
  EXPECT_GT(ImGui::GetDrawData()->TotalVtxCount, 65536);
  const cv::Mat picture = host->pixels().value();
  for (int x = 0; x < 320; x += 7) {
    for (int y = 0; y < 240; ++y) {
      const cv::Vec3b expected = y < 100   ? cv::Vec3b(255, 0, 0)
                                 : y < 125 ? cv::Vec3b(0, 255, 0)
                                           : cv::Vec3b(0, 0, 0);
      ASSERT_EQ(at(picture, x, y), expected) << x << ", " << y;
    }
  }
}

TEST(ImGuiRenderer, ReadsBackTopDownAndClipsTheRightRows) {
  SVOSCOPE_OSMESA_HOST(host, 64, 48);
  DrawFunction content([] {
    ImDrawList& list = *ImGui::GetForegroundDrawList();
    list.AddRectFilled({0, 0}, {64, 48}, IM_COL32(10, 20, 30, 255));
    list.PushClipRect({8, 4}, {24, 12});
    list.AddRectFilled({0, 0}, {64, 48}, IM_COL32(200, 100, 50, 255));
    list.PopClipRect();
  });
  host->frame(content);
  const cv::Mat picture = host->pixels().value();
  for (int y = 0; y < 48; ++y) {
    for (int x = 0; x < 64; ++x) {
      const bool inside = x >= 8 && x < 24 && y >= 4 && y < 12;
      ASSERT_EQ(at(picture, x, y), inside ? cv::Vec3b(200, 100, 50) : cv::Vec3b(10, 20, 30));
    }
  }
}

TEST(ImGuiRenderer, BlendsHalfTransparentColours) {
  SVOSCOPE_OSMESA_HOST(host, 16, 16);
  DrawFunction content([] {
    ImDrawList& list = *ImGui::GetForegroundDrawList();
    list.AddRectFilled({0, 0}, {16, 16}, IM_COL32(100, 100, 100, 255));
    list.AddRectFilled({0, 0}, {16, 16}, IM_COL32(200, 0, 100, 128));
  });
  host->frame(content);
  const cv::Vec3b middle = at(host->pixels().value(), 8, 8);
  EXPECT_NEAR(middle[0], 150, 2);
  EXPECT_NEAR(middle[1], 50, 2);
  EXPECT_NEAR(middle[2], 100, 2);
}

TEST(ImGuiRenderer, TheSameFrameTwiceIsTheSamePicture) {
  SVOSCOPE_OSMESA_HOST(host, 400, 300);
  DrawFunction content([] {
    ImGui::SetNextWindowPos({10, 10});
    ImGui::Begin("window");
    ImGui::TextUnformatted("σ μ τ ρ → ± ≤ ≥ × · – …");
    ImGui::Button("Play");
    ImGui::End();
  });
  for (int i = 0; i < 3; ++i) host->frame(content);
  const cv::Mat first = host->pixels().value();
  host->frame(content);
  EXPECT_EQ(cv::norm(first, host->pixels().value(), cv::NORM_INF), 0);
}

TEST(Fonts, HaveTheSymbolsOfThePanelsAtEveryScale) {
  const std::unique_ptr<Host> host = openHost(SurfaceKind::null, 400, 300);
  DrawFunction content([] {});
  for (float scale : {1.0f, 1.5f, 2.0f}) {
    host->setScale(scale);
    host->frame(content);
    if (!host->takeWarnings().empty()) GTEST_SKIP() << "fonts-dejavu-core is not installed";
    EXPECT_EQ(textFont()->FontSize, std::round(15 * scale));
    for (ImWchar symbol : {u'σ', u'μ', u'τ', u'ρ', u'→', u'±', u'≤', u'≥', u'×', u'·', u'–', u'…'}) {
      for (const ImFont* font : {textFont(), monoFont(), titleFont()}) {
        EXPECT_NE(font->FindGlyphNoFallback(symbol), nullptr) << std::hex << symbol;
      }
    }
  }
}

TEST(Fonts, NullSurfaceNeedsNoPixelsAndSaysSo) {
  const std::unique_ptr<Host> host = openHost(SurfaceKind::null, 400, 300);
  DrawFunction content([] { ImGui::Button("Play"); });
  host->frame(content);
  EXPECT_FALSE(host->hasPixels());
  EXPECT_NE(host->pixels().error().message().find("osmesa"), std::string::npos);
}

}  // namespace
}  // namespace svoscope::ui
