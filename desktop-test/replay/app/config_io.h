#pragma once

#include "glide/config.h"
#include "glide/result.h"

#include <filesystem>
#include <string>
#include <vector>

namespace glide::replay {

/// Applies a YAML or JSON file of config fields, nested ("direct: {levels: 5}") or dotted
/// ("direct.levels: 5"). io naming file, line and field.
Status applyConfigFile(const std::filesystem::path& file, Config& config);

/// All fields as YAML, with units and ranges as comments; applyConfigFile reads it back. The camera
/// only when there is one.
std::string configYaml(const Config& config);

}  // namespace glide::replay
