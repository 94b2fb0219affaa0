#include "loop/relocalizer.h"

#include "loop/place_groups.h"
#include "loop/placement.h"
#include "loop/placement_gates.h"
#include "loop/pose_suggestion.h"

#include <algorithm>
#include <vector>

namespace glide {
namespace {

constexpr int kCandidates = 15;

/// Distinct placements of the frame, in the order in which they were found.
std::vector<Placement> placementsOf(const Config& config,
                                    const CameraModel& camera,
                                    const MapSnapshot& map,
                                    const FeatureSet& features,
                                    const std::vector<PlaceGroup>& groups) {
  std::vector<Placement> placements;
  const auto isKnown = [&](const SE3d& T_cam_world) {
    return std::any_of(placements.begin(), placements.end(), [&](const Placement& p) {
      return areSame(p, T_cam_world);
    });
  };
  for (PlaceGroup group : groups) {
    // Once the place is found the others only have to show whether they are rivals.
    const bool is_found = std::any_of(placements.begin(), placements.end(), isBeyondDoubt);
    if (is_found) group.keyframes.resize(1);
    for (const PoseSuggestion& suggestion : suggestPoses(camera, map, group, features)) {
      if (isKnown(suggestion.T_cam_world)) continue;
      const auto placement = widen(config, camera, map, features, suggestion);
      if (placement && !isKnown(placement->T_cam_world)) placements.push_back(*placement);
    }
  }
  return placements;
}

}  // namespace

Relocalizer::Relocalizer(const Config& config, const CameraModel& camera)
    : config_(config), camera_(camera) {}

std::optional<Relocalization> Relocalizer::relocalize(const RelocalizationQuery& query,
                                                      const MapSnapshot& map,
                                                      const PlaceIndex& index) const {
  const std::vector<PlaceMatch> candidates = index.query(*query.features, kCandidates);
  std::vector<Placement> placements =
      placementsOf(config_,
                   map.cameraOr(camera_),
                   map,
                   *query.features,
                   groupPlaces(map, candidates, PlaceGroupLimits{}));
  std::stable_sort(placements.begin(), placements.end(), [](const auto& a, const auto& b) {
    return a.inliers > b.inliers;
  });
  if (placements.empty() || !isBeyondDoubt(placements.front()) || areAmbiguous(placements))
    return std::nullopt;
  const Placement& best = placements.front();
  const MapSnapshot::KeyframeEntry* keyframe = map.keyframe(best.reference);
  if (keyframe == nullptr) return std::nullopt;
  return Relocalization{query.t_ns,
                        keyframe->id,
                        best.T_cam_world * keyframe->T_cam_world.inverse(),
                        keyframe->scale,
                        best.inliers};
}

}  // namespace glide
