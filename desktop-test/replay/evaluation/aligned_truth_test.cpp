#include "replay/evaluation/aligned_truth.h"

#include "replay/evaluation/random_trajectories.h"

#include <gtest/gtest.h>

namespace glide::replay {
namespace {

constexpr std::int64_t kPeriodNs = 50'000'000;

Trajectory partOf(const Trajectory& whole, std::size_t first, std::size_t end) {
  Trajectory part;
  for (std::size_t i = first; i < end; ++i) part.push_back(whole[i]);
  return part;
}

TEST(AlignedTruth, LiesOnTheEstimateWhileItLasts) {
  const Trajectory truth = smoothPath(0, kPeriodNs, 100);
  const Trajectory estimate = partOf(estimateOf(truth, 0.0, 3), 30, 70);
  const auto aligned = alignTruth(truth, estimate);
  ASSERT_TRUE(aligned);
  EXPECT_EQ(aligned->pairs.size(), estimate.size());
  ASSERT_EQ(aligned->path.size(), estimate.size());
  for (std::size_t i = 0; i < estimate.size(); ++i) {
    const SE3d& T_world_rig = aligned->path[i].T_world_rig;
    EXPECT_NEAR((T_world_rig.t - estimate[i].T_world_rig.t).norm(), 0.0, 1e-9);
    EXPECT_NEAR(T_world_rig.q.angularDistance(estimate[i].T_world_rig.q), 0.0, 1e-6);
  }
}

TEST(AlignedTruth, HasTheScaleOfTheEvaluation) {
  const Trajectory truth = smoothPath(0, kPeriodNs, 100);
  const Trajectory estimate = estimateOf(truth, 0.05, 3);
  EXPECT_NEAR(1.0 / alignTruth(truth, estimate)->S_estimate_truth.s,
              absoluteError(truth, estimate)->scale,
              1e-9);
}

TEST(AlignedTruth, IsNothingForPathsThatHaveTooLittleInCommon) {
  const Trajectory truth = smoothPath(0, kPeriodNs, 100);
  EXPECT_FALSE(alignTruth(truth, {}));
  EXPECT_FALSE(alignTruth({}, truth));
  EXPECT_FALSE(alignTruth(truth, partOf(truth, 0, 2)));
}

}  // namespace
}  // namespace glide::replay
