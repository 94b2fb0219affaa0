#include "optimize/landmark_search.h"

#include <algorithm>
#include <unordered_set>

namespace glide {
namespace {

// A surface patch seen from further aside than this looks different: cos(60 degrees).
constexpr double kMinViewingCosine = 0.5;
// The scale range of a landmark is estimated from few views: allow this much slack at its ends.
constexpr double kScaleSlack = 1.25;
// A landmark is looked for at its predicted level and this many levels below and above.
constexpr int kLevelsBelow = 1;
constexpr int kLevelsAbove = 1;

}  // namespace

LandmarkSearch::LandmarkSearch(const Config& config, const CameraModel& camera)
    : config_(config),
      camera_(camera),
      levels_(config.features.scale_factor, config.features.levels) {}

bool LandmarkSearch::project(const MapSnapshot::LandmarkEntry& landmark,
                             const Request& request,
                             ProjectedTarget* target) const {
  const Vec3d p_cam = request.T_cam_world * landmark.p_world;
  const std::optional<Vec2d> uv = camera_.project(p_cam);
  if (!uv || !camera_.isInImage(*uv, 0.0)) return false;
  const double distance = p_cam.norm();
  if (distance < landmark.min_distance / kScaleSlack ||
      distance > landmark.max_distance * kScaleSlack)
    return false;
  const Vec3d direction_world = request.T_cam_world.q.conjugate() * (p_cam / distance);
  if (direction_world.dot(landmark.normal) < kMinViewingCosine) return false;

  const int level = predictedLevel(levels_, landmark.max_distance, distance);
  target->uv = uv->cast<float>();
  target->radius_px = static_cast<float>(request.radius_px * levels_.scale(level));
  target->min_level = std::max(level - kLevelsBelow, 0);
  target->max_level = std::min(level + kLevelsAbove, levels_.count() - 1);
  target->descriptor = landmark.descriptor;
  return true;
}

int LandmarkSearch::extend(std::span<const MapSnapshot::LandmarkEntry* const> landmarks,
                           const FeatureSet& features,
                           const Request& request,
                           LandmarkMatches* matches) {
  matches->of_feature.resize(features.size(), nullptr);
  std::vector<bool> taken(features.size());
  std::unordered_set<const MapSnapshot::LandmarkEntry*> matched;
  for (std::size_t i = 0; i < features.size(); ++i) {
    taken[i] = matches->of_feature[i] != nullptr;
    if (taken[i]) matched.insert(matches->of_feature[i]);
  }
  std::vector<ProjectedTarget> targets;
  for (std::size_t i = 0; i < landmarks.size(); ++i) {
    ProjectedTarget target;
    if (matched.count(landmarks[i]) > 0 || !project(*landmarks[i], request, &target)) continue;
    target.id = static_cast<int>(i);
    targets.push_back(target);
    visible_.push_back(landmarks[i]);
  }
  const MatchOptions options{request.max_distance, config_.indirect.ratio, false};
  for (const Match& match : matchByProjection(targets, features, taken, options)) {
    matches->of_feature[static_cast<std::size_t>(match.b)] =
        landmarks[static_cast<std::size_t>(match.a)];
    ++matches->count;
  }
  return static_cast<int>(targets.size());
}

PoseEstimate LandmarkSearch::refine(const SE3d& T_cam_world_guess,
                                    const FeatureSet& features,
                                    LandmarkMatches* matches) const {
  std::vector<PoseObservation> observations;
  std::vector<std::size_t> feature_of;
  for (std::size_t i = 0; i < matches->of_feature.size(); ++i) {
    if (matches->of_feature[i] == nullptr) continue;
    const Feature& feature = features.feature(i);
    observations.push_back({matches->of_feature[i]->p_world,
                            feature.uv.cast<double>(),
                            1.0 / levels_.scale(feature.level)});
    feature_of.push_back(i);
  }
  PoseEstimate estimate = optimizePose(camera_, T_cam_world_guess, observations);
  if (!estimate.valid) return estimate;
  for (std::size_t k = 0; k < feature_of.size(); ++k) {
    if (estimate.inlier[k]) continue;
    matches->of_feature[feature_of[k]] = nullptr;
    --matches->count;
  }
  return estimate;
}

}  // namespace glide
