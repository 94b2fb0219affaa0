#pragma once

#include "geometry/lie.h"

#include <array>
#include <vector>

namespace glide {

/// Three world points and the unit bearings at which a camera sees them.
struct PointBearings {
  std::array<Vec3d, 3> p_world;
  std::array<Vec3d, 3> bearing;
};

/// All poses T_cam_world (at most four) under which the points lie on their bearings, in front of
/// the camera. Grunert 1841, in the form of Haralick et al., "Review and analysis of solutions of
/// the three point perspective pose estimation problem", IJCV 1994; distances are polished by
/// Newton's method. None for collinear points.
std::vector<SE3d> solveP3p(const PointBearings& points);

}  // namespace glide
