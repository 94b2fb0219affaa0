#include "mapping/insertion.h"

#include "optimize/pose_optimizer.h"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

namespace glide {
namespace {

// Fewer points do not hold a pose against a few mismatches.
constexpr std::size_t kMinObservations = 10;
// The re-optimised pose is taken only when most of the tracker's matches support it.
constexpr int kMinInliers = 20;
constexpr double kMinInlierShare = 0.5;

bool isNewest(const Map& map, KeyframeId id) {
  const bool after_living = map.keyframes().empty() || map.keyframes().rbegin()->first < id;
  const bool after_retired = map.retired().empty() || map.retired().rbegin()->first < id;
  return after_living && after_retired;
}

std::vector<Observation> addObservations(const NewKeyframe& message, Map* map) {
  std::vector<Observation> added;
  const std::size_t count = std::min(message.landmarks.size(), message.features->size());
  for (std::size_t i = 0; i < count; ++i) {
    if (message.landmarks[i] == kNoLandmark) continue;
    const Observation observation{message.id, static_cast<int>(i)};
    if (map->addObservation(message.landmarks[i], observation)) added.push_back(observation);
  }
  return added;
}

PoseObservation poseObservation(const MapperState& state, const Keyframe& keyframe, int feature) {
  const auto slot = static_cast<std::size_t>(feature);
  const Feature& corner = keyframe.features->feature(slot);
  const Landmark& landmark = *state.map.landmark(keyframe.landmarks[slot]);
  return {
      landmark.p_world, corner.uv.cast<double>(), inverseSigma(state.map.levels(), corner.level)};
}

// The map has moved since the frame was tracked.
void refinePose(MapperState* state, KeyframeId id, const std::vector<Observation>& observations) {
  const Keyframe& keyframe = *state->map.keyframe(id);
  std::vector<PoseObservation> seen;
  seen.reserve(observations.size());
  for (const Observation& observation : observations) {
    seen.push_back(poseObservation(*state, keyframe, observation.feature));
  }
  const PoseEstimate estimate = optimizePose(state->camera, keyframe.T_cam_world, seen);
  const double share = static_cast<double>(estimate.inliers) / static_cast<double>(seen.size());
  if (!estimate.valid || estimate.inliers < kMinInliers || share < kMinInlierShare) return;
  state->map.setPose(id, estimate.T_cam_world);
  for (std::size_t i = 0; i < observations.size(); ++i) {
    if (estimate.inlier[i]) continue;
    const auto slot = static_cast<std::size_t>(observations[i].feature);
    state->map.removeObservation(keyframe.landmarks[slot], id);
  }
}

}  // namespace

bool insertKeyframe(MapperState* state, const NewKeyframe& message) {
  const std::optional<SE3d> T_ref_world = state->map.T_cam_world(message.reference);
  if (!T_ref_world || !isNewest(state->map, message.id)) return false;
  Keyframe keyframe;
  keyframe.id = message.id;
  keyframe.t_ns = message.t_ns;
  // Corrections since the frame was tracked may have changed the reference's unit.
  keyframe.scale = *state->map.scale(message.reference) / message.reference_scale;
  keyframe.T_cam_world =
      SE3d{message.T_cam_ref.q, keyframe.scale * message.T_cam_ref.t} * *T_ref_world;
  keyframe.features = message.features;
  state->map.addKeyframe(std::move(keyframe));

  const std::vector<Observation> observations = addObservations(message, &state->map);
  if (observations.size() < kMinObservations) {
    state->map.retireKeyframe(message.id);
    return false;
  }
  refinePose(state, message.id, observations);
  state->map.refreshChanged();
  return true;
}

}  // namespace glide
