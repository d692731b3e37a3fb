// SPDX-License-Identifier: MIT
#include "ui/layout.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "ui/panels/panel.h"

namespace svoscope::ui {

namespace {

// The presets use the same text as layout.txt.
const char* presetText(const std::string& name) {
  if (name == "Seeds")
    return "Seeds|h 0.56 ( v 0.54 ( [Image] h 0.64 ( [Epipolar search,Plots,Log] "
           "[3-D,Selection,Parameters] ) ) "
           "[Seed] )";
  if (name == "KL / JS")
    return "KL / JS|h 0.56 ( [KL / JS] v 0.46 ( [Image,Seed,3-D] [Filter lab,Epipolar "
           "search,Selection] ) )";
  if (name == "Evaluation")
    return "Evaluation|h 0.56 ( v 0.60 ( [3-D] [Plots,Timing] ) "
           "v 0.58 ( [Evaluation] [Image,Log,Selection] ) )";
  if (name == "Compare")
    return "Compare|h 0.55 ( v 0.44 ( [Compare images] [Compare 3-D] ) "
           "v 0.45 ( [Compare metrics,Image,Log] [Compare plots,Plots,Evaluation] ) )";
  if (name == "Image only") return "Image only|[Image]";
  return "Tracking|h 0.60 ( v 0.66 ( [Image] [Plots,Timing,Evaluation] ) "
         "v 0.50 ( [3-D] [Funnel,Selection,Log,Parameters] ) )";
}

Error layoutError(const std::string& what) {
  return inputError(what, "layout", "delete the layout file or choose View > Reset layout");
}

struct Parser {
  std::istringstream in;

  Result<LayoutNode> node() {
    std::string word;
    if (!(in >> word)) return layoutError("the layout ends too early");
    if (word[0] == '[') {
      if (std::string rest; word.back() != ']' && std::getline(in, rest, ']')) word += rest + "]";
      return leaf(word);
    }
    if (word != "h" && word != "v") return layoutError("\"" + word + "\" is not h, v or [panels]");
    LayoutNode split;
    split.leaf = false;
    split.side_by_side = word == "h";
    if (!(in >> split.ratio) || !(split.ratio > 0 && split.ratio < 1))
      return layoutError("a ratio is not between 0 and 1");
    if (!(in >> word) || word != "(") return layoutError("( is missing");
    auto a = node();
    if (!a) return a;
    auto b = node();
    if (!b) return b;
    if (!(in >> word) || word != ")") return layoutError(") is missing");
    split.first = std::make_shared<LayoutNode>(a.value());
    split.second = std::make_shared<LayoutNode>(b.value());
    return split;
  }

  static Result<LayoutNode> leaf(const std::string& word) {
    if (word.size() < 3 || word.back() != ']') return layoutError("] is missing");
    LayoutNode node;
    std::istringstream names(word.substr(1, word.size() - 2));
    for (std::string name; std::getline(names, name, ',');) {
      if (name.empty()) continue;
      if (name[0] == '*') {
        node.active = static_cast<int>(node.panels.size());
        name.erase(0, 1);
      }
      if (!findPanel(name)) return layoutError("there is no panel \"" + name + "\"");
      node.panels.push_back(name);
    }
    return node;
  }
};

void write(const LayoutNode& node, std::ostream& out) {
  if (!node.leaf) {
    out << (node.side_by_side ? "h " : "v ") << node.ratio << " ( ";
    write(*node.first, out);
    out << ' ';
    write(*node.second, out);
    out << " )";
    return;
  }
  out << '[';
  for (std::size_t i = 0; i < node.panels.size(); ++i) {
    out << (i ? "," : "") << (static_cast<int>(i) == node.active ? "*" : "") << node.panels[i];
  }
  out << ']';
}

LayoutNode deepCopy(const LayoutNode& node) {
  LayoutNode copy = node;
  if (node.first) copy.first = std::make_shared<LayoutNode>(deepCopy(*node.first));
  if (node.second) copy.second = std::make_shared<LayoutNode>(deepCopy(*node.second));
  return copy;
}

}  // namespace

Layout& Layout::operator=(const Layout& o) {
  if (this == &o) return *this;
  name = o.name;
  root = deepCopy(o.root);
  return *this;
}

const std::vector<std::string>& presetNames() {
  static const std::vector<std::string> names{"Tracking",   "Seeds",   "KL / JS",
                                              "Evaluation", "Compare", "Image only"};
  return names;
}

Layout presetLayout(const std::string& name) {
  auto layout = parseLayout(presetText(name));
  return layout.ok() ? layout.value() : Layout();
}

std::string layoutText(const Layout& layout) {
  std::ostringstream out;
  out << layout.name << '|';
  write(layout.root, out);
  return out.str();
}

Result<Layout> parseLayout(const std::string& text) {
  const std::size_t bar = text.find('|');
  if (bar == std::string::npos) return layoutError("the name is missing");
  Parser parser{std::istringstream(text.substr(bar + 1))};
  auto root = parser.node();
  if (!root) return root.error();
  if (std::string rest; parser.in >> rest) return layoutError("\"" + rest + "\" is too much");
  Layout layout;
  layout.name = text.substr(0, bar);
  layout.root = root.value();
  return layout;
}

Status saveLayout(const Layout& layout, const std::string& path) {
  const std::filesystem::path file(path);
  std::error_code ignored;  // the stream below reports a folder that cannot be made
  if (file.has_parent_path()) std::filesystem::create_directories(file.parent_path(), ignored);
  std::ofstream out(file);
  out << layoutText(layout) << '\n';
  out.close();
  if (!out)
    return outputError("the layout cannot be written", path, "check the folder's permissions");
  return Done{};
}

Result<Layout> loadLayout(const std::string& path) {
  std::ifstream in(path);
  std::string line;
  if (!in || !std::getline(in, line)) return inputError("no layout was saved yet", path, "");
  return parseLayout(line);
}

std::string defaultLayoutPath() {
  const char* config = std::getenv("XDG_CONFIG_HOME");
  if (config && *config) return std::string(config) + "/svoscope/layout.txt";
  const char* home = std::getenv("HOME");
  return home && *home ? std::string(home) + "/.config/svoscope/layout.txt" : std::string();
}

bool hasPanel(const LayoutNode& node, const std::string& panel) {
  if (!node.leaf) return hasPanel(*node.first, panel) || hasPanel(*node.second, panel);
  return std::find(node.panels.begin(), node.panels.end(), panel) != node.panels.end();
}

bool isRaised(const LayoutNode& node, const std::string& panel) {
  if (!node.leaf) return isRaised(*node.first, panel) || isRaised(*node.second, panel);
  const auto active = static_cast<std::size_t>(node.active);
  return active < node.panels.size() && node.panels[active] == panel;
}

bool raisePanel(LayoutNode& node, const std::string& panel) {
  if (!node.leaf) return raisePanel(*node.first, panel) || raisePanel(*node.second, panel);
  const auto found = std::find(node.panels.begin(), node.panels.end(), panel);
  if (found == node.panels.end()) return false;
  node.active = static_cast<int>(found - node.panels.begin());
  return true;
}

void hidePanel(LayoutNode& node, const std::string& panel) {
  if (node.leaf) {
    node.panels.erase(std::remove(node.panels.begin(), node.panels.end(), panel),
                      node.panels.end());
    node.active = std::max(0, std::min(node.active, static_cast<int>(node.panels.size()) - 1));
    return;
  }
  hidePanel(*node.first, panel);
  hidePanel(*node.second, panel);
  const auto empty = [](const LayoutNode& n) { return n.leaf && n.panels.empty(); };
  // The copy keeps the surviving child alive while its parent is overwritten.
  if (empty(*node.first)) {
    const LayoutNode rest = *node.second;
    node = rest;
  } else if (empty(*node.second)) {
    const LayoutNode rest = *node.first;
    node = rest;
  }
}

void showPanel(LayoutNode& node, const std::string& panel) {
  if (!node.leaf) return showPanel(*node.second, panel);
  node.panels.push_back(panel);
  node.active = static_cast<int>(node.panels.size()) - 1;
}

}  // namespace svoscope::ui
