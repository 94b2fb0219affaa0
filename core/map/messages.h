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
  double reference_scale = 1.0;  ///< Keyframe::scale of the reference that T_cam_ref is given in
  std::vector<LandmarkId> landmarks;  ///< per feature; the mapper ignores ids that are gone
  std::vector<LandmarkSighting> sightings;
};

/// A correction of a keyframe: what lies around it moves by this similarity of the world.
struct KeyframeMove {
  KeyframeId id;
  Sim3d S_new_old;  ///< p_world_new = S_new_old * p_world_old
};

/// Two keyframes that see the same place although no chain of covisible keyframes said so.
struct LoopEdge {
  KeyframeId newer, older;
};

/// Which snapshot something was solved on: MapSnapshot::generation() and corrections().
struct SolvedOn {
  std::uint64_t generation = 0, corrections = 0;
};

/// A loop, solved on a snapshot that may be older than the map by now. Keyframes and landmarks that
/// the snapshot did not have follow a covisible keyframe that it had. Ignored when the map was
/// replaced or another loop was closed since.
struct LoopCorrection {
  SolvedOn snapshot;
  LoopEdge edge;
  std::vector<KeyframeMove> keyframes;  ///< ascending id
  struct SamePoint {
    LandmarkId gone;  ///< fused into `kept`
    LandmarkId kept;
  };
  std::vector<SamePoint> same;
};

/// Global bundle adjustment of a snapshot that may be older than the map by now. Ignored when the
/// map was replaced or a loop was closed since.
struct GlobalAdjustment {
  SolvedOn snapshot;
  /// Ascending id. The scale of a move is what the keyframe's landmarks have moved away or nearer
  /// by, so that what was mapped meanwhile around it follows in size too.
  std::vector<KeyframeMove> keyframes;
  struct LandmarkShift {
    LandmarkId id;
    Vec3d shift;  ///< from its place in the snapshot: what local adjustment did meanwhile stays
  };
  std::vector<LandmarkShift> landmarks;  ///< ascending id
};

class MapSnapshot;

/// A map from a file takes the place of the present one.
struct RestoredMap {
  std::shared_ptr<const MapSnapshot> map;
};

/// Drops the map.
struct ClearMap {};

using MappingMessage =
    std::variant<InitialMap, NewKeyframe, LoopCorrection, GlobalAdjustment, RestoredMap, ClearMap>;

/// A frame that was lost, to be placed in the map without a guess.
struct RelocalizationQuery {
  std::int64_t t_ns = 0;
  std::shared_ptr<const FeatureSet> features;
};

/// The map has a keyframe that it had not: look for loops.
struct KeyframeMapped {
  KeyframeId id;
};

/// A loop correction was applied: adjust the whole map.
struct LoopClosed {};

/// Another map took the place of the one before.
struct MapReplaced {};

using LoopMessage = std::variant<KeyframeMapped, RelocalizationQuery, LoopClosed, MapReplaced>;

/// Where a lost frame was, as far as one keyframe's landmarks tell.
struct Relocalization {
  std::int64_t t_ns = 0;  ///< of the query
  KeyframeId keyframe;
  SE3d T_cam_key;
  double key_scale = 1.0;  ///< Keyframe::scale that T_cam_key is given in
  int inliers = 0;
};

}  // namespace glide
