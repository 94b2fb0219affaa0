#include "render/map_view_point.h"

#include <glm/ext/matrix_clip_space.hpp>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <limits>

namespace glide {
namespace {

/// Room around the keyframes, as a share of their extent: what they see lies there.
constexpr float kRoom = 0.35F;
/// A map of one keyframe still needs an extent. Scene units: the first map's median depth is 1.
constexpr float kMinHalfExtent = 0.5F;
/// Above and below the keyframes, in their extents, so that no landmark worth seeing is clipped.
constexpr float kHeights = 20.0F;
/// Of a frustum's half, at distance 1: fisheye lenses see more than a plane can show.
constexpr double kMaxHalfPlane = 1.5;
/// Of a camera that nobody described: 60 degrees wide, 4:3.
constexpr glm::vec4 kDefaultPlane{-0.577F, -0.433F, 0.577F, 0.433F};

/// An extent of the ground.
struct GroundBox {
  glm::vec2 low{std::numeric_limits<float>::max()};
  glm::vec2 high{std::numeric_limits<float>::lowest()};

  void add(std::span<const PoseRecord> cameras) {
    for (const PoseRecord& camera : cameras) {
      const glm::vec2 p(camera.p_world[0], camera.p_world[2]);
      low = glm::min(low, p);
      high = glm::max(high, p);
    }
  }
  bool isEmpty() const { return low.x > high.x; }
};

float clampHalf(double value) {
  return static_cast<float>(std::clamp(value, -kMaxHalfPlane, kMaxHalfPlane));
}

}  // namespace

MapViewPoint viewPoint(const ViewCamera& camera, const Viewport& viewport) {
  return {glm::make_mat4(camera.view.data()), glm::make_mat4(camera.projection.data()), viewport};
}

MapViewPoint viewFromAbove(std::span<const PoseRecord> keyframes,
                           std::span<const PoseRecord> frames,
                           const Viewport& viewport) {
  GroundBox box;
  box.add(keyframes);
  box.add(frames);
  if (box.isEmpty()) box = {glm::vec2(0.0F), glm::vec2(0.0F)};
  const glm::vec2 center = 0.5F * (box.low + box.high);
  const glm::vec2 extent = 0.5F * (box.high - box.low);
  const float room = std::max(kRoom * std::max(extent.x, extent.y), kMinHalfExtent);
  const glm::vec2 wanted = extent + room;
  const float aspect =
      static_cast<float>(viewport.width) / static_cast<float>(std::max(viewport.height, 1));
  const float half_height = std::max(wanted.y, wanted.x / aspect);
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
