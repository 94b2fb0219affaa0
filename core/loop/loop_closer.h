#pragma once

#include "map/map_snapshot.h"
#include "map/messages.h"
#include "map/place_index.h"

#include "geometry/camera_model.h"

#include "glide/config.h"

#include <atomic>
#include <memory>
#include <optional>

namespace glide {

/// Recognises places seen before and works out how the map has to be bent so that both ends meet:
/// candidates that several keyframes in a row agree on, Sim(3) by RANSAC on matched landmarks,
/// guided matches, refinement, fusion pairs, pose graph (ALGORITHMS section 4). Owned by the loop
/// thread.
class LoopCloser {
 public:
  LoopCloser(const Config& config, const CameraModel& camera);
  ~LoopCloser();

  /// To be called once for each new keyframe, in order: evidence is gathered over several.
  /// `cancel` (may be null) ends the work early, without a result. Nothing, too, when there is no
  /// loop or not beyond doubt.
  std::optional<LoopCorrection> close(KeyframeId keyframe,
                                      const MapSnapshot& map,
                                      const PlaceIndex& index,
                                      const std::atomic<bool>* cancel);

  /// Forgets the evidence: the map was replaced.
  void reset();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace glide
