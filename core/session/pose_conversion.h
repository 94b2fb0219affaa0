#pragma once

#include "geometry/lie.h"

#include "glide/types.h"

namespace glide {

/// The public, Eigen-free form of a transform.
inline Pose toPose(const SE3d& T) {
  return {{T.t.x(), T.t.y(), T.t.z()}, {T.q.x(), T.q.y(), T.q.z(), T.q.w()}};
}

}  // namespace glide
