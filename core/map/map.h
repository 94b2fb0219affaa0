#pragma once

#include "map/covisibility.h"
#include "map/keyframe.h"
#include "map/landmark.h"
#include "map/messages.h"

#include <cstddef>
#include <map>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

namespace glide {

/// Keyframes, landmarks and who sees what. Owned by the mapping thread, no mutex. Its methods keep
/// the observations consistent both ways and the covisibility in step with them. Ids ascend for the
/// life of the object, also across clear().
class Map {
 public:
  explicit Map(const ScaleLevels& levels) : levels_(levels) {}

  const ScaleLevels& levels() const { return levels_; }
  const std::map<KeyframeId, Keyframe>& keyframes() const { return keyframes_; }
  const std::map<KeyframeId, RetiredKeyframe>& retired() const { return retired_; }
  std::size_t landmarkCount() const { return landmarks_.size(); }
  std::vector<LandmarkId> landmarkIds() const;  ///< ascending
  const Covisibility& covisibility() const { return covisibility_; }
  const std::vector<LoopEdge>& loops() const { return loops_; }  ///< in the order of closing

  /// Null when there is no such thing (any more).
  const Keyframe* keyframe(KeyframeId id) const;
  const Landmark* landmark(LandmarkId id) const;

  /// Pose of a keyframe, living or retired.
  std::optional<SE3d> T_cam_world(KeyframeId id) const;
  /// Keyframe::scale of a keyframe, living or retired.
  std::optional<double> scale(KeyframeId id) const;

  /// False when the id is taken. The keyframe starts without observations, whatever `landmarks`
  /// says.
  bool addKeyframe(Keyframe keyframe);

  /// A landmark without observations; the caller adds two at once.
  LandmarkId addLandmark(const Vec3d& p_world, KeyframeId first_keyframe);

  /// False, and nothing changed, when landmark or keyframe is gone, the feature does not exist or
  /// holds a landmark, or the keyframe sees the landmark already.
  bool addObservation(LandmarkId id, const Observation& observation);

  /// Puts back a landmark as a snapshot recorded it: id, observations, summary and counts; new ids
  /// go on above it. False, and nothing changed, when the id is not above those that are there or
  /// an observation is impossible.
  bool restoreLandmark(Landmark landmark);

  /// Puts back a retired keyframe. False when the id is taken or the parent does not live.
  bool restoreRetired(const RetiredKeyframe& keyframe);

  /// A landmark that is left with fewer than two observations is removed.
  void removeObservation(LandmarkId id, KeyframeId keyframe);

  void removeLandmark(LandmarkId id);

  /// Fuses: `by` takes over the observations of `id` (except in keyframes that see it already) and
  /// its counts; `id` is removed.
  void replaceLandmark(LandmarkId id, LandmarkId by);

  /// Takes the keyframe and its observations out; its pose stays defined relative to its best
  /// covisible neighbour (else the next older or newer keyframe). False for the last keyframe and
  /// unknown ids.
  bool retireKeyframe(KeyframeId id);

  /// Drops everything, retired keyframes too.
  void clear();

  /// Both keyframes live; the edge moves to the parent when one of them is retired.
  void addLoopEdge(const LoopEdge& edge) { loops_.push_back(edge); }

  void setPose(KeyframeId id, const SE3d& T_cam_world);
  /// Moves the keyframe, and what is relative to it, by a similarity of the world: its pose, its
  /// scale and the retired keyframes that hang on it. Landmarks stay.
  void moveKeyframe(const KeyframeMove& move);
  /// Replaces the keyframe's features by a copy in which some corners lie elsewhere.
  void moveFeatures(KeyframeId id, std::span<const FeatureMove> moves);
  void setPosition(LandmarkId id, const Vec3d& p_world);
  void countSighting(const LandmarkSighting& sighting);  ///< ignored when the landmark is gone

  /// Normal and scale range from the present poses.
  void refreshGeometry(LandmarkId id);

  /// Descriptor, normal and scale range of the landmarks whose observations changed since the last
  /// call.
  void refreshChanged();

 private:
  const ScaleLevels levels_;
  std::map<KeyframeId, Keyframe> keyframes_;
  std::map<KeyframeId, RetiredKeyframe> retired_;  // parents are always living
  std::unordered_map<LandmarkId, Landmark> landmarks_;
  std::vector<LandmarkId> created_;  // ascending, some of them dead: the order of landmarks_
  std::vector<LandmarkId> changed_;  // observations changed, may repeat, some of them dead
  Covisibility covisibility_;
  std::vector<LoopEdge> loops_;
  LandmarkId next_landmark_{0};

  Landmark* find(LandmarkId id);
  void detach(Landmark* landmark, std::vector<Observation>::iterator observation);
  KeyframeId parentFor(KeyframeId id) const;
  void refreshDescriptor(Landmark* landmark) const;
};

}  // namespace glide
