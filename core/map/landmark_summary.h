#pragma once

#include "map/landmark.h"

#include <span>

namespace glide {

/// One sight of a landmark: from where, and at which level.
struct LandmarkSight {
  Vec3d center_world;  ///< of the camera
  int level = 0;
};

/// Mean viewing direction and scale range of a landmark; see Landmark for the rule.
struct ViewingRange {
  Vec3d normal = Vec3d::Zero();
  double min_distance = 0.0, max_distance = 0.0;
};

/// `sights` is not empty.
ViewingRange viewingRange(const Vec3d& p_world,
                          std::span<const LandmarkSight> sights,
                          const ScaleLevels& levels);

/// Index of the descriptor with the smallest median distance to the others (the first of equals);
/// `descriptors` is not empty and its pointers are not null.
std::size_t medoid(std::span<const Descriptor* const> descriptors);

}  // namespace glide
