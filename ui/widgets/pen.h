// SPDX-License-Identifier: MIT
// ImDrawList's shapes with their arguments in its order. What is drawn with these is part of
// exported SVG files (figure.h); what is drawn on the list directly is on screen only.
#pragma once

#include <imgui/imgui.h>

#include <opencv2/core/mat.hpp>

namespace svoscope::ui::pen {

void line(ImDrawList* list, ImVec2 a, ImVec2 b, ImU32 color, float width = 1);
void polyline(ImDrawList* list, const ImVec2* points, int count, ImU32 color, ImDrawFlags flags,
              float width);
void rect(ImDrawList* list, ImVec2 lo, ImVec2 hi, ImU32 color, float rounding = 0,
          ImDrawFlags flags = 0, float width = 1);
void rectFilled(ImDrawList* list, ImVec2 lo, ImVec2 hi, ImU32 color, float rounding = 0);
void quadFilled(ImDrawList* list, ImVec2 a, ImVec2 b, ImVec2 c, ImVec2 d, ImU32 color);
void triangleFilled(ImDrawList* list, ImVec2 a, ImVec2 b, ImVec2 c, ImU32 color);
void circle(ImDrawList* list, ImVec2 center, float radius, ImU32 color, int segments = 0,
            float width = 1);
void circleFilled(ImDrawList* list, ImVec2 center, float radius, ImU32 color, int segments = 0);
void text(ImDrawList* list, ImVec2 at, ImU32 color, const char* text);
void image(ImDrawList* list, ImTextureID texture, ImVec2 lo, ImVec2 hi, const cv::Mat& pixels);
void pushClipRect(ImDrawList* list, ImVec2 lo, ImVec2 hi, bool intersect);
void popClipRect(ImDrawList* list);

/// Notes the text that ImGui's last item drew at its place.
void itemText(ImU32 color, const char* text);

}  // namespace svoscope::ui::pen
