#include "feature/corner.h"

#include "unit/feature/dead_leaves.h"

#include "feature/fast_corners.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <random>
#include <vector>

namespace glide {
namespace {

constexpr int kBorder = 16;

std::vector<Corner> randomCorners(int width, int height, int count, unsigned seed) {
  std::mt19937 rng(seed);
  std::vector<Corner> corners;
  for (int i = 0; i < count; ++i) {
    corners.push_back({static_cast<int>(rng() % static_cast<unsigned>(width)),
                       static_cast<int>(rng() % static_cast<unsigned>(height)),
                       static_cast<int>(1 + rng() % 254)});
  }
  return corners;
}

int closestPair(const std::vector<Corner>& corners) {
  int closest = std::numeric_limits<int>::max();
  for (std::size_t i = 0; i < corners.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const int dx = std::abs(corners[i].x - corners[j].x);
      const int dy = std::abs(corners[i].y - corners[j].y);
      closest = std::min(closest, std::max(dx, dy));
    }
  }
  return closest;
}

TEST(KeepSpread, KeepsExactlyTheWantedNumberFarFromEachOther) {
  std::vector<Corner> corners = randomCorners(640, 480, 5000, 1);
  keepSpread(640, 480, 300, &corners);
  ASSERT_EQ(corners.size(), 300U);
  // 300 squares of 32 px tile the image; a third of that side between any two is a good spread.
  EXPECT_GE(closestPair(corners), 11);
}

TEST(KeepSpread, KeepsTheStrongestCornerFirst) {
  std::vector<Corner> corners = randomCorners(300, 200, 1000, 2);
  corners[700] = {150, 100, 254};
  for (Corner& c : corners) c.score = std::min(c.score, 253);
  corners[700].score = 254;
  keepSpread(300, 200, 50, &corners);
  ASSERT_EQ(corners.size(), 50U);
  EXPECT_EQ(corners[0].score, 254);
  EXPECT_TRUE(std::is_sorted(corners.begin(), corners.end(), [](const Corner& a, const Corner& b) {
    return a.score > b.score;
  }));
}

TEST(KeepSpread, KeepsAllOfTooFew) {
  std::vector<Corner> corners = randomCorners(300, 200, 40, 3);
  keepSpread(300, 200, 50, &corners);
  EXPECT_EQ(corners.size(), 40U);
}

TEST(KeepSpread, KeepsTheStrongestWhereAllLieOnOnePixel) {
  std::vector<Corner> corners = randomCorners(1, 1, 100, 4);
  keepSpread(300, 200, 10, &corners);
  EXPECT_EQ(corners.size(), 10U);
}

TEST(KeepSpread, KeepsNoneWhenNoneIsWanted) {
  std::vector<Corner> corners = randomCorners(300, 200, 40, 5);
  keepSpread(300, 200, 0, &corners);
  EXPECT_THAT(corners, testing::IsEmpty());
}

TEST(DetectCorners, LowersTheThresholdOnlyWhereNothingElseIsFound) {
  // Strong contrast on the left half, weak contrast on the right.
  const test::DeadLeaves leaves(7);
  const ImageU8 strong = leaves.render(416, 160);
  ImageU8 image = leaves.render(416, 160, Eigen::Matrix2f::Identity(), 0.12F);
  for (int y = 0; y < 160; ++y) std::copy_n(strong.row(y), 208, image.row(y));
  std::vector<Corner> all, corners;
  fastCorners(image.view(), kBorder, 7, &all);
  detectCorners(image.view(), kBorder, {40, 7}, &corners);
  const auto count = [](const std::vector<Corner>& set, bool right, bool weak) {
    return std::count_if(set.begin(), set.end(), [&](const Corner& c) {
      return (c.x >= 208 + kThresholdCell) == right && (c.score < 40) == weak;
    });
  };
  EXPECT_GT(count(all, true, true), 50);
  EXPECT_EQ(count(corners, true, true), count(all, true, true));
  EXPECT_EQ(count(corners, false, false), count(all, false, false));
  EXPECT_LT(count(corners, false, true), count(all, false, true) / 4);
}

TEST(DetectCorners, FindsNoneInAnImageWithoutRoomInsideItsBorders) {
  ImageU8 image(2 * kBorder, 100);
  std::vector<Corner> corners{{1, 2, 3}};
  detectCorners(image.view(), kBorder, {20, 7}, &corners);
  EXPECT_THAT(corners, testing::IsEmpty());
}

}  // namespace
}  // namespace glide
