// SPDX-License-Identifier: MIT
#include "engine/report/bench_results.h"

#include <algorithm>
#include <cmath>

#include "engine/eval/bootstrap.h"

namespace svoscope {

std::optional<Spread> spreadOf(const std::vector<double>& values) {
  if (values.empty()) return std::nullopt;
  Spread s;
  s.count = static_cast<int>(values.size());
  s.mean = meanOf(values);
  s.low = *std::min_element(values.begin(), values.end());
  s.high = *std::max_element(values.begin(), values.end());
  double squares = 0;
  for (const double v : values) squares += (v - s.mean) * (v - s.mean);
  if (s.count > 1) s.stddev = std::sqrt(squares / (s.count - 1));
  return s;
}

std::vector<double> BenchResults::values(std::size_t sequence, std::size_t system,
                                         const FigureInfo& info) const {
  std::vector<double> values;
  for (const RunResult& run : runs[sequence][system]) {
    const auto& value = run.figures.*info.value;
    if (run.good && value) values.push_back(*value);
  }
  return values;
}

std::optional<Spread> BenchResults::spread(std::size_t sequence, std::size_t system,
                                           const FigureInfo& info) const {
  return spreadOf(values(sequence, system, info));
}

const RunResult* BenchResults::typical(std::size_t sequence, std::size_t system) const {
  std::vector<const RunResult*> good;
  for (const RunResult& run : runs[sequence][system]) {
    if (run.good) good.push_back(&run);
  }
  if (good.empty()) return nullptr;
  std::stable_sort(good.begin(), good.end(), [](const RunResult* a, const RunResult* b) {
    return a->figures.ate_m.value_or(0) < b->figures.ate_m.value_or(0);
  });
  return good[(good.size() - 1) / 2];
}

bool BenchResults::completes(std::size_t sequence, std::size_t system) const {
  int present = 0, good = 0;
  for (const RunResult& run : runs[sequence][system]) {
    present += run.present;
    good += run.good;
  }
  return present > 0 && good == present;
}

std::string BenchResults::failure(std::size_t sequence, std::size_t system) const {
  std::vector<std::string> reasons;
  for (const RunResult& run : runs[sequence][system]) {
    if (run.good) return "";
    if (std::find(reasons.begin(), reasons.end(), run.why) == reasons.end())
      reasons.push_back(run.why);
  }
  std::string text;
  for (const std::string& reason : reasons) text += (text.empty() ? "" : "; ") + reason;
  return text;
}

}  // namespace svoscope
