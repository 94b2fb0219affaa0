#pragma once

#include "glide/result.h"

#include <cstddef>
#include <filesystem>
#include <span>
#include <vector>

namespace glide {

/// What is lost when the device loses power right after a file was written.
enum class FileDurability {
  synced,  ///< Nothing: the call waits for the disk.
  cached,  ///< Perhaps the file: for what can be made again. The reader checks what it reads.
};

/// Writes under a temporary name in the same folder, then renames: other programs see the file
/// whole or not at all.
Status writeFileAtomically(const std::filesystem::path& path,
                           std::span<const std::byte> bytes,
                           FileDurability durability);

Result<std::vector<std::byte>> readFile(const std::filesystem::path& path);

}  // namespace glide
