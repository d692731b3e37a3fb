// SPDX-License-Identifier: MIT
#include "engine/report/report_table.h"

#include <fmt/format.h>

#include "engine/figure/svg.h"

namespace svoscope {

namespace {

std::string markdownEscaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '|' || c == '*' || c == '_' || c == '<') result += '\\';
    result += c == '\n' ? ' ' : c;
  }
  return result;
}

/// Header texts with their group in front, for formats with one header line.
std::vector<std::string> flatHeader(const ReportTable& table) {
  std::vector<std::string> names = table.header;
  std::size_t column = 0;
  for (const auto& [group, span] : table.groups) {
    for (int i = 0; i < span && column < names.size(); ++i, ++column) {
      if (!group.empty())
        names[column] = names[column].empty() ? group : group + " " + names[column];
    }
  }
  return names;
}

/// Mean above its spread, error above the fraction tracked: side by side they make a table too wide
/// for a page.
std::string htmlCell(const std::string& text) {
  for (const std::string& mark : {std::string(" \xC2\xB1 "), std::string(" @ ")}) {
    const std::size_t at = text.find(mark);
    if (at == std::string::npos) continue;
    const std::size_t rest = mark == " @ " ? at + mark.size() : at + 1;
    return xmlEscaped(text.substr(0, at)) + "<small>" + xmlEscaped(text.substr(rest)) + "</small>";
  }
  return xmlEscaped(text);
}

const std::string& textOf(const ReportRow& row, std::size_t column) {
  static const std::string kNone;
  return column < row.cells.size() ? row.cells[column].text : kNone;
}

bool strong(const ReportRow& row, std::size_t column) {
  return column < row.cells.size() && row.cells[column].strong;
}

}  // namespace

std::string tableMarkdown(const ReportTable& table) {
  std::string text = fmt::format("### {}\n\n", markdownEscaped(table.title));
  if (!table.note.empty()) text += table.note + "\n\n";
  std::string rule = "|";
  text += "|";
  const std::vector<std::string> names = flatHeader(table);
  for (std::size_t i = 0; i < names.size(); ++i) {
    text += " " + markdownEscaped(names[i]) + " |";
    rule += static_cast<int>(i) < table.text_columns ? " --- |" : " ---: |";
  }
  text += "\n" + rule + "\n";
  for (const ReportRow& row : table.rows) {
    text += "|";
    for (std::size_t i = 0; i < names.size(); ++i) {
      const std::string cell = markdownEscaped(textOf(row, i));
      const bool bold = strong(row, i) || (row.heading && i == 0);
      text += bold && !cell.empty() ? " **" + cell + "** |" : " " + cell + " |";
    }
    text += "\n";
  }
  return text + "\n";
}

std::string latexEscaped(const std::string& text) {
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (text.compare(i, 2, "\xC2\xB1") == 0) {  // the sign plus-minus in UTF-8
      result += "$\\pm$";
      ++i;
    } else if (std::string("&%$#_{}").find(c) != std::string::npos) {
      result += std::string("\\") + c;
    } else if (c == '\\') {
      result += "\\textbackslash{}";
    } else if (c == '~' || c == '^') {
      result += std::string("\\") + c + "{}";
    } else if (c == '<' || c == '>') {
      result += std::string("$") + c + "$";
    } else {
      result += c == '\n' ? ' ' : c;
    }
  }
  return result;
}

namespace {

/// The spread after a mean is set small: nine columns of both would not fit on a page.
std::string latexCell(const std::string& text) {
  const std::string escaped = latexEscaped(text), mark = " $\\pm$ ";
  const std::size_t at = escaped.find(mark);
  if (at == std::string::npos) return escaped;
  return escaped.substr(0, at) + "{\\tiny$\\pm$" + escaped.substr(at + mark.size()) + "}";
}

}  // namespace

std::string tableLatex(const ReportTable& table) {
  const std::size_t columns = table.header.size();
  std::string layout;
  for (std::size_t i = 0; i < columns; ++i)
    layout += static_cast<int>(i) < table.text_columns ? 'l' : 'r';
  std::string text = fmt::format(
      "\\begin{{table}}\n\\centering\n\\footnotesize\n\\setlength{{\\tabcolsep}}{{3pt}}\n\\caption{"
      "{{}.{}{}}}\n\\label{{tab:{}}}\n",
      latexEscaped(table.title), table.note.empty() ? "" : " ", latexEscaped(table.note), table.id);
  text += fmt::format("\\begin{{tabular}}{{{}}}\n\\toprule\n", layout);
  std::string groups;
  for (const auto& [group, span] : table.groups)
    groups += fmt::format("{}\\multicolumn{{{}}}{{c}}{{{}}}", groups.empty() ? "" : " & ", span,
                          latexEscaped(group));
  if (!groups.empty()) text += groups + " \\\\\n";
  for (std::size_t i = 0; i < columns; ++i)
    text += (i ? " & " : "") + latexEscaped(table.header[i]);
  text += " \\\\\n\\midrule\n";
  for (const ReportRow& row : table.rows) {
    if (row.heading) {
      text += fmt::format("\\multicolumn{{{}}}{{l}}{{\\emph{{{}}}}} \\\\\n", columns,
                          latexEscaped(textOf(row, 0)));
      continue;
    }
    for (std::size_t i = 0; i < columns; ++i) {
      const std::string cell = latexCell(textOf(row, i));
      text += (i ? " & " : "") + (strong(row, i) ? "\\textbf{" + cell + "}" : cell);
    }
    text += " \\\\\n";
  }
  return text + "\\bottomrule\n\\end{tabular}\n\\end{table}\n";
}

std::string tableHtml(const ReportTable& table) {
  std::string text = fmt::format("<figure class=\"table\" id=\"{}\">\n<figcaption><b>{}</b>",
                                 xmlEscaped(table.id), xmlEscaped(table.title));
  if (!table.note.empty()) text += fmt::format("<span>{}</span>", xmlEscaped(table.note));
  text += "</figcaption>\n<div class=\"scroll\"><table>\n<thead>\n";
  if (!table.groups.empty()) {
    text += "<tr>";
    for (const auto& [group, span] : table.groups)
      text += fmt::format("<th colspan=\"{}\" class=\"group\">{}</th>", span, xmlEscaped(group));
    text += "</tr>\n";
  }
  text += "<tr>";
  const auto kind = [&](std::size_t i) {
    return static_cast<int>(i) < table.text_columns ? " class=\"text\"" : "";
  };
  for (std::size_t i = 0; i < table.header.size(); ++i)
    text += fmt::format("<th{}>{}</th>", kind(i), xmlEscaped(table.header[i]));
  text += "</tr>\n</thead>\n<tbody>\n";
  for (const ReportRow& row : table.rows) {
    if (row.heading) {
      text += fmt::format("<tr class=\"heading\"><th colspan=\"{}\">{}</th></tr>\n",
                          table.header.size(), xmlEscaped(textOf(row, 0)));
      continue;
    }
    text += "<tr>";
    for (std::size_t i = 0; i < table.header.size(); ++i) {
      const std::string cell = htmlCell(textOf(row, i));
      text += fmt::format("<td{}>{}</td>", kind(i), strong(row, i) ? "<b>" + cell + "</b>" : cell);
    }
    text += "</tr>\n";
  }
  return text + "</tbody>\n</table></div>\n</figure>\n";
}

}  // namespace svoscope
