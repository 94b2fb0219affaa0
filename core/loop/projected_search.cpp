#include "loop/projected_search.h"

#include "feature/matcher.h"

#include <algorithm>
#include <cstddef>
#include <optional>

namespace glide {
namespace {

// A surface patch seen from further aside than this looks different: cos(60 degrees).
constexpr double kMinViewingCosine = 0.5;
// The scale range of a landmark is estimated from few views: allow this much slack at its ends.
constexpr double kScaleSlack = 1.25;

std::optional<ProjectedTarget> expect(const CameraModel& camera,
                                      const ScaleLevels& levels,
                                      const Sim3d& S_cam_world,
                                      const MapSnapshot::LandmarkEntry& landmark) {
  const Vec3d p_cam = S_cam_world * landmark.p_world;
  const double distance_cam = p_cam.norm();
  const double distance = distance_cam / S_cam_world.s;  // in the landmark's unit
  if (distance > landmark.max_distance * kScaleSlack) return std::nullopt;
  if (distance < landmark.min_distance / kScaleSlack) return std::nullopt;
  const Vec3d normal_cam = S_cam_world.q * landmark.normal;
  if (normal_cam.dot(p_cam) < kMinViewingCosine * distance_cam) return std::nullopt;
  const std::optional<Vec2d> uv = camera.project(p_cam);
  if (!uv || !camera.isInImage(*uv, 0.0)) return std::nullopt;

  const int level = predictedLevel(levels, landmark.max_distance, distance);
  ProjectedTarget target;
  target.uv = uv->cast<float>();
  target.min_level = std::max(level - 1, 0);
  target.max_level = std::min(level + 1, levels.count() - 1);
  target.radius_px = static_cast<float>(levels.scale(level));  // of one px at level 0
  target.descriptor = landmark.descriptor;
  return target;
}

}  // namespace

ProjectedSearch searchProjected(const CameraModel& camera,
                                const ScaleLevels& levels,
                                const AssumedView& view,
                                std::span<const MapSnapshot::LandmarkEntry* const> landmarks,
                                const ProjectedSearchOptions& options) {
  std::vector<ProjectedTarget> targets;
  for (std::size_t i = 0; i < landmarks.size(); ++i) {
    std::optional<ProjectedTarget> target = expect(camera, levels, view.S_cam_world, *landmarks[i]);
    if (!target) continue;
    target->id = static_cast<int>(i);
    target->radius_px *= static_cast<float>(options.radius_px);
    targets.push_back(*target);
  }
  ProjectedSearch result;
  result.expected = static_cast<int>(targets.size());
  const MatchOptions match_options{options.max_distance, options.ratio, false};
  for (const Match& match : matchByProjection(targets, view.features, {}, match_options)) {
    result.matches.push_back({match.b, landmarks[static_cast<std::size_t>(match.a)]});
  }
  std::sort(result.matches.begin(), result.matches.end(), [](const auto& a, const auto& b) {
    return a.feature < b.feature;
  });
  return result;
}

}  // namespace glide
