#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace glide::replay {

/// By its extension: .mp4, .mkv or .avi.
bool isVideoName(const std::filesystem::path& path);

/// What is wrong with the name given to --render; nothing when it is a video or may be a folder.
std::optional<std::string> problemOfRenderPath(const std::filesystem::path& path);

/// In small letters, with its dot.
std::string lowerExtension(const std::filesystem::path& path);

}  // namespace glide::replay
