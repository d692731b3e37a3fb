// SPDX-License-Identifier: MIT
#include "ui/widgets/pen.h"

#include "ui/widgets/figure.h"

namespace svoscope::ui::pen {

void line(ImDrawList* list, ImVec2 a, ImVec2 b, ImU32 color, float width) {
  list->AddLine(a, b, color, width);
  const ImVec2 ends[2] = {a, b};
  if (Figure* figure = Figure::active()) figure->polyline(ends, 2, color, width, false);
}

void polyline(ImDrawList* list, const ImVec2* points, int count, ImU32 color, ImDrawFlags flags,
              float width) {
  list->AddPolyline(points, count, color, flags, width);
  if (Figure* figure = Figure::active())
    figure->polyline(points, count, color, width, flags & ImDrawFlags_Closed);
}

void rect(ImDrawList* list, ImVec2 lo, ImVec2 hi, ImU32 color, float rounding, ImDrawFlags flags,
          float width) {
  list->AddRect(lo, hi, color, rounding, flags, width);
  const ImVec2 corners[4] = {lo, {hi.x, lo.y}, hi, {lo.x, hi.y}};
  if (Figure* figure = Figure::active()) figure->polyline(corners, 4, color, width, true);
}

void rectFilled(ImDrawList* list, ImVec2 lo, ImVec2 hi, ImU32 color, float rounding) {
  list->AddRectFilled(lo, hi, color, rounding);
  const ImVec2 corners[4] = {lo, {hi.x, lo.y}, hi, {lo.x, hi.y}};
  if (Figure* figure = Figure::active()) figure->polygon(corners, 4, color);
}

void quadFilled(ImDrawList* list, ImVec2 a, ImVec2 b, ImVec2 c, ImVec2 d, ImU32 color) {
  list->AddQuadFilled(a, b, c, d, color);
  const ImVec2 corners[4] = {a, b, c, d};
  if (Figure* figure = Figure::active()) figure->polygon(corners, 4, color);
}

void triangleFilled(ImDrawList* list, ImVec2 a, ImVec2 b, ImVec2 c, ImU32 color) {
  list->AddTriangleFilled(a, b, c, color);
  const ImVec2 corners[3] = {a, b, c};
  if (Figure* figure = Figure::active()) figure->polygon(corners, 3, color);
}

void circle(ImDrawList* list, ImVec2 center, float radius, ImU32 color, int segments, float width) {
  list->AddCircle(center, radius, color, segments, width);
  if (Figure* figure = Figure::active()) figure->circle(center, radius, color, width);
}

void circleFilled(ImDrawList* list, ImVec2 center, float radius, ImU32 color, int segments) {
  list->AddCircleFilled(center, radius, color, segments);
  if (Figure* figure = Figure::active()) figure->circle(center, radius, color, 0);
}

void text(ImDrawList* list, ImVec2 at, ImU32 color, const char* text) {
  list->AddText(at, color, text);
  if (Figure* figure = Figure::active()) figure->text(at, color, text);
}

void image(ImDrawList* list, ImTextureID texture, ImVec2 lo, ImVec2 hi, const cv::Mat& pixels) {
  list->AddImage(texture, lo, hi);
  if (Figure* figure = Figure::active()) figure->image(lo, hi, pixels);
}

void pushClipRect(ImDrawList* list, ImVec2 lo, ImVec2 hi, bool intersect) {
  list->PushClipRect(lo, hi, intersect);
  if (Figure* figure = Figure::active()) figure->pushClip(lo, hi);
}

void popClipRect(ImDrawList* list) {
  list->PopClipRect();
  if (Figure* figure = Figure::active()) figure->popClip();
}

void itemText(ImU32 color, const char* text) {
  if (Figure* figure = Figure::active()) figure->text(ImGui::GetItemRectMin(), color, text);
}

}  // namespace svoscope::ui::pen
