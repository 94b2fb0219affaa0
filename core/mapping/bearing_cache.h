#pragma once

#include "map/keyframe.h"

#include "geometry/camera_model.h"

#include <unordered_map>
#include <vector>

namespace glide {

/// Unit bearings of the keyframes' features: undistortion is iterative, every neighbour asks for
/// it. Owned by the mapping thread.
class BearingCache {
 public:
  explicit BearingCache(const CameraModel& camera) : camera_(camera) {}

  /// Per feature; zero where the pixel has no bearing. The reference lives until the keyframe is
  /// forgotten.
  const std::vector<Vec3d>& of(const Keyframe& keyframe);

  void forget(KeyframeId id) { bearings_.erase(id); }
  void clear() { bearings_.clear(); }

 private:
  CameraModel camera_;
  std::unordered_map<KeyframeId, std::vector<Vec3d>> bearings_;
};

}  // namespace glide
