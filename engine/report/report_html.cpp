// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>

#include "engine/figure/svg.h"
#include "engine/report/paper_figures.h"
#include "engine/report/report.h"
#include "engine/report/report_figures.h"

namespace svoscope {

namespace {

const char* const kPageStyle =
    R"(:root{--ground:#fff;--ink:#1f2328;--dim:#57606a;--line:#d8dce1;--band:#f6f7f9}
@media (prefers-color-scheme:dark){:root{--ground:#18191d;--ink:#dee2e7;)"
    R"(--dim:#929aa6;--line:#343a44;--band:#20232a}}
:root{color-scheme:light dark}
body{margin:0 auto;max-width:920px;padding:32px 24px 64px;background:var(--ground);color:var(--ink);
font:15px/1.5 "DejaVu Sans",Verdana,sans-serif}
h1{font-size:26px;line-height:1.25;margin:0 0 12px})"
    R"(h2{font-size:19px;margin:44px 0 12px;padding-top:12px;border-top:1px solid var(--line)}
h3{font-size:15px;margin:26px 0 8px}p{margin:0 0 8px})"
    R"(ul{margin:0 0 12px;padding-left:20px}li{margin:3px 0}
.facts{color:var(--dim);font-size:13px}nav{margin:16px 0;font-size:13px}nav a{margin-right:14px}
a{color:inherit;text-underline-offset:3px}
figure{margin:20px 0}figcaption{font-size:13px;color:var(--dim);margin:0 0 6px})"
    R"(figcaption b{display:block;color:var(--ink)}
figcaption span{display:block}.scroll{overflow-x:auto}svg{max-width:100%;height:auto;display:block}
table{border-collapse:collapse;font-size:12.5px;)"
    R"(font-variant-numeric:tabular-nums;white-space:nowrap}
th,td{padding:4px 9px;text-align:right;vertical-align:top;border-bottom:1px solid var(--line)}
td small{display:block;color:var(--dim);font-size:11px;font-weight:400}
th{font-weight:600}thead th{border-bottom:1px solid var(--dim)})"
    R"(th.group{text-align:center;border-bottom:1px solid var(--line)}
th.text,td.text{text-align:left})"
    R"(tr.heading th{text-align:left;background:var(--band);color:var(--dim)}
.panels{display:grid;grid-template-columns:repeat(auto-fill,minmax(270px,1fr));gap:10px}
details{margin:12px 0}summary{cursor:pointer;font-size:13px;color:var(--dim)}
@media print{body{max-width:none}details{display:block}}
)";

const ReportTable* tableNamed(const Report& report, const std::string& id) {
  for (const ReportTable& table : report.tables) {
    if (table.id == id) return &table;
  }
  return nullptr;
}

class Page {
 public:
  Page(const BenchResults& results, const Report& report) : results_(results), report_(report) {}

  std::string html() {
    head();
    findings();
    section("accuracy", "Accuracy");
    figureHtml(ateFigure(results_));
    table("errors");
    table("peers");
    if (!report_.comparisons.empty()) {
      section("compare", "Methods compared");
      figureHtml(ratioFigure(results_, report_.comparisons));
      table("comparison");
      table("ratios");
    }
    section("trajectories", "Trajectories");
    trajectories();
    section("robustness", "Start, losses, keyframes");
    bars("tracked", "Fraction of the frames since the first pose that have one.");
    bars("init_time_s", "Sequence time from the first frame to the first pose.");
    bars("relocalisation_time_s", "Mean sequence time from a loss to the next pose.");
    table("losses");
    bars("keyframes", "Keyframes in the map at the end.");
    section("speed", "Speed");
    bars("tracking_ms", "Median over the frames of the time the tracking thread takes.");
    bars("fps", "Frames / wall-clock time of the run, reading images included.");
    if (tableNamed(report_, "failures")) section("failed", "Failures");
    table("failures");
    section("paper", "Beside the paper");
    paper();
    return text_ + "</body>\n</html>\n";
  }

 private:
  void head() {
    text_ = fmt::format(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\"/>\n"
        "<meta name=\"viewport\" content=\"width=device-width, "
        "initial-scale=1\"/>\n<title>{0}</title>\n"
        "<style>\n{1}{2}</style>\n</head>\n<body>\n<h1>{0}</h1>\n<div class=\"facts\">\n",
        xmlEscaped(report_.title), kPageStyle, kSvgStyle);
    for (const std::string& fact : report_.facts) text_ += "<p>" + xmlEscaped(fact) + "</p>\n";
    text_ += "</div>\n<nav>";
    for (const auto& [id, name] : std::vector<std::pair<std::string, std::string>>{
             {"short", "In short"},
             {"accuracy", "Accuracy"},
             {"compare", "Methods compared"},
             {"trajectories", "Trajectories"},
             {"robustness", "Start, losses, keyframes"},
             {"speed", "Speed"},
             {"paper", "Beside the paper"}}) {
      if (id == "compare" && report_.comparisons.empty()) continue;
      text_ += fmt::format("<a href=\"#{}\">{}</a> ", id, name);
    }
    text_ += "</nav>\n";
  }

  void section(const std::string& id, const std::string& title) {
    text_ += fmt::format("<h2 id=\"{}\">{}</h2>\n", id, xmlEscaped(title));
  }

  void findings() {
    section("short", "In short");
    for (const auto& [pair, sentences] : report_.findings) {
      text_ += fmt::format("<h3>{}</h3>\n<ul>\n", xmlEscaped(pair));
      for (const std::string& sentence : sentences)
        text_ += "<li>" + xmlEscaped(sentence) + "</li>\n";
      text_ += "</ul>\n";
    }
  }

  void table(const std::string& id) {
    if (const ReportTable* found = tableNamed(report_, id)) text_ += tableHtml(*found);
  }

  void figureHtml(const ReportFigure& figure) {
    text_ += fmt::format("<figure id=\"{}\">\n{}<figcaption>{}</figcaption>\n</figure>\n",
                         figure.id, figure.svg, xmlEscaped(figure.caption));
  }

  /// The bars, with the table behind a click.
  void bars(const std::string& key, const std::string& caption) {
    const FigureInfo& info = figure(key);
    bool any = false;
    for (std::size_t s = 0; s < results_.runs.size(); ++s) {
      for (std::size_t m = 0; m < static_cast<std::size_t>(results_.own); ++m)
        any = any || results_.spread(s, m, info);
    }
    if (!any) {
      text_ += fmt::format("<p class=\"facts\">{}: no run has a value.</p>\n", info.label);
      return;
    }
    figureHtml(barFigure(results_, key, caption));
    const ReportTable* found = tableNamed(report_, key);
    if (found)
      text_ += fmt::format("<details><summary>{} as a table</summary>\n{}</details>\n", info.label,
                           tableHtml(*found));
  }

  void trajectories() {
    text_ +=
        "<p class=\"facts\">The run with the median ATE of each system after alignment, in its "
        "colour; ground truth grey, in "
        "the plane of its largest extent. Crosses: tracking was lost here.</p>\n";
    for (std::size_t s = 0; s < results_.runs.size(); ++s) {
      const std::string& name = results_.config.sequences[s].name;
      bool any = false;
      for (std::size_t m = 0; m < results_.systems.size(); ++m) any = any || results_.typical(s, m);
      text_ += fmt::format("<h3>{}</h3>\n", xmlEscaped(name));
      if (!any || results_.facts[s].ground_truth.empty()) {
        text_ += fmt::format("<p class=\"facts\">{}</p>\n",
                             any ? "No ground truth."
                             : results_.config.sequences[s].still
                                 ? "The camera stands still: no system starts, which is right."
                                 : "No system completes it.");
        continue;
      }
      text_ += "<div class=\"panels\">\n";
      for (const std::string& panel : trajectoryPanels(results_, s)) text_ += panel;
      text_ += "</div>\n" + errorPanel(results_, s);
    }
  }

  void paper() {
    text_ += fmt::format(
        "<p class=\"facts\">{}. \"here\" is this benchmark where it ran the same sequence.</p>\n",
        xmlEscaped(kPaperCitation));
    const bool ran = std::any_of(paperRows().begin(), paperRows().end(), [&](const PaperRow& row) {
      return std::any_of(
          results_.config.sequences.begin(), results_.config.sequences.end(),
          [&](const BenchSequence& s) { return samePaperSequence(row.sequence, s.name); });
    });
    if (!ran) text_ += "<p>None of the paper's sequences was run here.</p>\n";
    text_ +=
        fmt::format("<details{}><summary>Tables 1 to 7</summary>\n", ran ? " open=\"open\"" : "");
    for (const ReportTable& t : report_.paper_tables) text_ += tableHtml(t);
    text_ += "</details>\n";
  }

  const BenchResults& results_;
  const Report& report_;
  std::string text_;
};

}  // namespace

std::string reportHtml(const BenchResults& results, const Report& report) {
  return Page(results, report).html();
}

}  // namespace svoscope
