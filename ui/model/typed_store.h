// SPDX-License-Identifier: MIT
// Values by their type, made when first asked for: a panel keeps its own options and caches here,
// so that the shared structs need not name them.
#pragma once

#include <map>
#include <memory>
#include <typeindex>

namespace svoscope::ui {

class TypedStore {
 public:
  /// The one T; default-constructed at the first call. The reference stays valid as long as the
  /// store, or the one it was moved to, lives.
  template <typename T>
  T& get() {
    std::shared_ptr<void>& value = values_[std::type_index(typeid(T))];
    if (!value) value = std::make_shared<T>();
    return *static_cast<T*>(value.get());
  }
  /// The same for readers: a default T if nobody has asked for one yet.
  template <typename T>
  const T& get() const {
    static const T none{};
    const auto found = values_.find(std::type_index(typeid(T)));
    return found == values_.end() ? none : *static_cast<const T*>(found->second.get());
  }

  TypedStore() = default;
  TypedStore(TypedStore&&) = default;
  TypedStore& operator=(TypedStore&&) = default;

 private:
  std::map<std::type_index, std::shared_ptr<void>> values_;  // shared_ptr: it knows the destructor
};

}  // namespace svoscope::ui
