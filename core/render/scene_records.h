#pragma once

#include "render/packed_color.h"

#include <array>

// What the shaders of the map (shaders/render_map_*) read, as it lies in the buffers.
namespace glide {

/// A landmark.
struct LandmarkRecord {
  std::array<float, 3> p_world{};
  float observations = 0.0F;
  bool operator==(const LandmarkRecord&) const = default;
};
static_assert(sizeof(LandmarkRecord) == 16);

/// A camera.
struct PoseRecord {
  std::array<float, 3> p_world{};
  std::array<float, 4> q_world_cam_xyzw{0.0F, 0.0F, 0.0F, 1.0F};
  /// Alpha 0: the way that led here is not known. The frustum is drawn nevertheless.
  PackedColor color{};
  bool operator==(const PoseRecord&) const = default;
};
static_assert(sizeof(PoseRecord) == 32);

/// An end of a line.
struct PointRecord {
  std::array<float, 3> p_world{};
  PackedColor color{};  ///< of the line that ends here; alpha 0: there is none
  bool operator==(const PointRecord&) const = default;
};
static_assert(sizeof(PointRecord) == 16);

}  // namespace glide
