#pragma once

#include "photometric/align_types.h"

#include "glide/config.h"

namespace glide {

/// What the decision about a direct frame rests on.
struct DirectEvidence {
  AlignResult align;
  int direct_frames = 0;      ///< frames already accepted against this reference
  double median_depth = 1.0;  ///< of the reference's points, scene units
  double last_rms = 0.0;      ///< of the last accepted frame, grey levels; 0 before the first
  /// Distance of the pose from the one that the motion model expected: translation over median
  /// depth plus radians, about the share of the focal length by which points are seen elsewhere.
  double surprise = 0.0;
  double usual_surprise = 0.0;  ///< the largest of late
};

/// SwitchReason::none accepts the direct pose; anything else says why the frame goes to the
/// indirect tracker (paper, section III-D; ALGORITHMS section 2).
SwitchReason decideSwitch(const Config::Direct& config, const DirectEvidence& evidence);

}  // namespace glide
