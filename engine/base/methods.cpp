// SPDX-License-Identifier: MIT
#include "engine/base/methods.h"

namespace svoscope {

const MethodInfo* findMethod(std::string_view id) {
  for (const MethodInfo& method : kMethods) {
    if (id == method.id) return &method;
  }
  return nullptr;
}

Look methodLook(std::string_view id) {
  const MethodInfo* method = findMethod(id);
  return (method ? method : findMethod(kDefaultMethod))->look;
}

std::vector<std::string> methodIds() {
  std::vector<std::string> ids;
  for (const MethodInfo& method : kMethods) ids.emplace_back(method.id);
  return ids;
}

std::string methodList() {
  std::string list;
  for (std::size_t i = 0; i < kMethods.size(); ++i) {
    if (i > 0) list += i + 1 < kMethods.size() ? ", " : " or ";
    list += kMethods[i].id;
  }
  return list;
}

}  // namespace svoscope
