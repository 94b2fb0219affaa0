#pragma once

#include "map/keyframe.h"
#include "map/landmark.h"
#include "map/messages.h"

#include "geometry/camera_model.h"

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

/// How far the k1 of the camera that made a map may be from the calibration that was given: more is
/// not the rest of a distortion but another lens.
inline constexpr double kMaxRadialCorrection = 0.15;

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

  struct Parts {
    std::uint64_t revision = 0;
    std::uint64_t generation = 0;               ///< see generation()
    std::uint64_t corrections = 0;              ///< see corrections()
    std::vector<KeyframeEntry> keyframes;       ///< ascending id
    std::vector<LandmarkEntry> landmarks;       ///< ascending id
    std::vector<RetiredEntry> retired;          ///< ascending id
    std::vector<LoopEdge> loops;                ///< in the order of closing
    std::shared_ptr<const CameraModel> camera;  ///< see cameraOr(); null: as given
  };

  MapSnapshot() = default;  ///< empty, revision 0
  explicit MapSnapshot(Parts parts);

  std::uint64_t revision() const { return parts_.revision; }
  /// Changes when the map is replaced by another (a new start, a file): ids begin to mean something
  /// else.
  std::uint64_t generation() const { return parts_.generation; }
  /// Counts loop corrections and global adjustments: the world has moved under the camera.
  std::uint64_t corrections() const { return parts_.corrections; }
  /// The camera that made this map: the one that was given, unless the map has corrected it.
  const CameraModel& cameraOr(const CameraModel& given) const {
    return parts_.camera ? *parts_.camera : given;
  }
  /// Null when it is as given.
  const std::shared_ptr<const CameraModel>& correctedCamera() const { return parts_.camera; }
  bool empty() const { return parts_.keyframes.empty(); }
  const std::vector<KeyframeEntry>& keyframes() const { return parts_.keyframes; }
  const std::vector<LandmarkEntry>& landmarks() const { return parts_.landmarks; }
  const std::vector<RetiredEntry>& retired() const { return parts_.retired; }
  const std::vector<LoopEdge>& loops() const { return parts_.loops; }

  /// Null when the map has no such thing (any more).
  const KeyframeEntry* keyframe(KeyframeId id) const;
  const LandmarkEntry* landmark(LandmarkId id) const;

  /// Pose of a keyframe, living or retired.
  std::optional<SE3d> T_cam_world(KeyframeId id) const;
  /// Keyframe::scale of a keyframe, living or retired.
  std::optional<double> scale(KeyframeId id) const;

 private:
  Parts parts_;
  std::unordered_map<LandmarkId, std::size_t> landmark_index_;
};

}  // namespace glide
