// SPDX-License-Identifier: MIT
#include "app/output_folder.h"

#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "engine/io/text_output.h"

namespace svoscope {

Status prepareOutputFolder(const std::filesystem::path& folder) {
  const Status made = makeFolder(folder);
  if (!made.ok()) return made;
  if (access(folder.c_str(), W_OK | X_OK) == 0) return Done{};
  return outputError(std::string("nothing can be written there: ") + std::strerror(errno),
                     folder.string(), "choose another folder with --out");
}

}  // namespace svoscope
