#pragma once

#include "map/keyframe.h"
#include "map/landmark.h"
#include "map/messages.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

namespace glide {

/// A keyframe with its share of the covisibility graph, best neighbour first.
struct CovisibleKeyframe {
  KeyframeId id;
  int weight = 0;  ///< landmarks that both see
};

/// The whole map at one revision, immutable: what the tracker and the viewers read.
class MapSnapshot {
 public:
  struct KeyframeEntry {
    KeyframeId id;
    std::int64_t t_ns = 0;
    SE3d T_cam_world;
    double scale = 1.0;  ///< accumulated scale of the keyframe (loop closing changes it)
    std::shared_ptr<const FeatureSet> features;
    std::vector<LandmarkId> landmarks;  ///< per feature
    std::vector<CovisibleKeyframe> neighbors;
  };
  struct LandmarkEntry {
    LandmarkId id;
    Vec3d p_world, normal;
    double min_distance = 0.0, max_distance = 0.0;
    Descriptor descriptor{};
    std::vector<Observation> observations;
    KeyframeId first_keyframe;
    int visible_count = 0, found_count = 0;  ///< as in Landmark
  };
  struct RetiredEntry {
    KeyframeId id;
    std::int64_t t_ns = 0;
    SE3d T_cam_world;
    double scale = 1.0;
    KeyframeId parent;  ///< living
    SE3d T_cam_parent;
  };

  MapSnapshot() = default;  ///< empty, revision 0
  MapSnapshot(std::uint64_t revision,
              std::vector<KeyframeEntry> keyframes,
              std::vector<LandmarkEntry> landmarks,
              std::vector<RetiredEntry> retired,
              std::vector<LoopEdge> loops);

  std::uint64_t revision() const { return revision_; }
  bool empty() const { return keyframes_.empty(); }
  const std::vector<KeyframeEntry>& keyframes() const { return keyframes_; }  ///< ascending id
  const std::vector<LandmarkEntry>& landmarks() const { return landmarks_; }  ///< ascending id
  const std::vector<RetiredEntry>& retired() const { return retired_; }
  const std::vector<LoopEdge>& loops() const { return loops_; }  ///< in the order of closing

  /// Null when the map has no such thing (any more).
  const KeyframeEntry* keyframe(KeyframeId id) const;
  const LandmarkEntry* landmark(LandmarkId id) const;

  /// Pose of a keyframe, living or retired.
  std::optional<SE3d> T_cam_world(KeyframeId id) const;
  /// Keyframe::scale of a keyframe, living or retired.
  std::optional<double> scale(KeyframeId id) const;

 private:
  std::uint64_t revision_ = 0;
  std::vector<KeyframeEntry> keyframes_;
  std::vector<LandmarkEntry> landmarks_;
  std::vector<RetiredEntry> retired_;
  std::vector<LoopEdge> loops_;
  std::unordered_map<LandmarkId, std::size_t> landmark_index_;
};

}  // namespace glide
