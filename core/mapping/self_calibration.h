#pragma once

#include "mapping/mapper_state.h"

#include <cstddef>

namespace glide {

/// Corrects the lens from the map: at some sizes of a young map k1 is estimated from all that it
/// holds, and adopted when it is significant and matters (docs/algorithms/self-calibration.md).
/// Owned by the mapping thread.
class SelfCalibration {
 public:
  /// The map was extended by a keyframe. True when the camera was corrected and all of the map
  /// adjusted to it; otherwise nothing has changed.
  bool update(MapperState* state);

  /// The map was replaced. What is known of the lens stays.
  void beginMap() { next_size_ = kFirstSize; }

 private:
  // Fewer views leave k1 uncertain in every scene that was measured.
  static constexpr std::size_t kFirstSize = 8;

  std::size_t next_size_ = kFirstSize;  ///< keyframes in the map at which it is tried next
};

}  // namespace glide
