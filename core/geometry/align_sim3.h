#pragma once

#include "geometry/lie.h"

#include <optional>
#include <span>

namespace glide {

/// Least-squares similarity p_a ~ S_a_b * p_b (Umeyama 1991). Nothing for fewer than three points
/// or when they are collinear. With fixed_scale the scale is 1.
enum class AlignScale { estimated, fixed };
std::optional<Sim3d> alignSim3(std::span<const Vec3d> points_a,
                               std::span<const Vec3d> points_b,
                               AlignScale scale);

}  // namespace glide
