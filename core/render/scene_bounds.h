#pragma once

#include "render/scene_records.h"

#include <array>
#include <span>

namespace glide {

/// Where the scene is, outliers aside. World frame, scene units.
struct SceneBounds {
  std::array<float, 3> center{};
  float radius = 1.0F;  ///< most of the scene is within; positive
  /// Between these lie most landmarks, on each axis; the origin without any.
  std::array<float, 3> landmarks_low{}, landmarks_high{};
  float low = -1.0F, high = 1.0F;  ///< heights (-y) between which most landmarks lie; low < high
};

/// Of landmarks and cameras together; the default without either.
SceneBounds boundsOf(std::span<const LandmarkRecord> landmarks,
                     std::span<const PoseRecord> cameras);

}  // namespace glide
