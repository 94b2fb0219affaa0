#include "render/scene_array.h"

#include <gtest/gtest.h>

namespace glide::test {
namespace {

SceneArray<int> uploaded(std::vector<int> items) {
  SceneArray<int> array;
  array.assign(std::move(items));
  array.markUploaded();
  return array;
}

TEST(SceneArray, IsAllNewAtFirst) {
  SceneArray<int> array;
  EXPECT_FALSE(array.isChanged());
  array.assign({1, 2});
  EXPECT_TRUE(array.isChanged());
  EXPECT_EQ(array.changedFrom(), 0U);
}

TEST(SceneArray, AppendsWithoutTouchingWhatIsThere) {
  SceneArray<int> array = uploaded({1, 2, 3});
  EXPECT_FALSE(array.isChanged());
  array.append(4);
  array.append(5);
  EXPECT_EQ(array.changedFrom(), 3U);
  EXPECT_EQ(array.size(), 5U);
}

TEST(SceneArray, TheSameItemsAgainAreNoChange) {
  SceneArray<int> array = uploaded({1, 2, 3});
  array.assign({1, 2, 3});
  EXPECT_FALSE(array.isChanged());
}

TEST(SceneArray, ChangesFromTheFirstItemThatDiffers) {
  SceneArray<int> array = uploaded({1, 2, 3, 4});
  array.assign({1, 2, 7, 4, 5});
  EXPECT_EQ(array.changedFrom(), 2U);
  array.assign({1, 2, 3, 4, 5});  // what was uploaded is not remembered
  EXPECT_EQ(array.changedFrom(), 2U);
}

TEST(SceneArray, WhatIsLeftOfALongerOneIsNoChange) {
  SceneArray<int> array = uploaded({1, 2, 3});
  array.assign({1});
  EXPECT_FALSE(array.isChanged());
  array.append(2);
  EXPECT_EQ(array.changedFrom(), 1U);
}

TEST(SceneArray, IsAllNewAgainWhenTheCopyIsLost) {
  SceneArray<int> array = uploaded({1, 2, 3});
  array.markLost();
  EXPECT_EQ(array.changedFrom(), 0U);
  EXPECT_TRUE(array.isChanged());
}

}  // namespace
}  // namespace glide::test
