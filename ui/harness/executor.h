// SPDX-License-Identifier: MIT
// Runs a script's commands on the host, the content and the engine.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "ui/harness/script.h"
#include "ui/harness/script_target.h"
#include "ui/host.h"

namespace svoscope {
class Runner;
}

namespace svoscope::ui {

struct ScriptReport {
  int commands = 0;
  std::vector<std::filesystem::path> pictures;
  std::vector<std::string> notes;  ///< shots left out on the null surface
};

/// Where a script acts. `runner` may be null if the script has no engine commands.
struct ScriptStage {
  Host& host;
  UiContent& content;
  ScriptTarget& target;
  Runner* runner = nullptr;
  std::filesystem::path output;  ///< folder of the pictures
};

/// Stops at the first command that fails; the error names its line.
Result<ScriptReport> runScript(const Script& script, const ScriptStage& stage);

}  // namespace svoscope::ui
