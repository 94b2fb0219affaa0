#pragma once

#include "geometry/epipolar_refine.h"
#include "geometry/lie.h"
#include "geometry/ray_pair.h"

#include <span>

namespace glide {

/// One possible relative pose and how well the pairs support it.
struct PoseHypothesis {
  SE3d T_b_a;                  ///< translation of unit length
  double direction_std = 0.0;  ///< see RefinedPose
  double score = 0.0;          ///< sum of 95 % quantile - error^2 / sigma^2 over inliers not behind
  int inliers = 0;             ///< Sampson error within the 95 % quantile
  int front = 0,
      behind = 0;  ///< inliers with parallax, by whether their rays meet before both cameras
};

/// Angle between the two rays of a pair once the rotation is undone: the parallax at its point.
double rayParallax(const Eigen::Quaterniond& q_b_a, const RayPair& pair);

/// True when that angle stands clear of the pixels' noise, so that the depth means something.
bool hasParallax(const Eigen::Quaterniond& q_b_a, const RayPair& pair, double sigma_px);

/// The best supported one of the four poses that share the refined pose's essential matrix.
PoseHypothesis bestOfFourPoses(const RefinedPose& refined,
                               std::span<const RayPair> pairs,
                               double sigma_px);

}  // namespace glide
