#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace glide::test {

/// Feeds a file to the decoder as it is and once more with the checksum made right. What is
/// accepted must be a map that can be worked with and that is written again as it was; else the
/// program is aborted.
void tryMapFile(std::span<const std::byte> file);

/// Files that are maps: where fuzzing starts.
std::vector<std::vector<std::byte>> seedFiles();

}  // namespace glide::test
