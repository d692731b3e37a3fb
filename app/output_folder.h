// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "engine/base/result.h"

namespace svoscope {

/// Makes the folder if it is absent and sees that files can be made in it, before hours of work are
/// spent on what could not be kept.
Status prepareOutputFolder(const std::filesystem::path& folder);

}  // namespace svoscope
