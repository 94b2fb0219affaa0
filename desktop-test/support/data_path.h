#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace glide::test {

/// A folder of ../shared/data beside the source tree, when that is there.
std::optional<std::filesystem::path> sharedData(const std::string& name);

}  // namespace glide::test
