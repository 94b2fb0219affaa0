#pragma once

#include "loop/landmark_matching.h"

#include "map/landmark.h"
#include "map/map_snapshot.h"

#include "geometry/camera_model.h"
#include "geometry/lie.h"

#include <optional>
#include <vector>

namespace glide {

/// How a keyframe lies to a place seen before, and what speaks for it.
struct LoopGeometry {
  KeyframeId newer, older;
  Sim3d S_newer_older;  ///< between the cameras, each in the unit of its surroundings
  std::vector<LandmarkMatch> matches;  ///< features of the newer with landmarks around the older
  double agreeing_share = 0.0;         ///< of the matches by look that the similarity explains
  int pairs = 0;                       ///< landmarks of both sides that agree in both images
  int cells = 0;                       ///< sixteenths of the newer's image with a match
  double share_newer = 0.0;            ///< matched of the old landmarks the newer should see
  double share_older = 0.0;            ///< matched of the newer's landmarks the older should see
};

/// Works out the similarity between two keyframes that look alike: landmarks matched by look,
/// RANSAC, matches guided by projection, refinement (ALGORITHMS section 4).
class LoopVerifier {
 public:
  LoopVerifier(const CameraModel& camera, const ScaleLevels& levels)
      : camera_(camera), levels_(levels) {}

  /// Nothing when no similarity explains a minimum of landmarks.
  std::optional<LoopGeometry> verify(const MapSnapshot::KeyframeEntry& newer,
                                     const MapSnapshot::KeyframeEntry& older,
                                     const MapSnapshot& map) const;

 private:
  CameraModel camera_;
  ScaleLevels levels_;
};

/// Whether what speaks for a loop suffices: a wrong loop ruins the map, a missed one comes again.
bool isBeyondDoubt(const LoopGeometry& geometry);

}  // namespace glide
