#pragma once

#include "render/map_scene.h"
#include "render/scene_bounds.h"

#include "glide/config.h"
#include "glide/render_types.h"

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

namespace glide {

/// From where the map is drawn.
struct MapViewPoint {
  glm::mat4 eye_from_world{1.0F};
  glm::mat4 clip_from_eye{1.0F};
  Viewport viewport;
};

/// What the caller asks for. In its eye axes y is up and -z forward.
MapViewPoint viewPoint(const ViewCamera& camera, const Viewport& viewport);

/// A rectangle of the ground: x and z of the world.
struct GroundBox {
  glm::vec2 low{0.0F}, high{0.0F};
};

/// What a plan shows: all cameras, and most landmarks as far as they lie around these.
GroundBox groundOf(const MapScene& scene);

/// Straight from above (the world's -y), its z axis up in the picture, x to the right:
/// orthographic, as close as the box is in view.
MapViewPoint viewFromAbove(const GroundBox& box, const Viewport& viewport);

/// Scene units that a px of the viewport is in an orthographic view.
float unitsPerPixel(const MapViewPoint& view);

/// For the depth cue: the distance at which the scene begins, and one over its extent from there
/// on.
glm::vec2 depthCue(const MapViewPoint& view, const SceneBounds& bounds);

/// All is as near as can be.
inline constexpr glm::vec2 kNoDepthCue{0.0F, 0.0F};

/// The camera's image at distance 1 in its frame: left, top, right, bottom. Distortion aside.
glm::vec4 imagePlane(const CameraIntrinsics& camera);

}  // namespace glide
