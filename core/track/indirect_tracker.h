#pragma once

#include "track/tracked_frame.h"

#include "feature/orb_extractor.h"
#include "map/local_map.h"
#include "optimize/landmark_search.h"

#include "image/image.h"

#include <memory>
#include <span>
#include <vector>

namespace glide {

/// How far the true pose may be from the guess.
enum class GuessQuality {
  aligned,    ///< by the direct tracker: a few pixels
  predicted,  ///< by the motion model: tens of pixels
  lost,       ///< frames were lost since: it may be anywhere, and is believed on more evidence only
};

/// What the indirect tracker starts from.
struct IndirectGuess {
  SE3d T_cam_world;
  GuessQuality quality = GuessQuality::predicted;
  KeyframeId reference;  ///< keyframe to fall back on
};

/// Feature tracking of one frame against the local map. Depends on nothing but its arguments, so
/// any thread may call it; one thread per instance.
class IndirectTracker {
 public:
  IndirectTracker(const Config& config, const CameraModel& camera);

  /// Extracts the features of the frame's pixels and tracks them.
  TrackedFrame track(const Frame& frame, const ImageViewU8& luma, const IndirectGuess& guess);

  /// Tracks features that are there already. ok when enough landmarks agree with the pose; then
  /// landmarks and sightings are filled.
  TrackedFrame track(const Frame& frame,
                     const std::shared_ptr<const FeatureSet>& features,
                     const IndirectGuess& guess);

  /// Features alone, for the initializer.
  std::shared_ptr<const FeatureSet> extract(const ImageViewU8& luma, int count);

 private:
  struct Attempt {
    LandmarkMatches matches;
    PoseEstimate pose;
  };

  void useCameraOf(const MapSnapshot& map);
  Attempt searchAround(const Frame& frame, const FeatureSet& features, const IndirectGuess& guess);
  Attempt recover(const Frame& frame, const FeatureSet& features, const IndirectGuess& guess);
  /// Adds what the local map expects in view.
  LocalMap widen(const Frame& frame, const FeatureSet& features, Attempt* attempt);
  /// Sub-pixel corners, and the pose from them.
  std::shared_ptr<const FeatureSet> alignCorners(const Frame& frame,
                                                 const std::shared_ptr<const FeatureSet>& features,
                                                 Attempt* attempt) const;
  /// Landmarks to look for first.
  std::vector<const MapSnapshot::LandmarkEntry*> seeds(const MapSnapshot& map,
                                                       const IndirectGuess& guess) const;
  bool isEnough(const TrackedFrame& tracked, GuessQuality quality) const;
  void report(const Frame& frame,
              const Attempt& attempt,
              const LocalMap& local,
              TrackedFrame* tracked) const;

  Config config_;
  const CameraModel given_camera_;
  CameraModel camera_;  ///< of the map that the frame is tracked in
  OrbExtractor extractor_;
  ScaleLevels levels_;
  LandmarkSearch search_;
  std::vector<LandmarkId> recent_;  ///< landmarks of the last frame that was tracked
};

}  // namespace glide
