// SPDX-License-Identifier: MIT
#include "engine/io/stress_writer.h"

#include <fmt/format.h>

#include <algorithm>

#include "engine/io/csv.h"

namespace svoscope {

namespace {

using Rows = std::vector<StressRow>;

const StressRow* find(const Rows& rows, const std::string& stress, const std::string& strength,
                      const std::string& method) {
  const auto found = std::find_if(rows.begin(), rows.end(), [&](const StressRow& r) {
    return r.stress == stress && r.strength == strength && r.method == method;
  });
  return found == rows.end() ? nullptr : &*found;
}

/// In the order of their first row.
std::vector<std::string> methodsOf(const Rows& rows) {
  std::vector<std::string> methods;
  for (const StressRow& r : rows)
    if (std::find(methods.begin(), methods.end(), r.method) == methods.end())
      methods.push_back(r.method);
  return methods;
}

bool hasRows(const Rows& rows, const Stress& stress) {
  return std::any_of(rows.begin(), rows.end(),
                     [&](const StressRow& r) { return r.stress == stress.name; });
}

/// "x2 / x4": held up to the first, broken from the second.
std::string limits(const Rows& rows, const Stress& stress, const std::string& method) {
  std::string held = "-", broken = "-";
  bool leading = true;
  for (const StressLevel& level : stress.levels) {
    const StressRow* row = find(rows, stress.name, level.strength, method);
    if (!row) continue;
    leading = leading && row->outcome == StressOutcome::held;
    if (leading) held = level.strength;
    if (broken == "-" && row->outcome == StressOutcome::broken) broken = level.strength;
  }
  return held + " / " + broken;
}

std::string percent(const std::optional<double>& fraction) {
  return fraction ? fmt::format("{:.0f} %", 100 * *fraction) : "-";
}

/// Two digits: errors lie between 0.001 and 100 %.
std::string errorPercent(const std::optional<double>& error) {
  if (!error) return "-";
  const double percent = 100 * *error;
  return percent < 10 ? fmt::format("{:.2g} %", percent) : fmt::format("{:.0f} %", percent);
}

std::string cell(const StressRow& row) {
  if (!row.start_s) return "no start, broken";
  std::string text = percent(row.tracked_fraction) + ", " + errorPercent(row.relative_ate);
  if (row.losses > 0)
    text += fmt::format(", {} {}", row.losses, row.losses == 1 ? "loss" : "losses");
  if (row.blackout)
    text += row.recovery_s ? fmt::format(", back in {:.2f} s", *row.recovery_s) : ", not back";
  if (row.outcome != StressOutcome::held)
    text += fmt::format(", {}", stressOutcomeName(row.outcome));
  return text;
}

std::string headerRow(const std::string& first, const std::vector<std::string>& methods) {
  std::string names = "| " + first + " |", rule = "| --- |";
  for (const std::string& method : methods) {
    names += " " + method + " |";
    rule += " --- |";
  }
  return names + "\n" + rule + "\n";
}

std::string detailTable(const Rows& rows, const Stress& stress,
                        const std::vector<std::string>& methods) {
  std::string text = fmt::format("\n## {}\n\n{}\n\n", stress.name, stress.meaning);
  text += headerRow("strength", methods);
  for (const StressLevel& level : stress.levels) {
    text += "| " + level.strength + " |";
    for (const std::string& method : methods) {
      const StressRow* row = find(rows, stress.name, level.strength, method);
      text += " " + (row ? cell(*row) : "") + " |";
    }
    text += "\n";
  }
  return text;
}

}  // namespace

const char* stressCsvHeader() {
  return "stress,strength,method,outcome,visible,start_s,tracked_fraction,losses,relative_ate,"
         "recovery_s,sequence";
}

std::string stressCsvRow(const StressRow& r) {
  return fmt::format("{},{},{},{},{},{},{},{},{},{},{}", r.stress, r.strength, r.method,
                     stressOutcomeName(r.outcome), r.visible, csvNumber(r.start_s),
                     csvNumber(r.tracked_fraction), r.losses, csvNumber(r.relative_ate),
                     csvNumber(r.recovery_s), r.sequence);
}

std::string stressMarkdown(const std::vector<Stress>& stresses, const Rows& rows) {
  const std::vector<std::string> methods = methodsOf(rows);
  std::string text = "# Where each method breaks\n\nHeld to / broken from\n\n";
  text += headerRow("stress", methods);
  for (const Stress& stress : stresses) {
    if (!hasRows(rows, stress)) continue;
    text += "| " + stress.name + " |";
    for (const std::string& method : methods) text += " " + limits(rows, stress, method) + " |";
    text += "\n";
  }
  for (const Stress& stress : stresses)
    if (hasRows(rows, stress)) text += detailTable(rows, stress, methods);
  return text;
}

std::string stressText(const std::vector<Stress>& stresses, const Rows& rows) {
  const std::vector<std::string> methods = methodsOf(rows);
  std::string text = fmt::format("{:<13}", "held / broken");
  for (const std::string& method : methods) text += fmt::format(" {:>16}", method);
  text += "\n";
  for (const Stress& stress : stresses) {
    if (!hasRows(rows, stress)) continue;
    text += fmt::format("{:<13}", stress.name);
    for (const std::string& method : methods)
      text += fmt::format(" {:>16}", limits(rows, stress, method));
    text += "\n";
  }
  return text;
}

}  // namespace svoscope
