#pragma once

#include "replay/evaluation/accuracy.h"
#include "replay/evaluation/trajectory.h"

#include "geometry/lie.h"

#include <optional>
#include <string>

namespace glide::replay {

/// The three estimates of a run, in one frame of the rig.
struct Estimates {
  Trajectory recomposed, live, keyframes;
};

/// The truth for another frame of the rig; T_body_cam in metres. Without a T_body_cam both are
/// taken as the same.
Trajectory truthInFrame(const GroundTruth& truth,
                        RigFrame frame,
                        const std::optional<SE3d>& T_body_cam);

/// The body's trajectories from the camera's. A monocular trajectory has no unit, so the lever arm
/// is divided by `scale`, the metres per unit that the alignment to the truth found.
Estimates toBody(const Estimates& camera, const SE3d& T_body_cam, double scale);

/// All that stats.json tells about accuracy; truth and estimates are of the same frame of the rig.
Accuracy evaluate(const Trajectory& truth, const Estimates& estimates);

}  // namespace glide::replay
