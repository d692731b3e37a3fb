// SPDX-License-Identifier: MIT
#include "ui/harness/script.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>

namespace svoscope::ui {
namespace {

struct Syntax {
  const char* name;
  const char* arguments;
  int minimum, maximum;  // words; maximum -1: any number
  const char* meaning;
};

constexpr Syntax kSyntax[] = {
    {"open", "SEQUENCE", 1, 1, "the sequence or recording; first command only"},
    {"step", "[N]", 0, 1, "process N frames (1)"},
    {"run-to", "keyframe|lost|start|N", 1, 1, "process frames until then"},
    {"back", "[N]", 0, 1, "view N frames earlier (1)"},
    {"goto", "N|live", 1, 1, "view a processed frame, or follow the engine"},
    {"reset", "", 0, 0, "start the run again"},
    {"run", "NAME", 1, -1, "make another open run the current one, by name or number"},
    {"select", "feature ID|seed ID|at X Y|none", 1, 4,
     "an ID may be `any` or `any or none`; X Y are image pixels"},
    {"panel", "NAME", 1, -1, "show this panel alone; `panel all` shows the layout again"},
    {"layout", "NAME", 1, -1, "switch to a layout"},
    {"click", "LABEL", 1, -1, "press and release the left button on a widget"},
    {"double-click", "LABEL", 1, -1, "twice, fast"},
    {"right-click", "LABEL", 1, -1, "the right button"},
    {"hover", "LABEL", 1, -1, "leave the mouse there"},
    {"drag", "LABEL DX DY", 3, 3, "press on a widget, move by DX DY pixels, release"},
    {"wheel", "LABEL N", 2, 2, "turn the wheel by N notches over a widget"},
    {"key", "NAME", 1, 1, "press and release: space, right, ctrl+s, ?"},
    {"type", "TEXT", 1, -1, "into the widget that has the focus"},
    {"wait", "[N]", 0, 1, "draw N frames (1)"},
    {"set", "KEY VALUE", 2, 2, "an engine parameter or an option of the display"},
    {"scale", "S", 1, 1, "size of fonts and widgets"},
    {"size", "WxH", 1, 1, "size of the window in pixels"},
    {"shot", "FILE [PANEL]", 1, -1, "picture of the window or of one panel"},
    {"export", "PANEL FILE", 2, -1, "what a panel shows, as FILE.csv, .svg or .png"},
    {"expect", "NAME OP VALUE", 3, -1,
     "stop unless it holds: == != < <= > >= has; NAME@RUN asks another run"},
};

const Syntax* findSyntax(const std::string& name) {
  for (const Syntax& syntax : kSyntax) {
    if (name == syntax.name) return &syntax;
  }
  return nullptr;
}

std::string knownCommands() {
  std::string names;
  for (const Syntax& syntax : kSyntax)
    names += std::string(names.empty() ? "" : ", ") + syntax.name;
  return names;
}

/// Splits at blanks outside of double quotes; '#' starts a comment there. False: quote left open.
bool splitWords(const std::string& line, std::vector<std::string>& words, std::size_t& end) {
  std::string word;
  bool quoted = false, started = false;
  const auto finish = [&] {
    if (started) words.push_back(word);
    word.clear();
    started = false;
  };
  for (end = 0; end < line.size(); ++end) {
    const char c = line[end];
    if (c == '"') {
      quoted = !quoted;
      started = true;
    } else if (!quoted && (c == ' ' || c == '\t' || c == '\r')) {
      finish();
    } else if (!quoted && !started && c == '#' && (words.empty() || line.substr(end, 2) != "##")) {
      break;  // " # note" is a comment; "Play#2" and "##view" are labels
    } else {
      word += c;
      started = true;
    }
  }
  finish();
  return !quoted;
}

std::string trimmed(const std::string& text) {
  const std::size_t first = text.find_first_not_of(" \t\r");
  if (first == std::string::npos) return "";
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

Result<ScriptCommand> parseCommand(const std::string& line, std::vector<std::string> words,
                                   const Script& script, int number) {
  ScriptCommand command;
  command.line = number;
  command.name = words.front();
  const Syntax* syntax = findSyntax(command.name);
  if (!syntax) {
    return scriptError(script, command, "unknown command '" + command.name + "'",
                       "known: " + knownCommands());
  }
  const std::string text = trimmed(line);
  command.rest = trimmed(text.substr(std::min(text.size(), command.name.size())));
  words.erase(words.begin());
  command.arguments = std::move(words);
  const int count = static_cast<int>(command.arguments.size());
  if (count < syntax->minimum || (syntax->maximum >= 0 && count > syntax->maximum)) {
    return scriptError(script, command, "wrong number of arguments",
                       std::string("write: ") + syntax->name + " " + syntax->arguments);
  }
  if (command.name == "shot") {
    const std::string extension =
        std::filesystem::path(command.arguments.front()).extension().string();
    if (!extension.empty() && extension != ".png") {
      return scriptError(script, command,
                         "'" + command.arguments.front() + "' does not end in .png",
                         "pictures are written as PNG");
    }
  }
  if (command.name == "open" && !script.commands.empty()) {
    return scriptError(script, command, "'open' must be the first command", "move it to the top");
  }
  return command;
}

}  // namespace

std::optional<std::string> Script::sequence() const {
  if (commands.empty() || commands.front().name != "open") return std::nullopt;
  return commands.front().arguments.front();
}

Error scriptError(const Script& script, const ScriptCommand& command, std::string what,
                  std::string remedy) {
  return inputError(std::move(what), script.source + ":" + std::to_string(command.line),
                    std::move(remedy));
}

Result<Script> parseScript(const std::string& text, const std::string& source) {
  Script script;
  script.source = source;
  std::istringstream lines(text);
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    std::vector<std::string> words;
    std::size_t end = 0;
    if (!splitWords(line, words, end)) {
      ScriptCommand here;
      here.line = number;
      return scriptError(script, here, "a quote is left open", "add the closing \"");
    }
    if (words.empty()) continue;
    Result<ScriptCommand> command =
        parseCommand(line.substr(0, end), std::move(words), script, number);
    if (!command) return command.error();
    script.commands.push_back(std::move(command).value());
  }
  return script;
}

Result<Script> readScript(const std::filesystem::path& file) {
  std::error_code ec;
  if (std::filesystem::is_directory(file, ec)) {
    return inputError("this is a folder, not a script", file.string(), "name a file of commands");
  }
  std::ifstream stream(file);
  const std::string text{std::istreambuf_iterator<char>(stream), {}};
  if (!stream.is_open() || stream.bad()) {
    return inputError("the script cannot be read", file.string(), "check the path");
  }
  // What a pipe is called tells only with its folder: /dev/fd/63.
  const bool plain = std::filesystem::is_regular_file(file, ec);
  return parseScript(text, plain ? file.filename().string() : file.string());
}

std::string scriptHelp() {
  std::string help;
  for (const Syntax& syntax : kSyntax) {
    std::string usage = std::string(syntax.name) + " " + syntax.arguments;
    usage.resize(std::max<std::size_t>(usage.size() + 1, 40), ' ');
    help += "  " + usage + syntax.meaning + "\n";
  }
  return help;
}

}  // namespace svoscope::ui
