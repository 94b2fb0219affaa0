#pragma once

#include "feature/feature_set.h"

#include "base/ids.h"
#include "geometry/lie.h"

#include <cstdint>
#include <memory>
#include <variant>
#include <vector>

namespace glide {

/// How often tracking expected and found a landmark since the last message.
struct LandmarkSighting {
  LandmarkId id;
  int visible = 0;
  int found = 0;
};

/// Two views and their triangulated points: the first map (or a fresh one: the old map is dropped).
/// Poses are consistent with the points; the mapper runs full BA and renormalises the median depth.
struct InitialMap {
  struct View {
    KeyframeId id;
    std::int64_t t_ns = 0;
    std::shared_ptr<const FeatureSet> features;
    SE3d T_cam_world;
  };
  struct Point {
    Vec3d p_world;
    int feature_a = 0, feature_b = 0;
  };
  View a, b;
  std::vector<Point> points;
};

/// A tracked frame that becomes a keyframe. The pose is relative to a keyframe of the map; ids of
/// keyframes are given by the tracker, ascending.
struct NewKeyframe {
  KeyframeId id;
  std::int64_t t_ns = 0;
  std::shared_ptr<const FeatureSet> features;
  KeyframeId reference;
  SE3d T_cam_ref;
  std::vector<LandmarkId> landmarks;  ///< per feature; the mapper ignores ids that are gone
  std::vector<LandmarkSighting> sightings;
};

using MappingMessage = std::variant<InitialMap, NewKeyframe>;

}  // namespace glide
