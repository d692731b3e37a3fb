// SPDX-License-Identifier: MIT
#include "engine/bench/bench_config.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <fstream>
#include <set>
#include <sstream>

#include "engine/base/methods.h"
#include "engine/bench/yaml_reader.h"
#include "engine/dataset/synthetic/spec.h"
#include "engine/dataset/synthetic/synthetic.h"
#include "engine/runner/parameters.h"

namespace svoscope {

namespace {

namespace fs = std::filesystem;

class Reader {
 public:
  Reader(const fs::path& file, BenchConfigUse use)
      : yaml_(file, use == BenchConfigUse::run), check_(use == BenchConfigUse::run) {}

  BenchConfig read(const YAML::Node& root, const std::string& text) {
    config_.text = text;
    config_.title = yaml_.file().stem().string();
    yaml_.requireKeys(root,
                      {"title", "sequences", "methods", "variants", "parameters", "runs", "mode",
                       "max_frames", "timeout_s", "least_tracked", "eval", "peers"},
                      "the configuration");
    if (root["title"]) config_.title = yaml_.text(root["title"], "title");
    if (root["max_frames"]) max_frames_ = yaml_.integer(root["max_frames"], "max_frames", 1, kMost);
    if (root["runs"]) config_.runs = yaml_.integer(root["runs"], "runs", 1, 1000);
    if (root["mode"]) config_.sync = oneOf(root["mode"], "mode", {"threaded", "sync"}) == "sync";
    if (root["timeout_s"]) config_.timeout_s = yaml_.number(root["timeout_s"], "timeout_s", 1, 1e7);
    if (root["least_tracked"])
      config_.least_tracked = yaml_.number(root["least_tracked"], "least_tracked", 0, 1);
    readSequences(root["sequences"]);
    readMethods(root["methods"]);
    if (root["parameters"]) config_.parameters = assignments(root["parameters"], "parameters");
    readVariants(root["variants"]);
    if (root["eval"]) readEvaluation(root["eval"]);
    if (root["peers"]) readPeers(root["peers"]);
    return std::move(config_);
  }

 private:
  static constexpr int kMost = 1000000000;

  std::string oneOf(const YAML::Node& node, const std::string& what,
                    const std::vector<std::string>& allowed) {
    const std::string value = yaml_.text(node, what);
    std::string list;
    for (const std::string& a : allowed) list += (list.empty() ? "" : ", ") + a;
    if (std::find(allowed.begin(), allowed.end(), value) == allowed.end())
      yaml_.fail(node, fmt::format("unknown {} '{}'", what, value), "known are " + list);
    return value;
  }

  const YAML::Node& list(const YAML::Node& node, const std::string& key) {
    if (!node.IsDefined() || !node.IsSequence() || node.size() == 0)
      yaml_.fail(node, fmt::format("'{}' is missing or not a list", key),
                 fmt::format("write '{}: [...]'", key));
    return node;
  }

  /// Names become folders and stand in tables.
  void checkName(const YAML::Node& node, const std::string& name, const std::string& what) {
    const bool good = !name.empty() && name[0] != '.' &&
                      std::all_of(name.begin(), name.end(), [](unsigned char c) {
                        return std::isalnum(c) || c == '.' || c == '_' || c == '-';
                      });
    if (!good)
      yaml_.fail(node, fmt::format("'{}' cannot be the name of a {}", name, what),
                 "letters, digits, '.', '_' and '-'; give another with 'name:'");
    if (!names_.insert(what + " " + name).second)
      yaml_.fail(node, fmt::format("{} '{}' occurs twice", what, name),
                 "give one of them another 'name:'");
  }

  static std::string nameOf(const std::string& path) {
    if (isSyntheticSpec(path)) return path.substr(path.find(':') + 1);
    const fs::path p = fs::path(path).lexically_normal();
    return p.filename().empty() ? p.parent_path().filename().string() : p.filename().string();
  }

  std::string resolved(const std::string& path) {
    if (path.empty() || isSyntheticSpec(path) || fs::path(path).is_absolute()) return path;
    return (yaml_.file().parent_path() / path).string();
  }

  void readSequences(const YAML::Node& node) {
    for (const auto& entry : list(node, "sequences")) {
      BenchSequence sequence;
      sequence.max_frames = max_frames_;
      std::string path;
      if (entry.IsScalar()) {
        path = yaml_.text(entry, "sequence");
      } else {
        yaml_.requireKeys(entry, {"path", "name", "group", "start", "max_frames", "still"},
                          "a sequence");
        if (!entry["path"])
          yaml_.fail(entry, "a sequence has no 'path'", "a folder, a video or synthetic:PRESET");
        path = yaml_.text(entry["path"], "path");
        if (entry["name"]) sequence.name = yaml_.text(entry["name"], "name");
        if (entry["group"]) sequence.group = yaml_.text(entry["group"], "group");
        if (entry["still"])
          sequence.still = oneOf(entry["still"], "still", {"true", "false"}) == "true";
        if (entry["start"]) sequence.start = yaml_.integer(entry["start"], "start", 0, kMost);
        if (entry["max_frames"])
          sequence.max_frames = yaml_.integer(entry["max_frames"], "max_frames", 1, kMost);
      }
      if (isSyntheticSpec(path)) {
        const auto spec = parseSyntheticSpec(path);
        if (!spec.ok()) yaml_.fail(entry, spec.error().what, spec.error().remedy);
        if (sequence.group.empty()) sequence.group = "Synthetic";
      }
      if (sequence.name.empty()) sequence.name = nameOf(path);
      if (sequence.group.empty()) sequence.group = "Sequences";
      sequence.path = resolved(path);
      checkName(entry, sequence.name, "sequence");
      config_.sequences.push_back(sequence);
    }
  }

  void readMethods(const YAML::Node& node) {
    if (!node.IsDefined()) {
      config_.methods = methodIds();
      return;
    }
    for (const auto& entry : list(node, "methods")) {
      config_.methods.push_back(oneOf(entry, "method", methodIds()));
      checkName(entry, config_.methods.back(), "method");
    }
  }

  /// Keys are those of `run --set`; groups may also be nested, as in a parameter file.
  Assignments assignments(const YAML::Node& node, const std::string& what) {
    Assignments result;
    if (node.IsNull()) return result;
    if (!node.IsMap()) yaml_.fail(node, what + " is not a map", "write 'group.key: value'");
    for (const auto& entry : node) {
      const std::string key = yaml_.text(entry.first, what);
      if (!entry.second.IsMap()) {
        assign(result, entry.first, key, yaml_.text(entry.second, key));
        continue;
      }
      for (const auto& inner : entry.second)
        assign(result, inner.first, key + "." + yaml_.text(inner.first, what),
               yaml_.text(inner.second, key));
    }
    return result;
  }

  void assign(Assignments& result, const YAML::Node& node, const std::string& key,
              const std::string& value) {
    Parameters scratch;
    const Status set = setParameter(scratch, key, value);
    // An older program's configuration can still be reported on.
    if (!set.ok() && check_) yaml_.fail(node, key + ": " + set.error().what, set.error().remedy);
    result.emplace_back(key, value);
  }

  void readVariants(const YAML::Node& node) {
    if (!node.IsDefined()) {
      config_.variants.push_back({});
      return;
    }
    if (!node.IsMap() || node.size() == 0)
      yaml_.fail(node, "'variants' is not a map", "write 'variants: {wide: {search.sigmas: 5}}'");
    for (const auto& entry : node) {
      const std::string name = yaml_.text(entry.first, "variant");
      checkName(entry.first, name, "variant");
      config_.variants.push_back({name, assignments(entry.second, "variant " + name)});
    }
  }

  void readEvaluation(const YAML::Node& node) {
    EvalOptions& e = config_.evaluation;
    yaml_.requireKeys(node, {"align", "align_first", "max_dt", "delta", "all_pairs"}, "eval");
    if (node["align"])
      e.alignment = parseAlignment(oneOf(node["align"], "align", {"none", "se3", "sim3"})).value();
    if (node["align_first"])
      e.align_first = yaml_.integer(node["align_first"], "align_first", 3, kMost);
    if (node["max_dt"]) e.max_dt = yaml_.number(node["max_dt"], "max_dt", 0, 1e6);
    if (node["all_pairs"])
      e.all_pairs = oneOf(node["all_pairs"], "all_pairs", {"true", "false"}) == "true";
    if (node["delta"]) {
      const auto delta = parseDelta(yaml_.text(node["delta"], "delta"));
      if (!delta.ok()) yaml_.fail(node["delta"], delta.error().what, delta.error().remedy);
      e.delta = delta.value();
    }
  }

  void readPeers(const YAML::Node& node) {
    for (const auto& entry : list(node, "peers")) {
      yaml_.requireKeys(entry, {"label", "files"}, "a peer");
      if (!entry["label"] || !entry["files"])
        yaml_.fail(entry, "a peer needs 'label' and 'files'", "files: folder/orb-{sequence}.txt");
      BenchPeer peer{yaml_.text(entry["label"], "label"), yaml_.text(entry["files"], "files")};
      if (peer.files.find("{sequence}") == std::string::npos)
        yaml_.fail(entry["files"], "'files' has no {sequence}", "as in folder/orb-{sequence}.txt");
      if (peer.label.empty() || peer.label[0] == '.' || peer.label.find('/') != std::string::npos)
        yaml_.fail(entry["label"], fmt::format("'{}' cannot be a label", peer.label),
                   "it becomes a folder's name");
      peer.files = resolved(peer.files);
      if (!names_.insert("peer " + peer.label).second)
        yaml_.fail(entry, fmt::format("peer '{}' occurs twice", peer.label),
                   "give it another label");
      config_.peers.push_back(peer);
    }
  }

  YamlReader yaml_;
  bool check_;
  BenchConfig config_;
  int max_frames_ = 0;
  std::set<std::string> names_;
};

}  // namespace

std::vector<BenchSystem> BenchConfig::systems() const {
  std::vector<BenchSystem> result;
  for (std::size_t v = 0; v < variants.size(); ++v) {
    for (const std::string& method : methods) {
      const std::string& name = variants[v].name;
      result.push_back({name.empty() ? method : method + " " + name,
                        name.empty() ? method : method + "+" + name, method, static_cast<int>(v)});
    }
  }
  return result;
}

Result<BenchConfig> loadBenchConfig(const fs::path& file, BenchConfigUse use) {
  std::ifstream in(file, std::ios::binary);
  std::error_code ec;
  if (!in || fs::is_directory(file, ec))
    return inputError("cannot be read", file.string(),
                      "give a benchmark configuration (docs/bench.md)");
  std::stringstream text;
  text << in.rdbuf();
  try {
    return Reader(file, use).read(YAML::Load(text.str()), text.str());
  } catch (const YamlFault& fault) {
    return fault.error;
  } catch (const YAML::Exception& e) {
    return inputError(e.what(), file.string(), "write YAML as in docs/bench.md");
  }
}

}  // namespace svoscope
