#include "feature/descriptor.h"

#include <cassert>
#include <cstddef>

namespace glide {

int descriptorDistance(const Descriptor& a, const Descriptor& b) {
  int distance = 0;
  for (std::size_t i = 0; i < a.size(); ++i) distance += __builtin_popcountll(a[i] ^ b[i]);
  return distance;
}

void descriptorDistances(const Descriptor& query,
                         std::span<const Descriptor> set,
                         std::span<const int> indices,
                         std::span<int> out) {
  assert(indices.size() == out.size());
  for (std::size_t i = 0; i < indices.size(); ++i) {
    out[i] = descriptorDistance(query, set[static_cast<std::size_t>(indices[i])]);
  }
}

}  // namespace glide
