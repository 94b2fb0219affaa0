#pragma once

#include "synthetic/scene.h"

#include "geometry/lie.h"

namespace glide::synthetic {

enum class MotionKind {
  handheld,  ///< sideways to and fro with revisits and a little tremor; starts with clear
             ///< translation
  sweep,     ///< wide sideways travel and back, looking ahead
  orbit,     ///< around the scene's centre, looking at it
  corridor,  ///< along the optical axis with some sway
  walk,      ///< along the scene's way; only where there is one
  rotation,  ///< turning on the spot
  still,     ///< standing still
};

/// A smooth camera path through a scene; distances scale with the viewpoint's depth.
struct Motion {
  MotionKind kind = MotionKind::handheld;
  double speed = 1.0;         ///< factor on time
  double turn_first_s = 0.0;  ///< seconds of pure rotation before the motion begins
  double pause_begin_s = 0.0, pause_end_s = 0.0;  ///< the camera stands still in between
};

/// Pose at a time in seconds; world and metres of the scene. Smooth but for the instant after the
/// turn, when the camera sets off at once; at a pause it slows down and speeds up within half a
/// second.
SE3d poseAt(const Motion& motion, const Viewpoint& viewpoint, double t_s);

}  // namespace glide::synthetic
