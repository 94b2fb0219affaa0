#include "track/switch_policy.h"

#include <algorithm>
#include <numbers>

namespace glide {
namespace {

constexpr double kDegPerRad = 180.0 / std::numbers::pi;

bool errorTooHigh(const Config::Direct& config, const AlignResult& align) {
  if (align.rms > config.max_rms) return true;
  return align.rms > config.max_rms_contrast * align.contrast;
}

/// Perspective raises the error slowly from frame to frame; a jump is a solve that ended elsewhere.
/// Errors below the Huber floor are noise, whose ratio says nothing.
bool errorJumped(const Config::Direct& config, const DirectEvidence& evidence) {
  if (evidence.last_rms <= 0.0) return false;
  const double before = std::max(evidence.last_rms, config.huber_floor);
  return evidence.align.rms > config.max_rms_growth * before;
}

/// The camera is suddenly somewhere else and the patches fit worse there: a solve that ended in the
/// next repetition of a facade. Neither alone says so, as hands jerk and views change.
bool endedElsewhere(const Config::Direct& config, const DirectEvidence& evidence) {
  constexpr double kGrowth = 1.3;  // of the patch error from one frame to the next: not perspective
  constexpr double kFactor = 4.0;  // what is usual is the largest of late already
  constexpr double kSmall = 0.005;  // some pixels: the noise of a slow camera's prediction
  if (evidence.last_rms <= 0.0) return false;
  const double before = std::max(evidence.last_rms, config.huber_floor);
  return evidence.align.rms > kGrowth * before &&
         evidence.surprise > kFactor * std::max(evidence.usual_surprise, kSmall);
}

/// The gain ran into its limits: the frame holds something else than the reference.
bool isImplausibleGain(const AlignResult& align) {
  constexpr double kMin = 0.22;  // just inside of the aligner's clamp of 0.2 to 5
  constexpr double kMax = 4.5;
  return align.gain < kMin || align.gain > kMax;
}

bool tooFewVisible(const Config::Direct& config, const AlignResult& align) {
  return align.visible < config.min_visible_ratio * align.points;
}

}  // namespace

SwitchReason decideSwitch(const Config::Direct& config, const DirectEvidence& evidence) {
  const AlignResult& align = evidence.align;
  if (evidence.direct_frames >= config.max_direct_frames) return SwitchReason::max_direct_frames;
  if (!align.valid) return SwitchReason::solve_failed;
  if (tooFewVisible(config, align)) return SwitchReason::too_few_visible;
  if (errorTooHigh(config, align) || errorJumped(config, evidence) || isImplausibleGain(align) ||
      endedElsewhere(config, evidence))
    return SwitchReason::photometric_error;
  if (align.inliers < config.min_inlier_ratio * align.visible)
    return SwitchReason::photometric_error;
  const double baseline = align.T_cam_ref.t.norm() / std::max(evidence.median_depth, 1e-9);
  if (baseline > config.max_baseline) return SwitchReason::baseline;
  const double rotation_deg = so3Log(align.T_cam_ref.q).norm() * kDegPerRad;
  if (rotation_deg > config.max_rotation_deg) return SwitchReason::rotation;
  return SwitchReason::none;
}

}  // namespace glide
