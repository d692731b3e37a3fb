// SPDX-License-Identifier: MIT
// How many members an aggregate has, so that a test notices one that a list lacks.
#pragma once

#include <cstddef>
#include <utility>

namespace svoscope::test {

struct AnyField {
  template <typename T>
  constexpr operator T() const noexcept;
};

template <typename T, std::size_t... I, typename = decltype(T{(void(I), AnyField())...})>
constexpr bool takesFields(std::index_sequence<I...>, int) {
  return true;
}
template <typename T, std::size_t... I>
constexpr bool takesFields(std::index_sequence<I...>, long) {
  return false;
}

/// Direct members of the aggregate T, of which there are at most N; an inner aggregate or array is
/// one.
template <typename T, std::size_t N = 64>
constexpr std::size_t fieldCount() {
  if constexpr (N == 0 || takesFields<T>(std::make_index_sequence<N>(), 0))
    return N;
  else
    return fieldCount<T, N - 1>();
}

}  // namespace svoscope::test
