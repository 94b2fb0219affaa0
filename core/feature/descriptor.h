#pragma once

#include "feature/descriptor_pattern.h"
#include "feature/feature_set.h"

#include "image/image.h"

#include <cstdint>
#include <span>
#include <vector>

namespace glide {

/// The binary tests turned to a set of discrete orientations (Rublee et al. 2011, section 4.1).
/// Immutable once built.
class SteeredPattern {
 public:
  SteeredPattern();

  /// Descriptor of the pixel (x, y) with orientation `angle` (radians), at least kPatchRadius + 1
  /// px from the borders of the smoothed image.
  Descriptor describe(const ImageViewU8& smooth, int x, int y, float angle) const;

 private:
  std::vector<DescriptorTest> steered_;  ///< 256 tests for each orientation
};

/// Writes to `out[i]` the distance of `query` to `set[indices[i]]`. Faster per pair than
/// descriptorDistance; `out` has the length of `indices`.
void descriptorDistances(const Descriptor& query,
                         std::span<const Descriptor> set,
                         std::span<const int> indices,
                         std::span<int> out);

}  // namespace glide
