#pragma once

#include "render/scene_bounds.h"
#include "render/scene_records.h"

#include "glide/config.h"
#include "glide/render_types.h"

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include <span>

namespace glide {

/// From where the map is drawn.
struct MapViewPoint {
  glm::mat4 eye_from_world{1.0F};
  glm::mat4 clip_from_eye{1.0F};
  Viewport viewport;
};

/// What the caller asks for. In its eye axes y is up and -z forward.
MapViewPoint viewPoint(const ViewCamera& camera, const Viewport& viewport);

/// Straight from above (the world's -y), its z axis up in the picture, x to the right:
/// orthographic, as close as all `cameras` are in view with room around them.
MapViewPoint viewFromAbove(std::span<const PoseRecord> keyframes,
                           std::span<const PoseRecord> frames,
                           const Viewport& viewport);

/// Scene units that a px of the viewport is in an orthographic view.
float unitsPerPixel(const MapViewPoint& view);

/// For the depth cue: the distance at which the scene begins, and one over its extent from there
/// on.
glm::vec2 depthCue(const MapViewPoint& view, const SceneBounds& bounds);

/// The camera's image at distance 1 in its frame: left, top, right, bottom. Distortion aside.
glm::vec4 imagePlane(const CameraIntrinsics& camera);

}  // namespace glide
