#pragma once

#include "map/map_snapshot.h"

#include "base/ids.h"

#include <unordered_map>
#include <vector>

namespace glide {

/// How many landmarks each pair of keyframes shares. Map keeps it in step with the observations.
class Covisibility {
 public:
  /// Adds `delta` to the weight of the pair; it never falls below zero.
  void change(KeyframeId a, KeyframeId b, int delta);

  int weight(KeyframeId a, KeyframeId b) const;

  /// Keyframes that share at least `min_weight` landmarks with `id`, best first, older first among
  /// equals. When there is none, the single best one, if any.
  std::vector<CovisibleKeyframe> neighbors(KeyframeId id, int min_weight) const;

 private:
  // Constant time also where a keyframe sees what thousands see: loaded maps may be hostile.
  std::unordered_map<KeyframeId, std::unordered_map<KeyframeId, int>> edges_;

  void changeDirected(KeyframeId from, KeyframeId to, int delta);
};

}  // namespace glide
