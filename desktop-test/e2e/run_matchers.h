#pragma once

#include "e2e/synthetic_run.h"

#include <gmock/gmock.h>

namespace glide::test {

inline constexpr double kMinDirectShare = 0.7;
/// 2 mm at 1.5 m.
inline constexpr double kMaxAtePerDepth = 0.002 / 1.5;

/// A run with a first pose, tracked from there to its end.
MATCHER(IsTrackedToTheEnd, "is tracked from the first pose to the end") {
  *result_listener << describe(arg);
  return firstPose(arg) < static_cast<int>(arg.results.size()) && untracked(arg) == 0;
}

/// A run whose final poses are right to 2 mm at 1.5 m, in proportion at other depths.
MATCHER_P(IsAccurateAtDepth, depth_m, "has an ATE under 2 mm per 1.5 m of depth") {
  *result_listener << describe(arg);
  return evaluate(arg).ate_rmse_m < kMaxAtePerDepth * depth_m;
}

/// A run in which the direct tracker does its share.
MATCHER(IsMostlyDirect, "has a direct share of at least 0.7") {
  *result_listener << describe(arg);
  return directShare(arg) >= kMinDirectShare;
}

}  // namespace glide::test
