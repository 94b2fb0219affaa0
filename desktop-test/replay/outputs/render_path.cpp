#include "replay/outputs/render_path.h"

#include <cctype>
#include <system_error>

namespace glide::replay {

bool isVideoName(const std::filesystem::path& path) {
  const std::string extension = lowerExtension(path);
  return extension == ".mp4" || extension == ".mkv" || extension == ".avi";
}

std::optional<std::string> problemOfRenderPath(const std::filesystem::path& path) {
  std::error_code ignored;
  if (isVideoName(path) || !path.has_extension() || std::filesystem::is_directory(path, ignored)) {
    return std::nullopt;
  }
  return path.string() + ": unknown extension " + path.extension().string() +
         " (a video is .mp4, .mkv or .avi; without an extension it is a folder of PNGs)";
}

std::string lowerExtension(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return extension;
}

}  // namespace glide::replay
