// SPDX-License-Identifier: MIT
// All parameters of a run: one plain struct per stage, one table that names them for configuration
// files, the command line and the user interface.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "engine/base/result.h"
#include "engine/runner/runner.h"
#include "engine/tracking/tracker.h"

namespace svoscope {

struct Parameters {
  TrackerParameters tracker;
};

/// Sets "group.name" from text. Unknown keys, malformed values and values out of bounds are usage
/// errors that name the key and what is allowed.
Status setParameter(Parameters& parameters, const std::string& key, const std::string& value);

/// Ok, or a usage error that names the first parameter that is out of its bounds: values may have
/// been written into the fields.
Status checkParameters(const Parameters& parameters);

/// All parameters in the order of the stages.
std::vector<ParameterView> listParameters(const Parameters& parameters);

/// Reads a YAML file of groups: "reproject: {cell_px: 30}". Input errors name file and key.
Status loadParameters(Parameters& parameters, const std::filesystem::path& file);

/// The same layout, every parameter as used, with the method.
std::string parametersYaml(const Parameters& parameters, const std::string& method);

}  // namespace svoscope
