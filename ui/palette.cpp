// SPDX-License-Identifier: MIT
#include "ui/palette.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/base/methods.h"

namespace svoscope::ui {

namespace {

struct Rgb {
  float r, g, b;
};

// Control points of the published colour map, equally spaced; linear in between.
constexpr std::array<Rgb, 9> kViridis = {{{68, 1, 84},
                                          {71, 44, 122},
                                          {59, 81, 139},
                                          {44, 113, 142},
                                          {33, 144, 141},
                                          {39, 173, 129},
                                          {92, 200, 99},
                                          {170, 220, 50},
                                          {253, 231, 37}}};

template <std::size_t N>
ImU32 ramp(const std::array<Rgb, N>& table, float t) {
  if (std::isnan(t)) return okabe::grey;
  const float s = std::clamp(t, 0.0f, 1.0f) * (N - 1);
  const auto i = std::min(static_cast<std::size_t>(s), N - 2);
  const float f = s - static_cast<float>(i);
  const auto mix = [f](float a, float b) { return static_cast<int>(a + f * (b - a) + 0.5f); };
  const Rgb &a = table[i], &b = table[i + 1];
  return IM_COL32(mix(a.r, b.r), mix(a.g, b.g), mix(a.b, b.b), 255);
}

}  // namespace

ImU32 withAlpha(ImU32 color, float alpha) {
  const auto a = static_cast<ImU32>(std::clamp(alpha, 0.0f, 1.0f) * 255.0f + 0.5f);
  return (color & ~IM_COL32_A_MASK) | (a << IM_COL32_A_SHIFT);
}

ImVec4 toVec4(ImU32 color) { return ImGui::ColorConvertU32ToFloat4(color); }

ImU32 lookColor(const Look& look) {
  return IM_COL32(look.rgb >> 16, (look.rgb >> 8) & 255u, look.rgb & 255u, 255);
}

ImU32 methodColor(const std::string& method) { return lookColor(methodLook(method)); }

ImU32 otherRunColor(int index) {
  constexpr std::array<ImU32, 4> colors = {okabe::green, okabe::yellow, okabe::vermillion,
                                           okabe::grey};
  return colors[static_cast<std::size_t>(index) % colors.size()];
}

const char* methodName(const std::string& method) {
  const MethodInfo* known = findMethod(method);
  return known ? known->label : method.c_str();
}

ImU32 ruleColor(FilterRule rule) { return lookColor(ruleInfo(rule).look); }
bool ruleDashed(FilterRule rule) { return ruleInfo(rule).look.dash != Dash::solid; }
const char* ruleName(FilterRule rule) { return ruleInfo(rule).label; }

ImU32 originColor(FeatureOrigin origin) {
  switch (origin) {
    case FeatureOrigin::landmark:
      return okabe::green;
    case FeatureOrigin::converged_seed:
      return okabe::sky;
    case FeatureOrigin::unconverged_seed:
      return okabe::orange;
    case FeatureOrigin::track:
      return okabe::yellow;
  }
  return okabe::grey;
}

ImU32 featureColor(const FeatureView& feature) {
  if (feature.status == FeatureStatus::outlier) return okabe::vermillion;
  if (feature.status == FeatureStatus::not_aligned) return okabe::grey;
  if (feature.status == FeatureStatus::followed) return okabe::purple;
  return originColor(feature.origin);
}

ImU32 seedColor(const SeedView& seed) {
  switch (seed.status) {
    case SeedStatus::active:
      return okabe::orange;
    case SeedStatus::converged:
      return okabe::sky;
    case SeedStatus::promoted:
      return okabe::green;
    case SeedStatus::rejected:
      return okabe::vermillion;
  }
  return okabe::grey;
}

ImU32 stateColor(TrackingState state) {
  switch (state) {
    case TrackingState::initializing:
      return okabe::yellow;
    case TrackingState::tracking:
      return okabe::green;
    case TrackingState::lost:
      return okabe::vermillion;
  }
  return okabe::grey;
}

ImU32 eventColor(EventKind kind) {
  switch (kind) {
    case EventKind::initialized:
      return okabe::yellow;
    case EventKind::keyframe:
      return okabe::sky;
    case EventKind::lost:
      return okabe::vermillion;
    case EventKind::error:
      return okabe::vermillion;
    case EventKind::relocalized:
      return okabe::green;
    case EventKind::warning:
      return okabe::orange;
    default:
      return okabe::grey;
  }
}

ImU32 stageColor(Stage stage) {
  switch (stage) {
    case Stage::pyramid:
      return okabe::grey;
    case Stage::initialize:
      return okabe::yellow;
    case Stage::sparse_align:
      return okabe::sky;
    case Stage::reproject:
      return okabe::green;
    case Stage::pose:
      return okabe::orange;
    case Stage::structure:
      return okabe::purple;
    case Stage::keyframe:
      return okabe::blue;
    case Stage::relocalize:
      return okabe::vermillion;
    case Stage::mapping:
      return IM_COL32(150, 134, 190, 255);
    case Stage::snapshot:
      return IM_COL32(112, 118, 128, 255);
    default:
      return IM_COL32(90, 96, 106, 255);
  }
}

const char* stateLabel(TrackingState state) {
  switch (state) {
    case TrackingState::initializing:
      return "Initializing";
    case TrackingState::tracking:
      return "Tracking";
    case TrackingState::lost:
      return "Lost";
  }
  return "";
}

std::string stateReason(const FrameRecord& record) {
  const std::string state = stateName(record.state), &reason = record.reason;
  if (reason.rfind(state, 0) != 0) return reason;
  const std::size_t from = reason.find_first_not_of(", :", state.size());
  return from == std::string::npos ? "" : reason.substr(from);
}

std::string stateSentence(const FrameRecord& record) {
  const std::string reason = stateReason(record);
  return stateLabel(record.state) + (reason.empty() ? "" : ": " + reason);
}

const char* stageLabel(Stage stage) {
  switch (stage) {
    case Stage::read:
      return "Read";
    case Stage::rectify:
      return "Rectify";
    case Stage::pyramid:
      return "Pyramid";
    case Stage::initialize:
      return "Two-view start";
    case Stage::sparse_align:
      return "Sparse align";
    case Stage::reproject:
      return "Reproject";
    case Stage::pose:
      return "Pose";
    case Stage::structure:
      return "Structure";
    case Stage::keyframe:
      return "Keyframe";
    case Stage::relocalize:
      return "Relocalize";
    case Stage::tracking:
      return "Tracking";
    case Stage::mapping:
      return "Mapping";
    case Stage::snapshot:
      return "Snapshot";
    case Stage::count_:
      break;
  }
  return "";
}

const char* originName(FeatureOrigin origin) {
  switch (origin) {
    case FeatureOrigin::landmark:
      return "Landmark";
    case FeatureOrigin::converged_seed:
      return "Converged seed";
    case FeatureOrigin::unconverged_seed:
      return "Unconverged seed";
    case FeatureOrigin::track:
      return "Start track";
  }
  return "";
}

const char* statusName(FeatureStatus status) {
  switch (status) {
    case FeatureStatus::inlier:
      return "Inlier";
    case FeatureStatus::outlier:
      return "Outlier";
    case FeatureStatus::not_aligned:
      return "Not aligned";
    case FeatureStatus::followed:
      return "Followed, not in the pose";
  }
  return "";
}

const char* featureTypeName(FeatureType type) {
  switch (type) {
    case FeatureType::corner:
      return "Corner";
    case FeatureType::edgelet:
      return "Edgelet";
    case FeatureType::segment:
      return "Segment";
  }
  return "";
}

const char* eventName(EventKind kind) {
  switch (kind) {
    case EventKind::info:
      return "Info";
    case EventKind::initialized:
      return "Initialized";
    case EventKind::keyframe:
      return "Keyframe";
    case EventKind::lost:
      return "Lost";
    case EventKind::relocalized:
      return "Relocalized";
    case EventKind::warning:
      return "Warning";
    case EventKind::reset:
      return "Reset";
    case EventKind::finished:
      return "Finished";
    case EventKind::error:
      return "Error";
  }
  return "";
}

ImU32 viridis(float t) { return ramp(kViridis, t); }

}  // namespace svoscope::ui
