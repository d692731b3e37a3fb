// SPDX-License-Identifier: MIT
// Every colour that means something, in one place. Categories are Okabe-Ito, the ramp is viridis:
// all are distinguishable with the common colour-vision deficiencies, and no panel uses colour as
// the only cue.
#pragma once

#include <imgui/imgui.h>

#include <string>

#include "engine/base/look.h"
#include "engine/snapshot/snapshot.h"

namespace svoscope::ui {

namespace okabe {
constexpr ImU32 orange = IM_COL32(230, 159, 0, 255);
constexpr ImU32 sky = IM_COL32(86, 180, 233, 255);
constexpr ImU32 green = IM_COL32(0, 158, 115, 255);
constexpr ImU32 yellow = IM_COL32(240, 228, 66, 255);
constexpr ImU32 blue = IM_COL32(0, 114, 178, 255);
constexpr ImU32 vermillion = IM_COL32(213, 94, 0, 255);
constexpr ImU32 purple = IM_COL32(204, 121, 167, 255);
constexpr ImU32 grey = IM_COL32(160, 164, 170, 255);
}  // namespace okabe

namespace ink {
constexpr ImU32 measurement = okabe::green;
constexpr ImU32 prior = okabe::purple;
constexpr ImU32 threshold = okabe::vermillion;
constexpr ImU32 highlight = okabe::yellow;
constexpr ImU32 window = IM_COL32(17, 19, 23, 255);
constexpr ImU32 panel = IM_COL32(24, 27, 32, 255);
constexpr ImU32 title = IM_COL32(32, 36, 43, 255);
constexpr ImU32 canvas = IM_COL32(13, 15, 18, 255);
constexpr ImU32 line = IM_COL32(52, 58, 68, 255);
constexpr ImU32 grid = IM_COL32(38, 43, 51, 255);
constexpr ImU32 text = IM_COL32(222, 226, 231, 255);
constexpr ImU32 dim = IM_COL32(146, 154, 166, 255);
constexpr ImU32 faint = IM_COL32(94, 102, 114, 255);
constexpr ImU32 accent = okabe::sky;
constexpr ImU32 cursor = IM_COL32(245, 247, 250, 255);
constexpr ImU32 selected = IM_COL32(255, 255, 255, 255);
constexpr ImU32 ground_truth = IM_COL32(196, 200, 206, 255);
}  // namespace ink

ImU32 withAlpha(ImU32 color, float alpha);
ImVec4 toVec4(ImU32 color);

ImU32 lookColor(const Look& look);
/// One colour per method, everywhere (engine/base/methods.h).
ImU32 methodColor(const std::string& method);
/// Runs that are not the first of their method, and trajectories of other systems; counted from 0.
ImU32 otherRunColor(int index);
/// The rules of the depth filter, everywhere (engine/base/rules.h).
ImU32 ruleColor(FilterRule rule);
bool ruleDashed(FilterRule rule);  ///< its lines: dashed or dotted
const char* ruleName(FilterRule rule);
ImU32 originColor(FeatureOrigin origin);
/// Outliers and features that did not align have a colour of their own, inliers that of the origin.
ImU32 featureColor(const FeatureView& feature);
ImU32 seedColor(const SeedView& seed);
ImU32 stateColor(TrackingState state);
ImU32 eventColor(EventKind kind);
ImU32 stageColor(Stage stage);

const char* stateLabel(TrackingState state);
/// Why in this state, without the state's name in front; empty if only that is known.
std::string stateReason(const FrameRecord& record);
/// "Lost: 31 inliers < 40 required": state and reason, without saying the state twice.
std::string stateSentence(const FrameRecord& record);
/// "Sparse align": the stage's name for people.
const char* stageLabel(Stage stage);
const char* methodName(const std::string& method);
const char* originName(FeatureOrigin origin);
const char* statusName(FeatureStatus status);
const char* featureTypeName(FeatureType type);
const char* eventName(EventKind kind);

/// Perceptually uniform ramp; t is clamped to [0, 1], NaN gives grey.
ImU32 viridis(float t);

}  // namespace svoscope::ui
