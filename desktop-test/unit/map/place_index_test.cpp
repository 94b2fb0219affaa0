#include "map/place_index.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <utility>
#include <vector>

namespace glide {
namespace {

using testing::IsEmpty;

constexpr std::size_t kFeatures = 200;
constexpr int kNoiseBits = 15;
constexpr int kAll = 1000;

FeatureSet featuresOf(std::vector<Descriptor> descriptors) {
  std::vector<Feature> features(descriptors.size());
  for (Feature& feature : features) feature.uv = Vec2f(10.0F, 10.0F);
  return {std::move(features), std::move(descriptors), 640, 480};
}

/// A long wall of corners with random looks; an image shows kFeatures of them in a row.
class Wall {
 public:
  explicit Wall(std::uint64_t seed) : random_(seed), corners_(5000) {
    for (Descriptor& corner : corners_)
      for (std::uint64_t& word : corner) word = random_();
  }

  FeatureSet image(std::size_t first) { return featuresOf(descriptors(first)); }

  /// Half of the image shows things that are everywhere.
  FeatureSet imageWithCommonThings(std::size_t first) {
    std::vector<Descriptor> all = descriptors(first);
    for (std::size_t i = 0; i < kFeatures / 2; ++i) all[i] = noisy(corners_[i]);
    return featuresOf(all);
  }

 private:
  std::mt19937_64 random_;
  std::vector<Descriptor> corners_;

  std::vector<Descriptor> descriptors(std::size_t first) {
    std::vector<Descriptor> descriptors;
    for (std::size_t i = 0; i < kFeatures; ++i) descriptors.push_back(noisy(corners_[first + i]));
    return descriptors;
  }

  Descriptor noisy(Descriptor descriptor) {
    for (int i = 0; i < kNoiseBits; ++i) {
      const std::uint64_t bit = random_() % 256;
      descriptor[bit / 64] ^= std::uint64_t{1} << (bit % 64);
    }
    return descriptor;
  }
};

/// Keyframe k shows the wall from corner 100 k on: neighbours share half of their corners.
PlaceIndex walkAlong(Wall* wall, std::uint64_t keyframes) {
  PlaceIndex index;
  for (std::uint64_t k = 0; k < keyframes; ++k) index.add(KeyframeId{k}, wall->image(100 * k));
  return index;
}

void expectEqual(const std::vector<PlaceMatch>& a, const std::vector<PlaceMatch>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].keyframe, b[i].keyframe);
    EXPECT_EQ(a[i].votes, b[i].votes);
    EXPECT_EQ(a[i].score, b[i].score);
  }
}

TEST(PlaceIndex, FindsTheKeyframeThatShowsTheSame) {
  Wall wall(1);
  const PlaceIndex index = walkAlong(&wall, 30);
  for (std::uint64_t k = 0; k < 30; ++k) {
    const auto matches = index.query(wall.image(100 * k), 3);
    ASSERT_FALSE(matches.empty());
    EXPECT_EQ(matches.front().keyframe, KeyframeId{k});
    EXPECT_GT(matches.front().votes, 100);
    EXPECT_GT(matches.front().score, 0.5);
    EXPECT_LE(matches.front().score, 1.0);
  }
}

TEST(PlaceIndex, PutsNeighborsNext) {
  Wall wall(2);
  const auto matches = walkAlong(&wall, 30).query(wall.image(1000), kAll);
  ASSERT_GE(matches.size(), 3U);
  EXPECT_EQ(matches[0].keyframe, KeyframeId{10});
  const std::uint64_t low = std::min(matches[1].keyframe.value, matches[2].keyframe.value);
  const std::uint64_t high = std::max(matches[1].keyframe.value, matches[2].keyframe.value);
  EXPECT_EQ(low, 9U);
  EXPECT_EQ(high, 11U);
}

TEST(PlaceIndex, GivesNoVoteToStrangePlaces) {
  Wall wall(3), elsewhere(4);
  const PlaceIndex index = walkAlong(&wall, 30);
  EXPECT_THAT(index.query(elsewhere.image(0), kAll), IsEmpty());
}

TEST(PlaceIndex, TrustsRareThingsMore) {
  Wall wall(5);
  PlaceIndex index;
  for (std::uint64_t k = 0; k < 30; ++k)
    index.add(KeyframeId{k}, wall.imageWithCommonThings(200 + 100 * k));
  const auto matches = index.query(wall.imageWithCommonThings(1200), kAll);
  ASSERT_EQ(matches.size(), 30U);  // all show the common things
  EXPECT_EQ(matches[0].keyframe, KeyframeId{10});
  // By votes alone the strangers would have half of the best one's score.
  EXPECT_LT(matches.back().score, 0.35 * matches[0].score);
  EXPECT_GT(matches.back().votes, 0.35 * matches[0].votes);
}

TEST(PlaceIndex, ReturnsTheBestOnesOnly) {
  Wall wall(6);
  const PlaceIndex index = walkAlong(&wall, 10);
  const FeatureSet image = wall.image(450);
  const auto all = index.query(image, kAll);
  ASSERT_GT(all.size(), 2U);
  expectEqual(index.query(image, 2), {all[0], all[1]});
  EXPECT_THAT(index.query(image, 0), IsEmpty());
}

TEST(PlaceIndex, RanksEqualScoresByAge) {
  Wall wall(7);
  const FeatureSet image = wall.image(0);
  PlaceIndex index;
  for (const std::uint64_t k : {5, 3, 9}) index.add(KeyframeId{k}, image);
  const auto matches = index.query(image, kAll);
  ASSERT_EQ(matches.size(), 3U);
  EXPECT_EQ(matches[0].keyframe, KeyframeId{3});
  EXPECT_EQ(matches[2].keyframe, KeyframeId{9});
}

TEST(PlaceIndex, AnswersAsIfARemovedKeyframeHadNeverBeen) {
  Wall wall(8);
  const FeatureSet kept = wall.image(0), removed = wall.image(100), query = wall.image(50);
  PlaceIndex with, without;
  with.add(KeyframeId{1}, kept);
  with.add(KeyframeId{2}, removed);
  with.remove(KeyframeId{2});
  without.add(KeyframeId{1}, kept);
  EXPECT_FALSE(with.contains(KeyframeId{2}));
  EXPECT_EQ(with.size(), 1U);
  const auto matches = with.query(query, kAll);
  ASSERT_EQ(matches.size(), 1U);
  EXPECT_EQ(matches[0].keyframe, KeyframeId{1});
  EXPECT_NEAR(matches[0].score, without.query(query, kAll)[0].score, 0.1);
}

TEST(PlaceIndex, IgnoresWhatItHasAndWhatItHasNot) {
  Wall wall(9);
  PlaceIndex index = walkAlong(&wall, 3);
  const FeatureSet query = wall.image(100);
  const auto before = index.query(query, kAll);
  index.add(KeyframeId{1}, wall.image(4000));
  index.remove(KeyframeId{77});
  EXPECT_EQ(index.size(), 3U);
  expectEqual(index.query(query, kAll), before);
}

TEST(PlaceIndex, IsEmptyAfterClear) {
  Wall wall(10);
  PlaceIndex index = walkAlong(&wall, 3);
  index.clear();
  EXPECT_EQ(index.size(), 0U);
  EXPECT_FALSE(index.contains(KeyframeId{0}));
  EXPECT_THAT(index.query(wall.image(0), kAll), IsEmpty());
  index.add(KeyframeId{0}, wall.image(0));
  EXPECT_EQ(index.query(wall.image(0), kAll).size(), 1U);
}

TEST(PlaceIndex, AnswersAFrameWithoutFeatures) {
  Wall wall(11);
  EXPECT_THAT(walkAlong(&wall, 3).query(FeatureSet(), kAll), IsEmpty());
  EXPECT_THAT(PlaceIndex().query(wall.image(0), kAll), IsEmpty());
}

TEST(PlaceIndex, AnswersTheSameToTheSameCalls) {
  Wall wall_a(12), wall_b(12);
  PlaceIndex a = walkAlong(&wall_a, 20), b = walkAlong(&wall_b, 20);
  for (const std::uint64_t k : {4, 7}) {
    a.remove(KeyframeId{k});
    b.remove(KeyframeId{k});
  }
  expectEqual(a.query(wall_a.image(650), kAll), b.query(wall_b.image(650), kAll));
}

}  // namespace
}  // namespace glide
