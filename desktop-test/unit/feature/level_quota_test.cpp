#include "feature/level_quota.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numeric>
#include <vector>

namespace glide {
namespace {

int total(const std::vector<int>& quotas) {
  return std::accumulate(quotas.begin(), quotas.end(), 0);
}

TEST(LevelQuotas, FallGeometricallyAndSumToTheCount) {
  const std::vector<int> quotas = levelQuotas(1000, 1.2, std::vector<int>(8, 5000));
  EXPECT_EQ(total(quotas), 1000);
  for (std::size_t l = 1; l + 1 < quotas.size(); ++l) {
    EXPECT_NEAR(quotas[l - 1], 1.2 * quotas[l], 2.5);
  }
}

TEST(LevelQuotas, GiveWhatALevelLacksToTheOthers) {
  const std::vector<int> found{20, 500, 0, 500};
  const std::vector<int> quotas = levelQuotas(400, 1.2, found);
  EXPECT_EQ(total(quotas), 400);
  EXPECT_EQ(quotas[0], 20);
  EXPECT_EQ(quotas[2], 0);
  EXPECT_GT(quotas[1], quotas[3]);
  EXPECT_GT(quotas[3], 100);
}

TEST(LevelQuotas, TakeEverythingWhenThereIsTooLittle) {
  EXPECT_THAT(levelQuotas(100, 1.2, std::vector<int>{10, 0, 20}), testing::ElementsAre(10, 0, 20));
}

TEST(LevelQuotas, AreNoneWithoutLevelsOrWithoutCorners) {
  EXPECT_THAT(levelQuotas(100, 1.2, {}), testing::IsEmpty());
  EXPECT_THAT(levelQuotas(100, 1.2, std::vector<int>{0, 0}), testing::ElementsAre(0, 0));
}

}  // namespace
}  // namespace glide
