// SPDX-License-Identifier: MIT
#include "engine/report/comparison.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace svoscope {

namespace {

/// Logarithms of the values if all are positive, else none.
std::vector<double> logs(std::vector<double> values) {
  for (double& v : values) {
    if (!(v > 0)) return {};
    v = std::log(v);
  }
  return values;
}

SequenceComparison compareRuns(std::size_t sequence, const PairedGroup& g) {
  SequenceComparison c;
  c.sequence = sequence;
  const PairedDifference d = bootstrapPaired({g});
  c.ratio = std::exp(d.mean);
  c.ratios = {std::exp(d.interval.low), std::exp(d.interval.high)};
  if (std::min(g.a.size(), g.b.size()) < kLeastRuns) return c;
  const auto [a_low, a_high] = std::minmax_element(g.a.begin(), g.a.end());
  const auto [b_low, b_high] = std::minmax_element(g.b.begin(), g.b.end());
  if (c.ratios.high < 1 && *a_high < *b_low) c.verdict = Verdict::better;
  if (c.ratios.low > 1 && *b_high < *a_low) c.verdict = Verdict::worse;
  return c;
}

std::string names(const BenchResults& results, const std::vector<std::size_t>& sequences) {
  std::string text;
  for (std::size_t i = 0; i < sequences.size(); ++i)
    text += (i == 0                      ? ""
             : i + 1 == sequences.size() ? " and "
                                         : ", ") +
            results.config.sequences[sequences[i]].name;
  return text;
}

std::string percent(double ratio) { return fmt::format("{:.0f} %", 100 * std::abs(ratio - 1)); }

/// "ratio 0.97 over 12 sequences (95 % interval 0.85 to 1.10)"
std::string ratioText(const Comparison& c) {
  return fmt::format("ratio {:.2f} over {} sequence{} (95 % interval {:.2f} to {:.2f})", c.ratio,
                     c.sequences.size(), c.sequences.size() == 1 ? "" : "s", c.ratios.low,
                     c.ratios.high);
}

std::string overall(const BenchResults& results, const Comparison& c) {
  const std::string& a = results.systems[c.a].system.label;
  const std::string& b = results.systems[c.b].system.label;
  const std::string what = c.figure->label;
  if (c.sequences.empty())
    return fmt::format("{}: {} and {} complete no sequence in common in every run.", what, a, b);
  if (static_cast<int>(c.sequences.size()) < kLeastSequences)
    return fmt::format("{}: undecided, {}; a verdict takes {} sequences.", what, ratioText(c),
                       kLeastSequences);
  if (c.verdict == Verdict::undecided) return fmt::format("{}: undecided, {}.", what, ratioText(c));
  return fmt::format("{}: {} is {} than {}, {} {}, {}.", what, a,
                     c.verdict == Verdict::better ? "better" : "worse", b, percent(c.ratio),
                     c.ratio < 1 ? "lower" : "higher", ratioText(c));
}

std::vector<std::size_t> withVerdict(const Comparison& c, Verdict verdict) {
  std::vector<std::size_t> found;
  for (const SequenceComparison& s : c.sequences) {
    if (s.verdict == verdict) found.push_back(s.sequence);
  }
  return found;
}

}  // namespace

Comparison compare(const BenchResults& results, std::size_t a, std::size_t b,
                   const FigureInfo& figure) {
  Comparison c;
  c.a = a;
  c.b = b;
  c.figure = &figure;
  std::vector<PairedGroup> groups;
  for (std::size_t s = 0; s < results.config.sequences.size(); ++s) {
    const bool a_done = results.completes(s, a), b_done = results.completes(s, b);
    if (a_done != b_done) (a_done ? c.only_a : c.only_b).push_back(s);
    if (!a_done && !b_done && !results.config.sequences[s].still) c.neither.push_back(s);
    if (!a_done || !b_done)
      continue;  // the runs that are left would be compared with all of the other
    PairedGroup group{logs(results.values(s, a, figure)), logs(results.values(s, b, figure))};
    if (group.a.empty() || group.b.empty()) continue;
    c.sequences.push_back(compareRuns(s, group));
    groups.push_back(std::move(group));
  }
  if (groups.empty()) return c;
  const PairedDifference d = bootstrapPaired(groups);
  c.ratio = std::exp(d.mean);
  c.ratios = {std::exp(d.interval.low), std::exp(d.interval.high)};
  if (d.groups < kLeastSequences) return c;
  if (c.ratios.high < 1 && c.only_b.empty()) c.verdict = Verdict::better;
  if (c.ratios.low > 1 && c.only_a.empty()) c.verdict = Verdict::worse;
  return c;
}

std::vector<std::pair<std::size_t, std::size_t>> comparedPairs(const BenchResults& results) {
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  const auto own = static_cast<std::size_t>(results.own);
  for (std::size_t a = own; a-- > 0;) {
    for (std::size_t b = a; b-- > 0;) {
      const BenchSystem &sa = results.systems[a].system, &sb = results.systems[b].system;
      const bool same_variant = sa.variant == sb.variant;
      const bool same_method = sa.method == sb.method && sb.variant == 0;
      if (same_variant || same_method) pairs.emplace_back(a, b);
    }
  }
  return pairs;
}

std::vector<std::string> comparisonSentences(const BenchResults& results, const Comparison& c) {
  const std::string& a = results.systems[c.a].system.label;
  const std::string& b = results.systems[c.b].system.label;
  std::vector<std::string> sentences = {overall(results, c)};
  const auto better = withVerdict(c, Verdict::better), worse = withVerdict(c, Verdict::worse),
             undecided = withVerdict(c, Verdict::undecided);
  const auto add = [&](const std::vector<std::size_t>& which, const std::string& text) {
    if (!which.empty()) sentences.push_back(fmt::format("{}: {}.", text, names(results, which)));
  };
  add(better, fmt::format("In every run {} is better than {} on", a, b));
  add(worse, fmt::format("In every run {} is worse than {} on", a, b));
  add(undecided, "The runs do not decide on");
  add(c.only_a, fmt::format("Only {} completes every run", a));
  add(c.only_b, fmt::format("Only {} completes every run", b));
  add(c.neither, "Neither completes every run");
  return sentences;
}

}  // namespace svoscope
