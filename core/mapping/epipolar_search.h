#pragma once

#include "feature/matcher.h"
#include "map/landmark.h"

#include "geometry/lie.h"

#include <span>
#include <vector>

namespace glide {

/// A keyframe as the epipolar search sees it; the three have the same length.
struct EpipolarView {
  const FeatureSet* features = nullptr;
  std::span<const Vec3d> bearings;        ///< unit; zero excludes the feature
  std::span<const LandmarkId> landmarks;  ///< only features without a landmark are matched
};

struct EpipolarOptions {
  double focal_px = 0.0;          ///< pixels per radian
  double min_parallax_rad = 0.0;  ///< between the two rays
  int max_distance = 50;          ///< bits
  double ratio = 0.8;             ///< best over second-best *other* corner in the same plane
};

/// Features of `a` to features of `b` that lie in the same half plane through the baseline (the
/// epipolar constraint on bearings: valid for every lens), whose rays meet in front of both cameras
/// with enough parallax, and whose scale, orientation and descriptor agree. One to one, ascending
/// `a`. O(features) by binning the plane angle. docs/algorithms/local-mapping.md.
std::vector<Match> matchAlongEpipolarPlanes(const EpipolarView& a,
                                            const EpipolarView& b,
                                            const SE3d& T_b_a,
                                            const EpipolarOptions& options,
                                            const ScaleLevels& levels);

}  // namespace glide
