#include "map/local_map.h"

#include <algorithm>
#include <map>

namespace glide {
namespace {

using Entry = MapSnapshot::KeyframeEntry;

/// Keyframes by falling number of the given landmarks that they see; ties by newer id.
std::vector<KeyframeId> keyframesByVotes(const MapSnapshot& map, std::span<const LandmarkId> seen) {
  std::map<KeyframeId, int> votes;
  for (const LandmarkId id : seen) {
    const MapSnapshot::LandmarkEntry* landmark = id == kNoLandmark ? nullptr : map.landmark(id);
    if (landmark == nullptr) continue;
    for (const Observation& observation : landmark->observations) ++votes[observation.keyframe];
  }
  std::vector<std::pair<int, KeyframeId>> ranked;
  for (const auto& [id, count] : votes) ranked.emplace_back(count, id);
  std::sort(ranked.begin(), ranked.end(), [](const auto& a, const auto& b) { return b < a; });
  std::vector<KeyframeId> ids;
  for (const auto& entry : ranked) ids.push_back(entry.second);
  return ids;
}

void appendUnique(KeyframeId id, std::size_t limit, std::vector<KeyframeId>* ids) {
  if (ids->size() >= limit) return;
  if (std::find(ids->begin(), ids->end(), id) == ids->end()) ids->push_back(id);
}

std::vector<KeyframeId> localKeyframes(const MapSnapshot& map,
                                       std::vector<KeyframeId> voted,
                                       std::size_t limit) {
  if (voted.size() > limit) voted.resize(limit);
  std::vector<KeyframeId> local = voted;
  for (const KeyframeId id : voted) {
    const Entry* entry = map.keyframe(id);
    if (entry == nullptr) continue;
    for (const CovisibleKeyframe& neighbor : entry->neighbors)
      appendUnique(neighbor.id, limit, &local);
  }
  return local;
}

int countLandmarks(const Entry& entry) {
  return static_cast<int>(std::count_if(entry.landmarks.begin(),
                                        entry.landmarks.end(),
                                        [](LandmarkId id) { return id != kNoLandmark; }));
}

}  // namespace

std::vector<const MapSnapshot::LandmarkEntry*> landmarksOf(const MapSnapshot& map,
                                                           std::span<const LandmarkId> ids) {
  std::vector<const MapSnapshot::LandmarkEntry*> landmarks;
  for (const LandmarkId id : ids) {
    const MapSnapshot::LandmarkEntry* landmark = id == kNoLandmark ? nullptr : map.landmark(id);
    if (landmark != nullptr) landmarks.push_back(landmark);
  }
  return landmarks;
}

LocalMap collectLocalMap(const MapSnapshot& map,
                         std::span<const LandmarkId> seen,
                         const LocalMapLimits& limits) {
  LocalMap local;
  const std::vector<KeyframeId> voted = keyframesByVotes(map, seen);
  if (voted.empty()) return local;
  local.reference = voted.front();
  if (const Entry* reference = map.keyframe(local.reference))
    local.reference_landmarks = countLandmarks(*reference);

  std::vector<bool> taken(map.landmarks().size(), false);
  const std::size_t max_landmarks = static_cast<std::size_t>(limits.max_landmarks);
  const MapSnapshot::LandmarkEntry* first = map.landmarks().data();
  for (const KeyframeId id :
       localKeyframes(map, voted, static_cast<std::size_t>(limits.max_keyframes))) {
    const Entry* entry = map.keyframe(id);
    if (entry == nullptr || local.landmarks.size() >= max_landmarks) continue;
    for (const MapSnapshot::LandmarkEntry* landmark : landmarksOf(map, entry->landmarks)) {
      const std::size_t index = static_cast<std::size_t>(landmark - first);
      if (taken[index]) continue;
      taken[index] = true;
      local.landmarks.push_back(landmark);
    }
  }
  if (local.landmarks.size() > max_landmarks) local.landmarks.resize(max_landmarks);
  return local;
}

}  // namespace glide
