#include "feature/orientation_filter.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace glide {
namespace {

constexpr float kPi = 3.14159265F;

FeatureSet withAngles(const std::vector<float>& angles) {
  std::vector<Feature> features(angles.size());
  for (std::size_t i = 0; i < angles.size(); ++i) features[i].angle = angles[i];
  return FeatureSet(std::move(features), std::vector<Descriptor>(angles.size()), 10, 10);
}

std::vector<Match> oneToOne(int count) {
  std::vector<Match> matches;
  for (int i = 0; i < count; ++i) matches.push_back({i, i, 0});
  return matches;
}

class OrientationFilter : public testing::TestWithParam<float> {};

TEST_P(OrientationFilter, KeepsMatchesThatTurnTogetherAndDropsTheOthers) {
  std::mt19937 rng(1);
  std::uniform_real_distribution<float> any(-kPi, kPi), scatter(-0.2F, 0.2F);
  std::vector<float> a, b;
  for (int i = 0; i < 100; ++i) {
    a.push_back(any(rng));
    const float odd = 0.8F + 0.1F * static_cast<float>(i - 60);
    const float turn = GetParam() + (i < 60 ? scatter(rng) : odd);
    b.push_back(std::remainder(a.back() + turn, 2.0F * kPi));
  }
  std::vector<Match> matches = oneToOne(100);
  keepConsistentRotation(withAngles(a), withAngles(b), &matches);
  std::vector<int> kept;
  for (const Match& m : matches) kept.push_back(m.a);
  for (int i = 0; i < 60; ++i) EXPECT_THAT(kept, testing::Contains(i));
  EXPECT_EQ(kept.size(), 60U);
}

INSTANTIATE_TEST_SUITE_P(ByAngle,
                         OrientationFilter,
                         testing::Values(-3.1F, -1.0F, 0.0F, 0.7F, kPi));

TEST(OrientationFilterOnce, LeavesNothingOfNothing) {
  std::vector<Match> matches;
  keepConsistentRotation(FeatureSet(), FeatureSet(), &matches);
  EXPECT_THAT(matches, testing::IsEmpty());
}

}  // namespace
}  // namespace glide
