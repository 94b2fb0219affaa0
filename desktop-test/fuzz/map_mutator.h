#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace glide::test {

/// A map file with one change that leaves its sections where they are: a number replaced, a record
/// added, removed or moved, a number of the header replaced. The checksum is made right. What is no
/// map file comes back as it is.
std::vector<std::byte> mutatedMap(std::vector<std::byte> file, std::uint64_t seed);

}  // namespace glide::test
