#pragma once

#include "vit/vit_abi.h"

#include <array>
#include <cstddef>
#include <vector>

namespace glide {

/// Steps of a frame whose times a pose tells, in order: the frame was pushed, its tracking began,
/// its pose was known.
inline constexpr std::size_t kVitTimings = 3;

}  // namespace glide

/// A pose of the FIFO: what its getters answer. Owned by who pops it.
struct vit_pose {
  vit_pose_data data{};
  bool has_timing = false, has_features = false;
  std::array<std::int64_t, glide::kVitTimings> timestamps{};  ///< CLOCK_MONOTONIC, ns
  std::vector<vit_pose_feature> features;
};
