#include "feature/matcher.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <random>
#include <set>
#include <utility>
#include <vector>

namespace glide {
namespace {

constexpr int kWidth = 640, kHeight = 480;

using testing::ElementsAre;
using testing::IsEmpty;

MATCHER_P3(MatchIs, a, b, distance, "") {
  return arg.a == a && arg.b == b && arg.distance == distance;
}

struct Collection {
  std::vector<Feature> features;
  std::vector<Descriptor> descriptors;

  void add(const Vec2f& uv, const Descriptor& descriptor, int level, float angle) {
    Feature f;
    f.uv = uv;
    f.level = static_cast<std::uint8_t>(level);
    f.angle = angle;
    features.push_back(f);
    descriptors.push_back(descriptor);
  }
  FeatureSet set() const { return FeatureSet(features, descriptors, kWidth, kHeight); }
};

Descriptor randomDescriptor(std::mt19937_64* rng) {
  return {(*rng)(), (*rng)(), (*rng)(), (*rng)()};
}

/// The first `count` bits set: distance between two of them is the difference of the counts.
Descriptor ones(unsigned count) {
  Descriptor d{};
  for (unsigned bit = 0; bit < count; ++bit) d[bit / 64] |= std::uint64_t{1} << (bit % 64);
  return d;
}

Descriptor withFlippedBits(Descriptor d, int count, std::mt19937_64* rng) {
  for (int i = 0; i < count; ++i) {
    const std::uint64_t bit = (*rng)() % 256;
    d[bit / 64] ^= std::uint64_t{1} << (bit % 64);
  }
  return d;
}

Vec2f randomPixel(std::mt19937_64* rng) {
  std::uniform_real_distribution<float> x(0.0F, kWidth - 1.0F), y(0.0F, kHeight - 1.0F);
  const float u = x(*rng);
  return {u, y(*rng)};
}

/// Two views: feature i of the first is feature partner[i] of the second (-1: not seen), moved by
/// `motion` and turned by `turn`, with some bits of noise. Both have strangers.
struct TwoViews {
  Collection a, b;
  std::vector<int> partner;
};

TwoViews makeTwoViews(const Vec2f& motion, float turn, std::uint64_t seed) {
  constexpr int kFeatures = 400, kStrangers = 150;
  std::mt19937_64 rng(seed);
  TwoViews views;
  std::vector<int> order(kFeatures);
  std::iota(order.begin(), order.end(), 0);
  std::shuffle(order.begin(), order.end(), rng);
  views.partner.assign(kFeatures, -1);
  for (int i = 0; i < kFeatures; ++i) {
    views.a.add(randomPixel(&rng), randomDescriptor(&rng), i % 4, 0.01F * static_cast<float>(i));
  }
  for (const int i : order) {
    const std::size_t k = static_cast<std::size_t>(i);
    const Feature& f = views.a.features[k];
    if (i % 5 == 0) continue;  // hidden in the second view
    views.partner[k] = static_cast<int>(views.b.features.size());
    const Descriptor d = withFlippedBits(views.a.descriptors[k], 25, &rng);
    views.b.add(f.uv + motion, d, f.level, f.angle + turn);
  }
  for (int i = 0; i < kStrangers; ++i) {
    views.b.add(randomPixel(&rng), randomDescriptor(&rng), i % 4, 1.0F);
  }
  return views;
}

void expectExactlyThePartners(const std::vector<Match>& matches,
                              const TwoViews& views,
                              int max_level) {
  std::set<std::pair<int, int>> found, expected;
  for (const Match& m : matches) found.emplace(m.a, m.b);
  for (std::size_t i = 0; i < views.partner.size(); ++i) {
    if (views.partner[i] >= 0 && views.a.features[i].level <= max_level) {
      expected.emplace(static_cast<int>(i), views.partner[i]);
    }
  }
  EXPECT_EQ(found.size(), matches.size());
  EXPECT_EQ(found, expected);
}

TEST(MatchBruteForce, FindsThePartnersAmongStrangers) {
  const TwoViews views = makeTwoViews(Vec2f(200.0F, -90.0F), 2.0F, 1);
  const std::vector<Match> matches =
      matchBruteForce(views.a.set(), {}, views.b.set(), MatchOptions{});
  expectExactlyThePartners(matches, views, 255);
}

TEST(MatchBruteForce, KeepsToItsSubset) {
  const TwoViews views = makeTwoViews(Vec2f(5.0F, 5.0F), 0.0F, 2);
  const std::vector<int> subset{7, 11, 23};
  const std::vector<Match> matches =
      matchBruteForce(views.a.set(), subset, views.b.set(), MatchOptions{});
  ASSERT_EQ(matches.size(), 3U);
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_EQ(matches[k].a, subset[k]);
    EXPECT_EQ(matches[k].b, views.partner[static_cast<std::size_t>(subset[k])]);
  }
}

TEST(MatchBruteForce, GivesAFeatureOnlyToItsClosest) {
  Collection a, b;
  a.add(Vec2f(10.0F, 10.0F), ones(10), 0, 0.0F);
  a.add(Vec2f(20.0F, 10.0F), ones(3), 0, 0.0F);
  b.add(Vec2f(10.0F, 10.0F), ones(0), 0, 0.0F);
  EXPECT_THAT(matchBruteForce(a.set(), {}, b.set(), MatchOptions{}), ElementsAre(MatchIs(1, 0, 3)));
}

TEST(MatchBruteForce, RefusesDistantAndAmbiguousDescriptors) {
  Collection a, b;
  a.add(Vec2f(10.0F, 10.0F), ones(0), 0, 0.0F);
  b.add(Vec2f(10.0F, 10.0F), ones(50), 0, 0.0F);
  MatchOptions options;
  options.max_distance = 49;
  EXPECT_THAT(matchBruteForce(a.set(), {}, b.set(), options), IsEmpty());
  options.max_distance = 50;
  EXPECT_THAT(matchBruteForce(a.set(), {}, b.set(), options), ElementsAre(MatchIs(0, 0, 50)));
  b.add(Vec2f(300.0F, 10.0F), ones(60), 0, 0.0F);
  EXPECT_THAT(matchBruteForce(a.set(), {}, b.set(), options), IsEmpty());
}

TEST(MatchBruteForce, OfEmptySetsIsEmpty) {
  const TwoViews views = makeTwoViews(Vec2f(5.0F, 5.0F), 0.0F, 3);
  EXPECT_THAT(matchBruteForce(FeatureSet(), {}, views.b.set(), MatchOptions{}), IsEmpty());
  EXPECT_THAT(matchBruteForce(views.a.set(), {}, FeatureSet(), MatchOptions{}), IsEmpty());
}

TEST(MatchBruteForce, DropsMatchesThatTurnAnotherWayOnlyWhenAsked) {
  TwoViews views = makeTwoViews(Vec2f(5.0F, 5.0F), -1.0F, 4);
  const std::size_t odd = static_cast<std::size_t>(views.partner[1]);
  views.b.features[odd].angle += 1.5F;
  MatchOptions options;
  options.check_orientation = false;
  expectExactlyThePartners(matchBruteForce(views.a.set(), {}, views.b.set(), options), views, 255);
  options.check_orientation = true;
  views.partner[1] = -1;
  expectExactlyThePartners(matchBruteForce(views.a.set(), {}, views.b.set(), options), views, 255);
}

TEST(MatchInWindow, FindsThePartnersAroundTheGuesses) {
  const Vec2f motion(30.0F, -20.0F);
  const TwoViews views = makeTwoViews(motion, 0.3F, 5);
  std::vector<Vec2f> guess;
  for (const Feature& f : views.a.features) guess.push_back(f.uv + Vec2f(22.0F, -26.0F));
  WindowOptions options;
  options.max_level = 1;
  options.radius_px = 10.0F;
  expectExactlyThePartners(matchInWindow(views.a.set(), guess, views.b.set(), options), views, 1);
  options.radius_px = 7.0F;  // the guess is 8 px off
  EXPECT_THAT(matchInWindow(views.a.set(), guess, views.b.set(), options), IsEmpty());
}

TEST(MatchInWindow, LooksOnlyAtNeighbouringLevels) {
  Collection a, b;
  a.add(Vec2f(10.0F, 10.0F), ones(0), 3, 0.0F);
  b.add(Vec2f(10.0F, 10.0F), ones(1), 5, 0.0F);
  WindowOptions options;
  options.max_level = 7;
  const std::vector<Vec2f> guess{Vec2f(10.0F, 10.0F)};
  EXPECT_THAT(matchInWindow(a.set(), guess, b.set(), options), IsEmpty());
  b.features[0].level = 4;
  EXPECT_THAT(matchInWindow(a.set(), guess, b.set(), options), ElementsAre(MatchIs(0, 0, 1)));
}

std::vector<ProjectedTarget> targetsOf(const TwoViews& views, const Vec2f& motion) {
  std::vector<ProjectedTarget> targets;
  for (std::size_t i = 0; i < views.a.features.size(); ++i) {
    const Feature& f = views.a.features[i];
    targets.push_back({static_cast<int>(i) + 1000,
                       f.uv + motion,
                       6.0F,
                       std::max(0, f.level - 1),
                       f.level + 1,
                       views.a.descriptors[i]});
  }
  return targets;
}

TEST(MatchByProjection, FindsThePartnersAndAnswersWithTheCallersIds) {
  const Vec2f motion(3.0F, 8.0F);
  const TwoViews views = makeTwoViews(motion, 0.0F, 6);
  std::vector<Match> matches = matchByProjection(
      targetsOf(views, motion + Vec2f(2.0F, -3.0F)), views.b.set(), {}, MatchOptions{});
  for (Match& m : matches) m.a -= 1000;
  expectExactlyThePartners(matches, views, 255);
}

TEST(MatchByProjection, LeavesOutFeaturesThatAreTaken) {
  const Vec2f motion(3.0F, 8.0F);
  const TwoViews views = makeTwoViews(motion, 0.0F, 7);
  std::vector<bool> taken(views.b.features.size(), false);
  for (std::size_t i = 0; i < taken.size(); i += 2) taken[i] = true;
  const std::vector<Match> matches =
      matchByProjection(targetsOf(views, motion), views.b.set(), taken, MatchOptions{});
  EXPECT_GT(matches.size(), 100U);
  for (const Match& m : matches) EXPECT_FALSE(taken[static_cast<std::size_t>(m.b)]);
}

TEST(MatchByProjection, GivesAFeatureToTheCloserOfTwoTargets) {
  Collection b;
  b.add(Vec2f(50.0F, 50.0F), ones(0), 0, 0.0F);
  const Vec2f uv(51.0F, 50.0F);
  const std::vector<ProjectedTarget> targets{
      {1, uv, 5.0F, 0, 0, ones(9)}, {2, uv, 5.0F, 0, 0, ones(4)}, {3, uv, 5.0F, 0, 0, ones(6)}};
  EXPECT_THAT(matchByProjection(targets, b.set(), {}, MatchOptions{}),
              ElementsAre(MatchIs(2, 0, 4)));
}

TEST(MatchByProjection, ComparesWithRivalsOfTheSameLevelOnly) {
  Collection b;
  b.add(Vec2f(50.0F, 50.0F), ones(10), 2, 0.0F);
  b.add(Vec2f(51.0F, 50.0F), ones(11), 3, 0.0F);
  const std::vector<ProjectedTarget> targets{{0, Vec2f(50.0F, 50.0F), 5.0F, 1, 4, ones(0)}};
  EXPECT_THAT(matchByProjection(targets, b.set(), {}, MatchOptions{}),
              ElementsAre(MatchIs(0, 0, 10)));
  b.features[1].level = 2;
  EXPECT_THAT(matchByProjection(targets, b.set(), {}, MatchOptions{}), IsEmpty());
}

TEST(MatchByProjection, KeepsToWindowAndLevels) {
  Collection b;
  b.add(Vec2f(50.0F, 50.0F), ones(0), 2, 0.0F);
  const auto matched = [&](const Vec2f& uv, int low, int high) {
    const std::vector<ProjectedTarget> targets{{0, uv, 4.0F, low, high, ones(0)}};
    return !matchByProjection(targets, b.set(), {}, MatchOptions{}).empty();
  };
  EXPECT_TRUE(matched(Vec2f(54.0F, 46.0F), 2, 2));
  EXPECT_FALSE(matched(Vec2f(54.1F, 50.0F), 2, 2));
  EXPECT_FALSE(matched(Vec2f(50.0F, 50.0F), 3, 7));
  EXPECT_FALSE(matched(Vec2f(50.0F, 50.0F), 0, 1));
}

TEST(MatchByProjection, WithoutTargetsOrFeaturesIsEmpty) {
  const TwoViews views = makeTwoViews(Vec2f(0.0F, 0.0F), 0.0F, 8);
  EXPECT_THAT(matchByProjection({}, views.b.set(), {}, MatchOptions{}), IsEmpty());
  EXPECT_THAT(matchByProjection(targetsOf(views, Vec2f::Zero()), FeatureSet(), {}, MatchOptions{}),
              IsEmpty());
}

}  // namespace
}  // namespace glide
