#pragma once

#include "geometry/ray_pair.h"

#include <cstdint>
#include <span>

namespace glide {

/// What RANSAC needs to know of its data.
struct TwoViewRansacOptions {
  double sigma_px = 1.0;
  int max_iterations = 200;
  std::uint64_t seed = 1;
};

/// Best models of both kinds. A score sums max(0, quantile - error^2 / sigma^2) over the pairs,
/// with the 95 % quantile of the model's degrees of freedom.
struct TwoViewModels {
  Mat3d E = Mat3d::Zero();
  Mat3d H = Mat3d::Zero();
  double score_E = 0.0, score_H = 0.0;
  int inliers_E = 0, inliers_H = 0;
};

/// Essential matrix (five pairs) and homography (the first four of them) from the same samples;
/// ends early when a better sample has become unlikely. The homography is polished on its inliers.
TwoViewModels ransacTwoView(std::span<const RayPair> pairs, const TwoViewRansacOptions& options);

/// Score and inliers of one model, in the sense of TwoViewModels.
struct ModelScore {
  double score = 0.0;
  int inliers = 0;
};
ModelScore scoreEssential(const Mat3d& E, std::span<const RayPair> pairs, double sigma_px);
ModelScore scoreHomography(const Mat3d& H, std::span<const RayPair> pairs, double sigma_px);

}  // namespace glide
