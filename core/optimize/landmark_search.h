#pragma once

#include "feature/feature_set.h"
#include "feature/matcher.h"
#include "map/map_snapshot.h"
#include "optimize/pose_optimizer.h"

#include "geometry/camera_model.h"

#include "glide/config.h"

#include <span>
#include <vector>

namespace glide {

/// Which features of a frame see which landmarks, and where the camera is: grows in rounds of
/// projection search and motion-only optimisation.
struct LandmarkMatches {
  std::vector<const MapSnapshot::LandmarkEntry*> of_feature;  ///< per feature; null where none
  int count = 0;
};

/// Projection search (ALGORITHMS section 4, "Tracking"): landmarks that a camera at `T_cam_world`
/// should see are looked for around their projections, at the predicted scale, with the descriptor
/// deciding.
class LandmarkSearch {
 public:
  LandmarkSearch(const Config& config, const CameraModel& camera);

  /// From now on the map is that of another camera.
  void useCamera(const CameraModel& camera) { camera_ = camera; }

  struct Request {
    SE3d T_cam_world;
    double radius_px = 0.0;  ///< at scale level 0
    int max_distance = 0;    ///< descriptor bits
  };

  /// Adds matches for landmarks that have none yet, to features that have none yet. Returns how
  /// many of `landmarks` are in view.
  int extend(std::span<const MapSnapshot::LandmarkEntry* const> landmarks,
             const FeatureSet& features,
             const Request& request,
             LandmarkMatches* matches);

  /// Motion-only optimisation over the matches; the ones that disagree are taken back.
  PoseEstimate refine(const SE3d& T_cam_world_guess,
                      const FeatureSet& features,
                      LandmarkMatches* matches) const;

  /// Landmarks in view that the last extend() calls since beginFrame() expected.
  const std::vector<const MapSnapshot::LandmarkEntry*>& visible() const { return visible_; }
  void beginFrame() { visible_.clear(); }

 private:
  bool project(const MapSnapshot::LandmarkEntry& landmark,
               const Request& request,
               ProjectedTarget* target) const;

  Config config_;
  CameraModel camera_;
  ScaleLevels levels_;
  std::vector<const MapSnapshot::LandmarkEntry*> visible_;
};

}  // namespace glide
