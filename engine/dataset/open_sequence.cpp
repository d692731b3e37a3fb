// SPDX-License-Identifier: MIT
#include <vector>

#include "engine/dataset/loader.h"
#include "engine/dataset/sequence.h"
#include "engine/dataset/synthetic/synthetic.h"

namespace svoscope {

// Each is defined in the file of its loader.
Loader tumLoader();
Loader eurocLoader();
Loader kittiLoader();
Loader tumMonoLoader();
Loader imageFolderLoader();
Loader videoFolderLoader();
Loader videoLoader();

namespace {

namespace fs = std::filesystem;

/// In the order in which they are asked.
const std::vector<Loader>& loaders() {
  static const std::vector<Loader> rows = {
      tumLoader(),         eurocLoader(),       kittiLoader(), tumMonoLoader(),
      imageFolderLoader(), videoFolderLoader(), videoLoader()};
  return rows;
}

/// "a, b or c".
std::string listed(Loader::Takes kind) {
  std::vector<std::string> layouts;
  for (const Loader& loader : loaders())
    if (loader.takes == kind) layouts.emplace_back(loader.layout);
  std::string text;
  for (std::size_t i = 0; i < layouts.size(); ++i) {
    if (i > 0) text += i + 1 < layouts.size() ? ", " : " or ";
    text += layouts[i];
  }
  return text;
}

std::string knownKinds() {
  return "a sequence is synthetic:PRESET, a folder with " + listed(Loader::Takes::folder) +
         ", or " + listed(Loader::Takes::file);
}

OpenedSequence openPath(const std::string& spec, const OpenOptions& options) {
  const fs::path path(spec);
  std::error_code ec;
  if (spec.empty() || !fs::exists(path, ec))
    return inputError("there is no such file or folder", spec, knownKinds());
  const auto kind = fs::is_directory(path, ec) ? Loader::Takes::folder : Loader::Takes::file;
  for (const Loader& loader : loaders())
    if (loader.takes == kind && loader.recognises(path)) return loader.open(path, options);
  for (const Loader& loader : loaders())
    if (loader.takes == kind && loader.resembles && loader.resembles(path))
      return loader.open(path, options);
  return inputError("no known sequence layout", spec, knownKinds());
}

}  // namespace

OpenedSequence openSequence(const std::string& spec, const OpenOptions& options) {
  if (isSyntheticSpec(spec)) {
    if (!options.camera.empty() || options.rate_hz > 0)
      return usageError("a rendered sequence has its own camera and times", spec,
                        "leave out --camera and --rate");
    return openSyntheticSequence(spec);
  }
  try {
    return openPath(spec, options);
  } catch (const fs::filesystem_error& e) {
    return inputError(e.code().message(), spec, "check that you may read the folder");
  }
}

}  // namespace svoscope
