// SPDX-License-Identifier: MIT
// Values of a YAML file with errors that name file and line.
#pragma once

#include <yaml-cpp/yaml.h>

#include <filesystem>
#include <string>
#include <vector>

#include "engine/base/result.h"

namespace svoscope {

/// Thrown inside of a reader and turned into a Result at its border: YAML nests too deeply for
/// a check after each value.
struct YamlFault {
  Error error;
};

class YamlReader {
 public:
  /// `expand`: an unset ${NAME} is an error; otherwise it stays as it is.
  YamlReader(std::filesystem::path file, bool expand) : file_(std::move(file)), expand_(expand) {}

  [[noreturn]] void fail(const YAML::Node& node, const std::string& what,
                         const std::string& remedy) const;
  /// Faults unless `node` is a map with no other keys than these; `what` names it in the message.
  void requireKeys(const YAML::Node& node, const std::vector<std::string>& known,
                   const std::string& what) const;
  /// A scalar with ${NAME} replaced.
  std::string text(const YAML::Node& node, const std::string& what) const;
  double number(const YAML::Node& node, const std::string& what, double low, double high) const;
  int integer(const YAML::Node& node, const std::string& what, int low, int high) const;
  const std::filesystem::path& file() const { return file_; }

 private:
  std::string expanded(const YAML::Node& node, const std::string& text) const;
  std::filesystem::path file_;
  bool expand_;
};

}  // namespace svoscope
