#pragma once

#include "render/scene_records.h"

#include <array>
#include <cstddef>
#include <span>

namespace glide {

/// Steps between the colours of heights (shaders/render_map_points.vert).
inline constexpr std::size_t kHeightSteps = 4;

/// Where the scene is, outliers aside. World frame, scene units.
struct SceneBounds {
  std::array<float, 3> center{};
  float radius = 1.0F;  ///< most of the scene is within; positive
  /// Between these lie most landmarks, on each axis; the origin without any.
  std::array<float, 3> landmarks_low{}, landmarks_high{};
  /// Heights (-y) that part most landmarks into kHeightSteps equal shares, ascending: in a hall
  /// with a high ceiling what stands on the floor still differs.
  std::array<float, kHeightSteps + 1> heights{};
};

/// Of landmarks and cameras together; the default without either.
SceneBounds boundsOf(std::span<const LandmarkRecord> landmarks,
                     std::span<const PoseRecord> cameras);

}  // namespace glide
