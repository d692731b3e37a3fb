// SPDX-License-Identifier: MIT
#include "ui/widgets/probe.h"

#include <unordered_map>

namespace svoscope::ui {
namespace {

struct Entries {
  std::vector<std::pair<std::string, ProbeRect>> drawn;
  std::unordered_map<std::string, std::size_t> place;
  std::unordered_map<std::string, int> repeats;  // keeps naming duplicates linear in their number
};

// ImGui's current context is global too; a probe per context would only add a lookup.
Entries& entries() {
  static Entries instance;
  return instance;
}

std::string visiblePart(const std::string& label) {
  const std::size_t hash = label.find("##");
  return hash == std::string::npos || hash == 0 ? label : label.substr(0, hash);
}

}  // namespace

void Probe::record(const char* label) {
  record(visiblePart(label), ImGui::GetItemRectMin(), ImGui::GetItemRectMax());
}

void Probe::record(const std::string& label, ImVec2 min, ImVec2 max) {
  Entries& e = entries();
  const int count = ++e.repeats[label];
  const std::string name = count == 1 ? label : label + "#" + std::to_string(count);
  e.place[name] = e.drawn.size();
  e.drawn.push_back({name, {min, max}});
}

std::optional<ProbeRect> Probe::find(const std::string& label) {
  const Entries& e = entries();
  const auto found = e.place.find(label);
  if (found == e.place.end()) return std::nullopt;
  return e.drawn[found->second].second;
}

void Probe::clear() { entries() = Entries(); }

std::vector<std::string> Probe::labels() {
  std::vector<std::string> names;
  names.reserve(entries().drawn.size());
  for (const auto& [name, rect] : entries().drawn) names.push_back(name);
  return names;
}

}  // namespace svoscope::ui
