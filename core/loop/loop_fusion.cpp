#include "loop/loop_fusion.h"

#include "loop/keyframe_graph.h"
#include "loop/projected_search.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <utility>

namespace glide {
namespace {

using KeyframeEntry = MapSnapshot::KeyframeEntry;
using LandmarkEntry = MapSnapshot::LandmarkEntry;

// Keyframes on either side that look for the other side's landmarks: those that a pose of the loop
// still holds for.
constexpr std::size_t kSideKeyframes = 10;
// The similarity is good to a pixel at the loop itself, less good beside it.
constexpr double kRadiusPx = 4.0;
// A wrong fusion moves two landmarks.
constexpr int kMaxDescriptorDistance = 50;
constexpr double kRatio = 0.9;

/// How often each newer landmark was found where an older one was expected, or the reverse.
using Votes = std::map<std::pair<LandmarkId, LandmarkId>, int>;  // (newer, older)

bool isSeenBy(const LandmarkEntry& landmark, const std::vector<KeyframeId>& keyframes) {
  return std::any_of(
      landmark.observations.begin(), landmark.observations.end(), [&](const Observation& seen) {
        return std::binary_search(keyframes.begin(), keyframes.end(), seen.keyframe);
      });
}

/// Two features of one image are two corners.
bool areSeenTogether(const LandmarkEntry& a, const LandmarkEntry& b) {
  for (const Observation& seen_a : a.observations) {
    for (const Observation& seen_b : b.observations) {
      if (seen_a.keyframe == seen_b.keyframe) return true;
    }
  }
  return false;
}

struct Side {
  std::vector<KeyframeId> keyframes;  ///< ascending
  std::vector<const LandmarkEntry*> landmarks;
};

Side sideOf(KeyframeId id, const MapSnapshot& map) {
  Side side;
  side.keyframes = placeOf(*map.keyframe(id), kSideKeyframes);
  std::sort(side.keyframes.begin(), side.keyframes.end());
  side.landmarks = landmarksOf(map, side.keyframes);
  return side;
}

/// Landmarks that both sides see need no fusion.
void dropShared(const Side& other, Side* side) {
  const auto is_shared = [&](const LandmarkEntry* landmark) {
    return isSeenBy(*landmark, other.keyframes);
  };
  side->landmarks.erase(std::remove_if(side->landmarks.begin(), side->landmarks.end(), is_shared),
                        side->landmarks.end());
}

/// The world as the other side of the loop has it, seen from each keyframe of this side.
struct Crossing {
  const Side& viewers;
  const Side& seen;
  Sim3d S_viewers_seen;  ///< worlds
};

/// Pairs (what the viewer calls it, what the other side calls it).
std::vector<std::pair<LandmarkId, LandmarkId>> searchAcross(const CameraModel& camera,
                                                            const ScaleLevels& levels,
                                                            const Crossing& crossing,
                                                            const MapSnapshot& map) {
  const ProjectedSearchOptions options{kRadiusPx, kMaxDescriptorDistance, kRatio};
  std::vector<std::pair<LandmarkId, LandmarkId>> pairs;
  for (const KeyframeId id : crossing.viewers.keyframes) {
    const KeyframeEntry* keyframe = map.keyframe(id);
    if (keyframe == nullptr) continue;
    const Sim3d S_cam_viewers{keyframe->T_cam_world.q, keyframe->T_cam_world.t, 1.0};
    const AssumedView view{*keyframe->features, S_cam_viewers * crossing.S_viewers_seen};
    const ProjectedSearch found =
        searchProjected(camera, levels, view, crossing.seen.landmarks, options);
    for (const LandmarkMatch& match : found.matches) {
      const LandmarkId own = keyframe->landmarks[static_cast<std::size_t>(match.feature)];
      if (map.landmark(own) != nullptr) pairs.emplace_back(own, match.landmark->id);
    }
  }
  return pairs;
}

/// Most votes first, then older landmarks first.
std::vector<std::pair<LandmarkId, LandmarkId>> ranked(const Votes& votes) {
  std::vector<std::pair<std::pair<LandmarkId, LandmarkId>, int>> counted(votes.begin(),
                                                                         votes.end());
  std::stable_sort(counted.begin(), counted.end(), [](const auto& a, const auto& b) {
    return a.second > b.second;
  });
  std::vector<std::pair<LandmarkId, LandmarkId>> pairs;
  pairs.reserve(counted.size());
  for (const auto& [pair, count] : counted) pairs.push_back(pair);
  return pairs;
}

std::vector<LoopCorrection::SamePoint> choose(const Votes& votes, const MapSnapshot& map) {
  std::map<LandmarkId, LandmarkId> kept_of;              // by the one that goes
  std::map<LandmarkId, std::vector<LandmarkId>> merged;  // by the one that is kept, with itself
  for (const auto& [gone, kept] : ranked(votes)) {
    if (kept_of.count(gone) > 0) continue;
    std::vector<LandmarkId>& members = merged.try_emplace(kept, 1, kept).first->second;
    const LandmarkEntry& candidate = *map.landmark(gone);
    const bool is_apart = std::any_of(members.begin(), members.end(), [&](LandmarkId id) {
      return areSeenTogether(*map.landmark(id), candidate);
    });
    if (is_apart) continue;
    kept_of[gone] = kept;
    members.push_back(gone);
  }
  std::vector<LoopCorrection::SamePoint> same;
  same.reserve(kept_of.size());
  for (const auto& [gone, kept] : kept_of) same.push_back({gone, kept});
  return same;
}

}  // namespace

std::vector<LoopCorrection::SamePoint> findSamePoints(const CameraModel& camera,
                                                      const ScaleLevels& levels,
                                                      const LoopGeometry& loop,
                                                      const MapSnapshot& map) {
  Side newer = sideOf(loop.newer, map);
  Side older = sideOf(loop.older, map);
  dropShared(older, &newer);
  dropShared(newer, &older);
  const SE3d T_world_newer = map.keyframe(loop.newer)->T_cam_world.inverse();
  const SE3d T_older_world = map.keyframe(loop.older)->T_cam_world;
  const Sim3d S_newer_older = Sim3d{T_world_newer.q, T_world_newer.t, 1.0} * loop.S_newer_older *
                              Sim3d{T_older_world.q, T_older_world.t, 1.0};  // worlds

  Votes votes;
  for (const auto& [own, other] :
       searchAcross(camera, levels, {newer, older, S_newer_older}, map)) {
    if (!isSeenBy(*map.landmark(own), older.keyframes)) ++votes[{own, other}];
  }
  const Crossing back{older, newer, S_newer_older.inverse()};
  for (const auto& [own, other] : searchAcross(camera, levels, back, map)) {
    if (!isSeenBy(*map.landmark(own), newer.keyframes)) ++votes[{other, own}];
  }
  return choose(votes, map);
}

}  // namespace glide
