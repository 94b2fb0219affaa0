#pragma once

#include "map/map_snapshot.h"

#include "base/ids.h"

#include <cstddef>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace glide {

/// Two keyframes that hang together; the first is older.
struct KeyframeLink {
  KeyframeId older, newer;
  int weight = 0;  ///< landmarks that both see; 0 for those that follow each other without any
};

/// How the keyframes of a snapshot hang together: covisibility, read in both directions. Parts that
/// share nothing are joined where the camera went from one to the other, so that a path leads from
/// each keyframe to each. The snapshot outlives the graph.
class KeyframeGraph {
 public:
  explicit KeyframeGraph(const MapSnapshot& map);

  /// `id` and every keyframe that at most `steps` links away share landmarks with it.
  std::set<KeyframeId> within(KeyframeId id, int steps) const;

  /// Length of the shortest way of the camera from one keyframe to another, world units; infinite
  /// when either is not in the map.
  double pathLength(KeyframeId from, KeyframeId to) const;

  /// A spanning tree of the strongest links, and all links of at least `min_weight`; ascending by
  /// older, then newer.
  std::vector<KeyframeLink> essentialLinks(int min_weight) const;

 private:
  const MapSnapshot* map_;
  std::vector<KeyframeLink> links_;  ///< ascending by older, then newer
  std::map<KeyframeId, std::vector<std::pair<KeyframeId, int>>> neighbors_;  ///< with weights

  void join();
  const std::vector<std::pair<KeyframeId, int>>& neighborsOf(KeyframeId id) const;
};

/// The keyframe and its best covisible ones, `count` in all at most.
std::vector<KeyframeId> placeOf(const MapSnapshot::KeyframeEntry& keyframe, std::size_t count);

}  // namespace glide
