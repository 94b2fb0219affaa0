#pragma once

#include "vit/vit_abi.h"

#include "glide/frame.h"

#include <cstdint>
#include <optional>

namespace glide {

/// Velocity from two poses of one world. Owned by the tracking thread.
class VitVelocity {
 public:
  /// The next pose has none before it: its velocity is zero, as the first one's.
  void forget() { before_.reset(); }
  /// Fills in the velocity of this frame's pose: zero after a long gap, and when the pose before is
  /// of another world (the map was corrected since, or is another one), as what lies between them
  /// is no motion.
  void add(const FrameResult& result, vit_pose_data* pose);

 private:
  std::optional<vit_pose_data> before_;
  std::uint64_t map_generation_ = 0;  ///< of before_
};

}  // namespace glide
