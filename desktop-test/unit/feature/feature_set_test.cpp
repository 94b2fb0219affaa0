#include "feature/feature_set.h"

#include "feature/descriptor.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <hwy/targets.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <random>
#include <vector>

namespace glide {
namespace {

Descriptor randomDescriptor(std::mt19937_64* rng) {
  return {(*rng)(), (*rng)(), (*rng)(), (*rng)()};
}

int countedDistance(const Descriptor& a, const Descriptor& b) {
  int distance = 0;
  for (unsigned bit = 0; bit < 256; ++bit) {
    distance += static_cast<int>(((a[bit / 64] ^ b[bit / 64]) >> (bit % 64)) & 1U);
  }
  return distance;
}

float uniform(float low, float high, std::mt19937_64* rng) {
  return std::uniform_real_distribution<float>(low, high)(*rng);
}

FeatureSet randomSet(int width, int height, std::size_t count, std::mt19937_64* rng) {
  std::vector<Feature> features(count);
  std::vector<Descriptor> descriptors(count);
  for (std::size_t i = 0; i < count; ++i) {
    features[i].uv = {uniform(-0.5F, static_cast<float>(width) - 0.5F, rng),
                      uniform(-0.5F, static_cast<float>(height) - 0.5F, rng)};
    features[i].level = static_cast<std::uint8_t>((*rng)() % 8);
    descriptors[i] = randomDescriptor(rng);
  }
  return FeatureSet(std::move(features), std::move(descriptors), width, height);
}

std::vector<int> bruteForce(const FeatureSet& set, const FeatureSet::Query& query) {
  std::vector<int> found;
  for (std::size_t i = 0; i < set.size(); ++i) {
    const Feature& f = set.feature(i);
    const bool near = std::abs(f.uv.x() - query.uv.x()) <= query.radius_px &&
                      std::abs(f.uv.y() - query.uv.y()) <= query.radius_px;
    if (near && f.level >= query.min_level && f.level <= query.max_level) {
      found.push_back(static_cast<int>(i));
    }
  }
  return found;
}

TEST(DescriptorDistance, IsZeroToItselfAnd256ToItsComplement) {
  std::mt19937_64 rng(1);
  const Descriptor a = randomDescriptor(&rng);
  const Descriptor complement{~a[0], ~a[1], ~a[2], ~a[3]};
  EXPECT_EQ(descriptorDistance(a, a), 0);
  EXPECT_EQ(descriptorDistance(a, complement), 256);
}

TEST(DescriptorDistance, CountsDifferingBitsOfRandomDescriptors) {
  std::mt19937_64 rng(2);
  for (int i = 0; i < 1000; ++i) {
    const Descriptor a = randomDescriptor(&rng), b = randomDescriptor(&rng);
    EXPECT_EQ(descriptorDistance(a, b), countedDistance(a, b));
  }
}

TEST(DescriptorDistance, CountsEverySingleBit) {
  for (unsigned bit = 0; bit < 256; ++bit) {
    Descriptor a{};
    a[bit / 64] = std::uint64_t{1} << (bit % 64);
    EXPECT_EQ(descriptorDistance(a, Descriptor{}), 1) << bit;
  }
}

TEST(DescriptorDistance, OfManyEqualsThatOfPairsOnEveryInstructionSet) {
  std::mt19937_64 rng(3);
  const FeatureSet set = randomSet(100, 100, 77, &rng);
  const Descriptor query = randomDescriptor(&rng);
  const std::vector<int> indices{76, 0, 5, 5, 31};
  for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
    SCOPED_TRACE(hwy::TargetName(target));
    hwy::SetSupportedTargetsForTest(target);
    std::vector<int> distances(indices.size());
    descriptorDistances(query, set.descriptors(), indices, distances);
    for (std::size_t k = 0; k < indices.size(); ++k) {
      const Descriptor& other = set.descriptor(static_cast<std::size_t>(indices[k]));
      EXPECT_EQ(distances[k], countedDistance(query, other));
    }
  }
  hwy::SetSupportedTargetsForTest(0);
}

TEST(FeatureSet, FindsInAWindowWhatASearchOverAllFinds) {
  std::mt19937_64 rng(4);
  const FeatureSet set = randomSet(641, 479, 1500, &rng);
  std::vector<int> found;
  std::size_t total = 0;
  for (int i = 0; i < 500; ++i) {
    FeatureSet::Query query;
    query.uv = {uniform(-60.0F, 700.0F, &rng), uniform(-60.0F, 540.0F, &rng)};
    query.radius_px = uniform(0.0F, 120.0F, &rng);
    query.min_level = static_cast<int>(rng() % 4);
    query.max_level = query.min_level + static_cast<int>(rng() % 4);
    set.query(query, &found);
    EXPECT_EQ(found, bruteForce(set, query));
    total += found.size();
  }
  EXPECT_GT(total, 5000U);
}

TEST(FeatureSet, FindsTheSameWithFewFeaturesInALargeImage) {
  std::mt19937_64 rng(7);
  const FeatureSet set = randomSet(4000, 30, 40, &rng);
  std::vector<int> found;
  std::size_t total = 0;
  for (int i = 0; i < 300; ++i) {
    FeatureSet::Query query;
    query.uv = {uniform(-60.0F, 4100.0F, &rng), uniform(-20.0F, 50.0F, &rng)};
    query.radius_px = uniform(0.0F, 400.0F, &rng);
    set.query(query, &found);
    EXPECT_EQ(found, bruteForce(set, query));
    total += found.size();
  }
  EXPECT_GT(total, 300U);
}

TEST(FeatureSet, FindsAllFeaturesOfItsImageInAWindowWithoutEnd) {
  std::mt19937_64 rng(5);
  const FeatureSet set = randomSet(320, 240, 200, &rng);
  std::vector<int> found{-1};
  set.query({Vec2f(160.0F, 120.0F), 1e30F, 0, 255}, &found);
  std::vector<int> all(200);
  std::iota(all.begin(), all.end(), 0);
  EXPECT_EQ(found, all);
}

TEST(FeatureSet, FindsNothingAroundAPointThatIsNotANumber) {
  std::mt19937_64 rng(6);
  const FeatureSet set = randomSet(320, 240, 50, &rng);
  const float nan = std::numeric_limits<float>::quiet_NaN();
  std::vector<int> found{1, 2};
  set.query({Vec2f(nan, 10.0F), 1000.0F, 0, 255}, &found);
  EXPECT_THAT(found, testing::IsEmpty());
  set.query({Vec2f(10.0F, 10.0F), nan, 0, 255}, &found);
  EXPECT_THAT(found, testing::IsEmpty());
}

TEST(FeatureSet, WithoutFeaturesFindsNothing) {
  std::vector<int> found{3};
  FeatureSet().query({Vec2f(1.0F, 1.0F), 10.0F, 0, 255}, &found);
  EXPECT_THAT(found, testing::IsEmpty());
  found = {3};
  FeatureSet({}, {}, 0, 0).query({Vec2f(1.0F, 1.0F), 10.0F, 0, 255}, &found);
  EXPECT_THAT(found, testing::IsEmpty());
}

}  // namespace
}  // namespace glide
