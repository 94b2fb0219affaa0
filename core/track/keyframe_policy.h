#pragma once

#include "glide/config.h"

namespace glide {

/// What the decision about a keyframe rests on.
struct KeyframeEvidence {
  int frames_since_keyframe = 0;
  int tracked_landmarks = 0;    ///< matched in this frame
  int reference_landmarks = 0;  ///< of the reference keyframe
  double baseline = 0.0;        ///< distance to the reference keyframe over the median depth
};

/// Whether an indirect frame should become a keyframe: the view is losing its landmarks or has
/// moved far enough to triangulate new ones. A camera that stands still never adds one.
bool wantsKeyframe(const Config::Keyframes& config, const KeyframeEvidence& evidence);

}  // namespace glide
