#pragma once

#include "track/direct_tracker.h"

#include "photometric/point_residuals.h"

#include "geometry/camera_model.h"
#include "image/image.h"

#include "glide/config.h"
#include "glide/frame.h"

#include <vector>

namespace glide {

/// Session::trackedPoints: which landmarks a frame was tracked by. Owned by the thread of
/// Session::update.
class PointReporter {
 public:
  PointReporter(const Config::Direct& config, const CameraModel& camera);

  /// A frame that the indirect tracker has tracked: the matches that agree with its pose.
  void reportMatches(const Frame& frame,
                     const TrackedFrame& tracked,
                     std::vector<TrackedPoint>* points) const;

  /// The frame with these pixels has become the direct tracker's reference.
  void setReference(const ImageViewU8& luma, const DirectTracker& tracker);
  /// The direct tracker has tracked the frame with these pixels.
  void reportAlignment(const ImageViewU8& luma,
                       const DirectTracker& tracker,
                       std::vector<TrackedPoint>* points);

 private:
  const CameraModel camera_;  ///< as given: what the direct tracker works with
  PointResiduals residuals_;
};

}  // namespace glide
