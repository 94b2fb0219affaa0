#pragma once

#include "geometry/lie.h"

#include "glide/result.h"

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace glide::replay {

/// Which frame of the rig a trajectory tells the pose of.
enum class RigFrame { camera, body };

/// Pose of the rig in the world at a time.
struct StampedPose {
  std::int64_t t_ns = 0;
  SE3d T_world_rig;
};

using Trajectory = std::vector<StampedPose>;

/// A reference trajectory in metres, sorted by time.
struct GroundTruth {
  Trajectory poses;
  RigFrame rig = RigFrame::camera;
};

/// Reads TUM text ("s tx ty tz qx qy qz qw", the camera's poses) or EuRoC csv ("ns,px,py,pz,
/// qw,qx,qy,qz,...", the body's). io naming file and line.
Result<GroundTruth> readGroundTruth(const std::filesystem::path& file);

/// TUM text: seconds with nine decimals, then translation and quaternion (x, y, z, w).
std::string tumText(const Trajectory& trajectory);

/// The trajectory of another frame b of the same rig: T_world_b = T_world_rig * T_rig_b.
Trajectory inFrame(const Trajectory& trajectory, const SE3d& T_rig_b);

}  // namespace glide::replay
