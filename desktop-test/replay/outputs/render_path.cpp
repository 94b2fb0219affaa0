#include "replay/outputs/render_path.h"

#include <algorithm>
#include <cctype>
#include <system_error>

namespace glide::replay {
namespace {

namespace fs = std::filesystem;

/// Without links, dots and a slash at the end, also of what is not there yet.
fs::path resolved(const fs::path& path) {
  std::error_code ignored;
  const fs::path whole = fs::weakly_canonical(fs::absolute(path, ignored), ignored);
  return whole.has_filename() ? whole : whole.parent_path();
}

bool holds(const fs::path& folder, const fs::path& path) {
  const auto end = std::mismatch(folder.begin(), folder.end(), path.begin(), path.end());
  return end.first == folder.end();
}

}  // namespace

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

std::optional<std::string> dangerToSource(const fs::path& target, const fs::path& source) {
  const fs::path from = resolved(source);
  const fs::path to = resolved(target);
  const bool is_danger = isVideoName(target) ? from == to || from == resolved(partialVideo(target))
                                             : holds(from, to) || holds(to, from);
  if (!is_danger) return std::nullopt;
  return target.string() + ": would be written over or into the source " + source.string();
}

fs::path partialVideo(const fs::path& video) {
  return video.parent_path() / (video.stem().string() + ".partial" + video.extension().string());
}

std::string lowerExtension(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return extension;
}

}  // namespace glide::replay
