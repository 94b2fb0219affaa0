#include "loop/place_groups.h"

#include <algorithm>

namespace glide {
namespace {

using Entry = MapSnapshot::KeyframeEntry;

bool isNeighbor(const Entry& of, KeyframeId id, std::size_t max_neighbors) {
  const auto end = of.neighbors.begin() +
                   static_cast<std::ptrdiff_t>(std::min(of.neighbors.size(), max_neighbors));
  return std::any_of(
      of.neighbors.begin(), end, [&](const CovisibleKeyframe& n) { return n.id == id; });
}

}  // namespace

std::vector<PlaceGroup> groupPlaces(const MapSnapshot& map,
                                    std::span<const PlaceMatch> matches,
                                    const PlaceGroupLimits& limits) {
  std::vector<PlaceGroup> groups;
  for (const PlaceMatch& match : matches) {
    const Entry* keyframe = map.keyframe(match.keyframe);
    if (keyframe == nullptr) continue;
    const auto holds = [&](const PlaceGroup& group) {
      return isNeighbor(*group.keyframes.front(), match.keyframe, limits.max_neighbors);
    };
    auto group = std::find_if(groups.begin(), groups.end(), holds);
    if (group == groups.end()) group = groups.insert(groups.end(), PlaceGroup{});
    group->score += match.score;
    if (group->keyframes.size() < limits.max_keyframes) group->keyframes.push_back(keyframe);
  }
  std::stable_sort(groups.begin(), groups.end(), [](const PlaceGroup& a, const PlaceGroup& b) {
    return a.score > b.score;
  });
  if (groups.size() > limits.max_groups) groups.resize(limits.max_groups);
  return groups;
}

}  // namespace glide
