#include "support/data_path.h"

#include <cstdlib>

namespace glide::test {

std::optional<std::filesystem::path> sharedData(const std::string& name) {
  const char* source = std::getenv("GLIDE_SOURCE_DIR");
  const std::filesystem::path root = source != nullptr ? source : ".";
  std::filesystem::path folder = root / ".." / "shared" / "data" / name;
  if (!std::filesystem::exists(folder)) return std::nullopt;
  return folder;
}

}  // namespace glide::test
