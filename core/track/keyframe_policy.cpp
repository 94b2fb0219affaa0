#include "track/keyframe_policy.h"

namespace glide {

bool wantsKeyframe(const Config::Keyframes& config, const KeyframeEvidence& evidence) {
  const bool moved = evidence.baseline >= config.min_baseline;
  const bool losing_landmarks =
      evidence.tracked_landmarks < config.min_tracked_ratio * evidence.reference_landmarks;
  // Too few landmarks to wait for the interval; without a baseline nothing could be triangulated.
  const bool urgent = evidence.tracked_landmarks < config.min_tracked &&
                      evidence.baseline > 0.25 * config.min_baseline;
  if (urgent) return evidence.frames_since_keyframe > 0;
  if (evidence.frames_since_keyframe < config.min_interval) return false;
  if (evidence.frames_since_keyframe >= config.max_interval) return moved || losing_landmarks;
  return moved && losing_landmarks;
}

}  // namespace glide
