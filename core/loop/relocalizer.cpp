#include "loop/relocalizer.h"

#include "loop/place_groups.h"
#include "loop/placement.h"
#include "loop/pose_suggestion.h"

#include <algorithm>
#include <vector>

namespace glide {
namespace {

constexpr int kCandidates = 15;

// What a placement has to show. A wrong one is far worse than none, for the next frame is a new
// chance. docs/algorithms/place-recognition.md has what right and wrong ones show.
constexpr int kMinInliers = 40;
constexpr double kMinFoundShare = 0.10;      // of the landmarks expected in view
constexpr double kMinAgreement = 0.65;       // of the landmarks found; by chance 0.12 agree
constexpr int kMinCells = 10;                // of 36
constexpr double kMaxPositionSigma = 0.005;  // over the depth: a third of 5 cm at 3 m

// Another place with so many inliers, over those of the best, makes the frame ambiguous.
constexpr double kRivalShare = 0.5;

bool isBeyondDoubt(const Placement& p) {
  return p.inliers >= kMinInliers && p.inliers >= kMinFoundShare * p.likely &&
         p.inliers >= kMinAgreement * p.matched && p.cells >= kMinCells &&
         p.position_sigma <= kMaxPositionSigma;
}

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
  if (placements.empty() || !isBeyondDoubt(placements.front())) return std::nullopt;
  const Placement& best = placements.front();
  const bool is_ambiguous =
      placements.size() > 1 && placements[1].inliers >= kRivalShare * best.inliers;
  const MapSnapshot::KeyframeEntry* keyframe = map.keyframe(best.reference);
  if (is_ambiguous || keyframe == nullptr) return std::nullopt;
  return Relocalization{query.t_ns,
                        keyframe->id,
                        best.T_cam_world * keyframe->T_cam_world.inverse(),
                        keyframe->scale,
                        best.inliers};
}

}  // namespace glide
