#pragma once

#include "glide/config.h"
#include "glide/result.h"

#include <filesystem>
#include <string>
#include <vector>

namespace glide::replay {

/// Applies "direct.patch_size=11". invalid_argument naming the key (and the one most like it) or
/// the value that does not fit. Ranges are validate()'s business.
Status applySetting(const std::string& key_value, Config& config);

/// Applies a YAML or JSON file of config fields, nested ("direct: {levels: 5}") or dotted
/// ("direct.levels: 5"). io naming file, line and field.
Status applyConfigFile(const std::filesystem::path& file, Config& config);

/// All fields as YAML, with units and ranges as comments; applyConfigFile reads it back. The camera
/// only when there is one.
std::string configYaml(const Config& config);

}  // namespace glide::replay
