#pragma once

#include "loop/keyframe_graph.h"

#include "map/map_snapshot.h"
#include "map/place_index.h"

#include <cstddef>
#include <set>
#include <vector>

namespace glide {

/// Finds keyframes that look like a new one although no short chain of covisible keyframes leads to
/// them, and trusts those whose surroundings several keyframes in a row agreed on (Galvez-Lopez and
/// Tardos 2012; Mur-Artal et al. 2015, section VII.A). Owned by the loop thread.
class LoopDetector {
 public:
  /// The best keyframe of each place that looks right, best first; to be called once for each new
  /// keyframe, in order.
  std::vector<KeyframeId> detect(const MapSnapshot::KeyframeEntry& keyframe,
                                 const MapSnapshot& map,
                                 const KeyframeGraph& graph,
                                 const PlaceIndex& index);

  /// Forgets the evidence.
  void reset() { groups_.clear(); }

 private:
  /// A place that looked like the latest keyframes.
  struct Group {
    KeyframeId best;                 ///< looks most like the keyframe
    double score = 0.0;              ///< summed over the place
    std::set<KeyframeId> keyframes;  ///< what is covisible with `best`, and itself
    int agreeing = 1;                ///< keyframes in a row that led here
    int missed = 0;                  ///< keyframes since the last one that did
  };
  std::vector<Group> groups_;

  static std::vector<Group> groupsOf(const std::vector<PlaceMatch>& matches,
                                     const MapSnapshot& map);
  void carryOn(std::vector<Group> found);
};

}  // namespace glide
