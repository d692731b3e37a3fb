// SPDX-License-Identifier: MIT
// Names of the enumerations in a recording, by code; the table `codes` of a recording holds them.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "engine/snapshot/snapshot.h"

namespace svoscope {

/// Names of T in the order of its values.
template <typename T>
const std::vector<const char*>& namesOf();

template <>
const std::vector<const char*>& namesOf<TrackingState>();
template <>
const std::vector<const char*>& namesOf<EventKind>();
template <>
const std::vector<const char*>& namesOf<FeatureType>();
template <>
const std::vector<const char*>& namesOf<FeatureOrigin>();
template <>
const std::vector<const char*>& namesOf<FeatureStatus>();
template <>
const std::vector<const char*>& namesOf<SeedStatus>();
template <>
const std::vector<const char*>& namesOf<SearchOutcome>();
template <>
const std::vector<const char*>& namesOf<SeedEnding>();

template <typename T>
const char* nameOf(T value) {
  const auto& names = namesOf<T>();
  const auto at = static_cast<std::size_t>(value);
  return at < names.size() ? names[at] : "unknown";
}

/// The first value for a name that is not known: a file may hold anything.
template <typename T>
T valueOf(const std::string& name) {
  const auto& names = namesOf<T>();
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (name == names[i]) return static_cast<T>(i);
  }
  return T{};
}

template <typename T>
T valueOfCode(std::int64_t code) {
  return code >= 0 && code < static_cast<std::int64_t>(namesOf<T>().size()) ? static_cast<T>(code)
                                                                            : T{};
}

}  // namespace svoscope
