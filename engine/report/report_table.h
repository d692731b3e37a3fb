// SPDX-License-Identifier: MIT
// A table once, written as Markdown, LaTeX and HTML.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace svoscope {

struct ReportCell {
  std::string text;
  bool strong = false;  ///< the best of its row
};

struct ReportRow {
  bool heading = false;  ///< one text over all columns
  std::vector<ReportCell> cells;
};

struct ReportTable {
  std::string id;  ///< of anchors and labels: "accuracy"
  std::string title;
  std::string note;  ///< what a reader must know; may be empty
  std::vector<std::pair<std::string, int>>
      groups;                       ///< upper header: text and columns; may be empty
  std::vector<std::string> header;  ///< one for each column; the first is left-aligned
  std::vector<ReportRow> rows;
  int text_columns = 1;  ///< left-aligned columns from the left
};

std::string tableMarkdown(const ReportTable& table);
std::string tableLatex(const ReportTable& table);
std::string tableHtml(const ReportTable& table);

std::string latexEscaped(const std::string& text);

}  // namespace svoscope
