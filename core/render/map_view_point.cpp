#include "render/map_view_point.h"

#include <glm/ext/matrix_clip_space.hpp>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <limits>
#include <span>

namespace glide {
namespace {

/// Room around what a plan shows, as a share of its extent.
constexpr float kMargin = 0.08F;
/// How far a plan reaches beyond the cameras to show landmarks, in the cameras' extents.
constexpr float kMaxReach = 1.5F;
/// A map of one keyframe still needs an extent. Scene units: the first map's median depth is 1.
constexpr float kMinExtent = 0.3F;
/// Above and below, in extents of the ground, so that no landmark worth seeing is clipped.
constexpr float kHeights = 20.0F;
/// Of a frustum's half, at distance 1: fisheye lenses see more than a plane can show.
constexpr double kMaxHalfPlane = 1.5;
/// Of a camera that nobody described: 60 degrees wide, 4:3.
constexpr glm::vec4 kDefaultPlane{-0.577F, -0.433F, 0.577F, 0.433F};

GroundBox boxOf(std::span<const PoseRecord> cameras) {
  GroundBox box{glm::vec2(std::numeric_limits<float>::max()),
                glm::vec2(std::numeric_limits<float>::lowest())};
  for (const PoseRecord& camera : cameras) {
    const glm::vec2 p(camera.p_world[0], camera.p_world[2]);
    box.low = glm::min(box.low, p);
    box.high = glm::max(box.high, p);
  }
  return box;
}

float clampHalf(double value) {
  return static_cast<float>(std::clamp(value, -kMaxHalfPlane, kMaxHalfPlane));
}

}  // namespace

MapViewPoint viewPoint(const ViewCamera& camera, const Viewport& viewport) {
  return {glm::make_mat4(camera.view.data()), glm::make_mat4(camera.projection.data()), viewport};
}

GroundBox groundOf(const MapScene& scene) {
  if (scene.keyframes().size() + scene.frames().size() == 0) return {};
  const GroundBox keyframes = boxOf(scene.keyframes().items());
  const GroundBox frames = boxOf(scene.frames().items());
  const glm::vec2 low = glm::min(keyframes.low, frames.low);
  const glm::vec2 high = glm::max(keyframes.high, frames.high);
  if (scene.landmarks().size() == 0) return {low, high};
  const auto& least = scene.bounds().landmarks_low;
  const auto& most = scene.bounds().landmarks_high;
  const float reach = kMaxReach * std::max({high.x - low.x, high.y - low.y, kMinExtent});
  return {glm::max(glm::min(low, glm::vec2(least[0], least[2])), low - reach),
          glm::min(glm::max(high, glm::vec2(most[0], most[2])), high + reach)};
}

MapViewPoint viewFromAbove(const GroundBox& box, const Viewport& viewport) {
  const glm::vec2 center = 0.5F * (box.low + box.high);
  const glm::vec2 extent = glm::max((1.0F + kMargin) * (box.high - box.low), kMinExtent);
  const float aspect =
      static_cast<float>(viewport.width) / static_cast<float>(std::max(viewport.height, 1));
  const float half_height = 0.5F * std::max(extent.y, extent.x / aspect);
  const float half_width = half_height * aspect;
  const float reach = kHeights * std::max(half_width, half_height);
  const glm::vec3 target(center.x, 0.0F, center.y);
  constexpr glm::vec3 kUp(0.0F, -1.0F, 0.0F);
  constexpr glm::vec3 kForward(0.0F, 0.0F, 1.0F);
  return {glm::lookAt(target + kUp, target, kForward),
          glm::ortho(-half_width, half_width, -half_height, half_height, -reach, reach),
          viewport};
}

float unitsPerPixel(const MapViewPoint& view) {
  const float half_height = 1.0F / view.clip_from_eye[1][1];
  return 2.0F * half_height / static_cast<float>(view.viewport.height);
}

glm::vec2 depthCue(const MapViewPoint& view, const SceneBounds& bounds) {
  const glm::vec4 center(glm::make_vec3(bounds.center.data()), 1.0F);
  const float distance = -(view.eye_from_world * center).z;
  // What is behind the eye is not seen: the cue is about what is in front of it.
  const float begin = std::max(distance - bounds.radius, 0.0F);
  const float end = std::max(distance + bounds.radius, begin + bounds.radius);
  return {begin, 1.0F / (end - begin)};
}

glm::vec4 imagePlane(const CameraIntrinsics& camera) {
  if (camera.width <= 0 || camera.height <= 0 || camera.fx <= 0.0 || camera.fy <= 0.0)
    return kDefaultPlane;
  constexpr double kHalfPixel = 0.5;  // the first pixel's centre is (0, 0)
  return {clampHalf((-kHalfPixel - camera.cx) / camera.fx),
          clampHalf((-kHalfPixel - camera.cy) / camera.fy),
          clampHalf((camera.width - kHalfPixel - camera.cx) / camera.fx),
          clampHalf((camera.height - kHalfPixel - camera.cy) / camera.fy)};
}

}  // namespace glide
