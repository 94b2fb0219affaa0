#pragma once

#include "geometry/lie.h"

#include "glide/types.h"

namespace glide {

/// The public, Eigen-free form of a transform.
inline Pose toPose(const SE3d& T) {
  return {{T.t.x(), T.t.y(), T.t.z()}, {T.q.x(), T.q.y(), T.q.z(), T.q.w()}};
}

/// The transform behind a public pose.
inline SE3d fromPose(const Pose& pose) {
  const auto& q = pose.q_xyzw;
  return {Eigen::Quaterniond(q[3], q[0], q[1], q[2]),
          Vec3d(pose.t_xyz[0], pose.t_xyz[1], pose.t_xyz[2])};
}

}  // namespace glide
