#pragma once

#include "track/anchored_pose.h"

#include <cstdint>
#include <optional>

namespace glide {

/// Constant velocity: the motion between the last two tracked frames, scaled by time, goes on.
class MotionModel {
 public:
  /// Pose expected at `t_ns` in the world of `map`; nothing before the first update().
  std::optional<SE3d> predict(std::int64_t t_ns, const MapSnapshot& map) const;

  /// A frame was tracked.
  void update(std::int64_t t_ns, const AnchoredPose& pose, const MapSnapshot& map);

  /// A frame was not tracked: the camera is expected to stay where it was seen last.
  void stop() { velocity_.setZero(); }

  /// Forgets everything.
  void reset() { *this = MotionModel(); }

 private:
  std::optional<AnchoredPose> last_;
  std::int64_t last_t_ns_ = 0;
  double velocity_growth_ = 1.0;    ///< AnchoredPose::growth when the velocity was measured
  Vec6d velocity_ = Vec6d::Zero();  ///< twist of T_now_before per second, (translation, rotation)
};

}  // namespace glide
