// SPDX-License-Identifier: MIT
// Paired comparison of two systems over the sequences both complete in every run.
#pragma once

#include <string>
#include <vector>

#include "engine/eval/bootstrap.h"
#include "engine/report/bench_results.h"

namespace svoscope {

enum class Verdict { better, worse, undecided };

/// A against B on one sequence.
struct SequenceComparison {
  std::size_t sequence = 0;
  double ratio = 1;  ///< geometric mean of A's runs / that of B's
  Interval ratios;   ///< 95 % bootstrap interval over the runs; [ratio, ratio] for single runs
  /// Better or worse only if the interval leaves out 1, every run of the one lies below every run
  /// of the other, and there are at least kLeastRuns of each: three lie apart by chance in one case
  /// of ten.
  Verdict verdict = Verdict::undecided;
};

struct Comparison {
  std::size_t a = 0, b = 0;  ///< indices of systems
  const FigureInfo* figure = nullptr;
  std::vector<SequenceComparison> sequences;  ///< both have a value > 0
  double ratio = 1;                           ///< geometric mean of the sequences' ratios
  Interval ratios;                            ///< 95 % hierarchical bootstrap interval, fixed seed
  /// From the interval, if there are at least kLeastSequences; never for a system that fails where
  /// the other does not.
  Verdict verdict = Verdict::undecided;
  std::vector<std::size_t> only_a, only_b, neither;  ///< sequences that not both complete
};

/// With fewer, all differences may have one sign by chance in more than one case of 20 (sign test).
constexpr int kLeastSequences = 6;
constexpr std::size_t kLeastRuns = 4;

/// Ratios of `figure`, a value that is positive and better if less.
Comparison compare(const BenchResults& results, std::size_t a, std::size_t b,
                   const FigureInfo& figure);

/// Pairs of our systems: each method against those before it, variants against the first.
std::vector<std::pair<std::size_t, std::size_t>> comparedPairs(const BenchResults& results);

/// Plain sentences: what is better, by how much, with which interval, and on which sequences.
std::vector<std::string> comparisonSentences(const BenchResults& results,
                                             const Comparison& comparison);

}  // namespace svoscope
