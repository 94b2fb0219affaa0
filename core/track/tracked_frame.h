#pragma once

#include "track/anchored_pose.h"

#include "feature/feature_set.h"
#include "map/messages.h"

#include "glide/frame.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace glide {

/// A frame on its way through the trackers.
struct Frame {
  std::int64_t t_ns = 0;
  std::shared_ptr<const MapSnapshot> map;
};

/// What a tracker found out about a frame.
struct TrackedFrame {
  TrackerKind tracker = TrackerKind::none;
  SwitchReason switch_reason = SwitchReason::no_reference;
  bool ok = false;
  SE3d T_cam_world;  ///< finite guess even when not ok
  AnchoredPose pose;
  double confidence = 0.0;
  FrameStats stats;

  // Indirect frames only: what they saw.
  std::shared_ptr<const FeatureSet> features;
  std::vector<LandmarkId> landmarks;  ///< per feature
  std::vector<LandmarkSighting> sightings;
  double median_depth = 1.0;  ///< of the matched landmarks, scene units
  int tracked_landmarks = 0;
  int reference_landmarks = 0;  ///< of the reference keyframe
};

}  // namespace glide
