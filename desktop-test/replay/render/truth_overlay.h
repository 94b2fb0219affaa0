#pragma once

#include "replay/evaluation/trajectory.h"
#include "replay/outputs/run_record.h"

#include "glide/types.h"

#include <memory>
#include <vector>

namespace glide::replay {

/// Lays the ground truth over the map while it grows: the truth has metres and a world of its own,
/// so the similarity that brings it nearest to the frames so far is found again and again.
class TruthOverlay {
 public:
  /// The truth of the camera; empty when there is none.
  explicit TruthOverlay(Trajectory truth) : truth_(std::move(truth)) {}

  void add(const FrameRecord& frame);
  /// Poses of the camera from the first tracked frame to the last, in the map's world; nothing
  /// while the frames have too little in common with the truth to be aligned.
  std::vector<Pose> alignedTo(const std::shared_ptr<const MapView>& map);

 private:
  Trajectory truth_;
  RunRecord run_;  ///< the frames so far, and the map
};

}  // namespace glide::replay
