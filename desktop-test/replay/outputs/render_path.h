#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace glide::replay {

/// By its extension: .mp4, .mkv or .avi.
bool isVideoName(const std::filesystem::path& path);

/// What is wrong with the name given to --render; nothing when it is a video or may be a folder.
std::optional<std::string> problemOfRenderPath(const std::filesystem::path& path);

/// Why --render must not write there: a video would replace the source, or a folder of pictures is
/// the source, lies in it or holds it. Nothing when the source is safe.
std::optional<std::string> dangerToSource(const std::filesystem::path& target,
                                          const std::filesystem::path& source);

/// Beside a video: where it grows until it is whole.
std::filesystem::path partialVideo(const std::filesystem::path& video);

/// In small letters, with its dot.
std::string lowerExtension(const std::filesystem::path& path);

}  // namespace glide::replay
