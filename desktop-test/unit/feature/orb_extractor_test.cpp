#include "feature/orb_extractor.h"

#include "unit/feature/dead_leaves.h"

#include "feature/matcher.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace glide {
namespace {

constexpr int kWidth = 320, kHeight = 240;

FeatureSet extract(const ImageU8& image, int count) {
  return OrbExtractor(Config::Features{}).extract(image.view(), count);
}

void expectSame(const FeatureSet& a, const FeatureSet& b) {
  ASSERT_EQ(a.size(), b.size());
  EXPECT_EQ(a.descriptors(), b.descriptors());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a.feature(i).uv, b.feature(i).uv);
    EXPECT_EQ(a.feature(i).angle, b.feature(i).angle);
    EXPECT_EQ(a.feature(i).level, b.feature(i).level);
  }
}

TEST(OrbExtractor, GivesTheWantedNumberFromTexture) {
  const ImageU8 image = test::DeadLeaves(20).render(kWidth, kHeight);
  for (const int count : {100, 300, 600}) {
    EXPECT_EQ(extract(image, count).size(), static_cast<std::size_t>(count));
  }
}

TEST(OrbExtractor, GivesNoneFromABlankImage) {
  ImageU8 image(kWidth, kHeight);
  for (int y = 0; y < kHeight; ++y) std::fill_n(image.row(y), kWidth, std::uint8_t{255});
  EXPECT_EQ(extract(image, 500).size(), 0U);
}

TEST(OrbExtractor, GivesNoneWhenNoneAreWanted) {
  EXPECT_EQ(extract(test::DeadLeaves(20).render(kWidth, kHeight), 0).size(), 0U);
}

TEST(OrbExtractor, TakesImagesOfEverySize) {
  const ImageU8 image = test::DeadLeaves(21).render(kWidth, kHeight);
  OrbExtractor extractor{Config::Features{}};
  for (const int width : {320, 319, 101, 64, 41, 40, 34, 33, 32, 5, 1}) {
    for (const int height : {240, 239, 47, 35, 33, 32, 7, 1}) {
      const FeatureSet set = extractor.extract({image.row(0), width, height, image.stride()}, 200);
      for (const Feature& f : set.features()) {
        EXPECT_TRUE(f.uv.x() >= 0 && f.uv.y() >= 0 && f.uv.x() < static_cast<float>(width) &&
                    f.uv.y() < static_cast<float>(height));
      }
      if (std::min(width, height) <= 32) {
        EXPECT_EQ(set.size(), 0U);
      }
    }
  }
  EXPECT_EQ(extractor.extract({}, 200).size(), 0U);
}

TEST(OrbExtractor, IgnoresWhatLiesBetweenTheRowsOfAnImage) {
  const ImageU8 image = test::DeadLeaves(22).render(kWidth - 7, kHeight);
  constexpr int kStride = 401;
  std::vector<std::uint8_t> wide(static_cast<std::size_t>(kStride) * kHeight, 211);
  for (int y = 0; y < kHeight; ++y) {
    std::copy_n(image.row(y), image.width(), wide.data() + y * kStride);
  }
  OrbExtractor extractor{Config::Features{}};
  expectSame(extractor.extract({wide.data(), image.width(), kHeight, kStride}, 300),
             extract(image, 300));
}

TEST(OrbExtractor, RepeatsItselfWhateverItSawBefore) {
  const test::DeadLeaves leaves(23);
  const ImageU8 image = leaves.render(kWidth, kHeight), other = leaves.render(211, 333);
  OrbExtractor extractor{Config::Features{}};
  const FeatureSet first = extractor.extract(image.view(), 500);
  extractor.extract(other.view(), 700);
  expectSame(extractor.extract(image.view(), 500), first);
}

TEST(OrbExtractor, SpreadsFeaturesOverPartsOfLowContrast) {
  // The right half shows the left one mirrored, with a fifth of its contrast: no strong corner.
  Config::Features config;
  config.fast_threshold = 60;
  const test::DeadLeaves leaves(24);
  const ImageU8 strong = leaves.render(kWidth, kHeight);
  const ImageU8 weak = leaves.render(kWidth, kHeight, Eigen::Matrix2f::Identity(), 0.2F);
  ImageU8 image(kWidth, kHeight);
  for (int y = 0; y < kHeight; ++y) {
    std::copy_n(strong.row(y), kWidth / 2, image.row(y));
    std::reverse_copy(weak.row(y), weak.row(y) + kWidth / 2, image.row(y) + kWidth / 2);
  }
  std::array<int, 16> cells{};
  int right = 0;
  const FeatureSet set = OrbExtractor(config).extract(image.view(), 400);
  for (const Feature& f : set.features()) {
    const int column = static_cast<int>(f.uv.x()) * 4 / kWidth;
    const int row = static_cast<int>(f.uv.y()) * 4 / kHeight;
    ++cells[static_cast<std::size_t>(row * 4 + column)];
    right += column >= 2 ? 1 : 0;
  }
  EXPECT_EQ(set.size(), 400U);
  EXPECT_THAT(cells, testing::Each(testing::Ge(5)));  // a fifth of an even share
  EXPECT_GT(right, 80);
}

TEST(OrbExtractor, NamesLevelsThatShrinkInNumber) {
  const FeatureSet set = extract(test::DeadLeaves(25).render(752, 480), 1000);
  std::array<int, 8> of_level{};
  for (const Feature& f : set.features()) {
    ASSERT_LT(f.level, 8);
    ++of_level[f.level];
  }
  EXPECT_TRUE(std::is_sorted(of_level.rbegin(), of_level.rend()));
  EXPECT_GT(of_level[7], 30);
}

/// Bright spots at known places between the pixels.
struct Spots {
  ImageU8 image;
  std::vector<Vec2f> centers;
};

Spots makeSpots(float sigma, unsigned seed) {
  Spots spots{ImageU8(480, 360), {}};
  std::mt19937 rng(seed);
  std::uniform_real_distribution<float> jitter(-4.0F, 4.0F);
  for (int y = 80; y < 300; y += 50) {
    for (int x = 80; x < 420; x += 50) {
      spots.centers.emplace_back(static_cast<float>(x) + jitter(rng),
                                 static_cast<float>(y) + jitter(rng));
    }
  }
  for (int y = 0; y < 360; ++y) {
    for (int x = 0; x < 480; ++x) {
      float grey = 30.0F;
      for (const Vec2f& c : spots.centers) {
        const float d2 = (Vec2f(static_cast<float>(x), static_cast<float>(y)) - c).squaredNorm();
        if (d2 < 1600.0F) grey += 200.0F * std::exp(-d2 / (2.0F * sigma * sigma));
      }
      spots.image.at(x, y) = static_cast<std::uint8_t>(std::lround(std::min(grey, 255.0F)));
    }
  }
  return spots;
}

TEST(OrbExtractor, PutsSpotsOfEveryLevelWhereTheyAreWithoutBias) {
  std::array<Vec2f, 8> sum{};
  sum.fill(Vec2f::Zero());
  std::array<int, 8> count{};
  for (const float sigma : {1.5F, 2.0F, 3.0F, 4.0F, 5.0F}) {
    const Spots spots = makeSpots(sigma, 30);
    const FeatureSet set = extract(spots.image, 600);
    for (const Feature& f : set.features()) {
      const float scale = std::pow(1.2F, static_cast<float>(f.level));
      // To a level at which it is larger than the ring of FAST a spot has a flat top, not a place.
      if (sigma / scale > 2.0F) continue;
      for (const Vec2f& c : spots.centers) {
        const Vec2f error = f.uv - c;
        if (error.norm() > 2.0F * scale) continue;
        EXPECT_LT(error.norm(), 0.3F * scale);
        sum[f.level] += error;
        ++count[f.level];
      }
    }
  }
  for (std::size_t l = 0; l < 8; ++l) {
    ASSERT_GT(count[l], 20) << l;
    EXPECT_LT((sum[l] / static_cast<float>(count[l])).norm(), 0.1F) << l;
  }
}

TEST(OrbExtractor, SeesAMirroredImageMirrored) {
  // A wrong half pixel in the map from a level to level 0 moves both images' features one way.
  const ImageU8 image = test::DeadLeaves(26).render(kWidth, kHeight);
  ImageU8 mirrored(kWidth, kHeight);
  for (int y = 0; y < kHeight; ++y) {
    std::reverse_copy(image.row(y), image.row(y) + kWidth, mirrored.row(y));
  }
  const FeatureSet a = extract(image, 500), b = extract(mirrored, 500);
  std::array<float, 8> sum{};
  std::array<int, 8> count{};
  for (const Feature& f : a.features()) {
    for (const Feature& g : b.features()) {
      const Vec2f back(static_cast<float>(kWidth - 1) - g.uv.x(), g.uv.y());
      if (f.level != g.level || (f.uv - back).norm() > 1.0F) continue;
      sum[f.level] += f.uv.x() - back.x();
      ++count[f.level];
    }
  }
  for (std::size_t l = 0; l < 8; ++l) {
    ASSERT_GT(count[l], 10) << l;
    EXPECT_LT(std::abs(sum[l] / static_cast<float>(count[l])), 0.1F) << l;
  }
}

struct Repeat {
  double found = 0.0;    ///< share of the features seen again within 2 px of their level
  double matched = 0.0;  ///< share of those that the descriptor matches rightly
  double correct = 0.0;  ///< share of all matches that are right
};

/// `A` maps pixels of the view to pixels of the reference, about the centre.
Repeat repeatability(const test::DeadLeaves& leaves, const Eigen::Matrix2f& A) {
  ImageU8 images[2] = {leaves.render(kWidth, kHeight), leaves.render(kWidth, kHeight, A, 0.8F)};
  for (unsigned k = 0; k < 2; ++k) test::addNoise(2.0F, 40 + k, &images[k]);
  const FeatureSet reference = extract(images[0], 400), view = extract(images[1], 400);
  const Vec2f centre(0.5F * (kWidth - 1), 0.5F * (kHeight - 1));
  const auto near = [&](const Feature& f, const Feature& g) {
    const float limit = 2.0F * std::pow(1.2F, static_cast<float>(std::max(f.level, g.level)));
    return (A * (g.uv - centre) + centre - f.uv).norm() < limit;
  };
  // Only what lies well inside of the view can be found again.
  const auto visible = [&](const Feature& f) {
    const Vec2f off = A.inverse() * (f.uv - centre);
    return std::abs(off.x()) < 100.0F && std::abs(off.y()) < 60.0F;
  };
  const auto seen_again = [&](const Feature& f) {
    return visible(f) && std::any_of(view.features().begin(),
                                     view.features().end(),
                                     [&](const Feature& g) { return near(f, g); });
  };
  const auto& all = reference.features();
  const auto possible = static_cast<double>(std::count_if(all.begin(), all.end(), visible));
  const auto found = static_cast<double>(std::count_if(all.begin(), all.end(), seen_again));
  int right = 0, right_visible = 0;
  const std::vector<Match> matches = matchBruteForce(reference, {}, view, MatchOptions{});
  for (const Match& m : matches) {
    const Feature& f = all[static_cast<std::size_t>(m.a)];
    if (!near(f, view.feature(static_cast<std::size_t>(m.b)))) continue;
    ++right;
    right_visible += visible(f) ? 1 : 0;
  }
  return {found / possible, right_visible / found, right / static_cast<double>(matches.size())};
}

class OrbExtractorTurned : public testing::TestWithParam<int> {};

TEST_P(OrbExtractorTurned, FindsItsFeaturesAgainAndKnowsThem) {
  const float angle = static_cast<float>(GetParam()) * 3.14159265F / 180.0F;
  const Repeat repeat = repeatability(test::DeadLeaves(27), test::similarity(angle, 1.0F));
  RecordProperty("found", std::to_string(repeat.found));
  RecordProperty("matched", std::to_string(repeat.matched));
  RecordProperty("correct", std::to_string(repeat.correct));
  EXPECT_GT(repeat.found, 0.6);
  EXPECT_GT(repeat.matched, 0.4);
  EXPECT_GT(repeat.correct, 0.9);
}

INSTANTIATE_TEST_SUITE_P(ByDegrees,
                         OrbExtractorTurned,
                         testing::Values(0, 7, 20, 33, 45, 60, 77, 90));

class OrbExtractorScaled : public testing::TestWithParam<int> {};

TEST_P(OrbExtractorScaled, FindsItsFeaturesAgainAndKnowsThem) {
  const float scale = 0.01F * static_cast<float>(GetParam());
  const Repeat repeat = repeatability(test::DeadLeaves(28), test::similarity(0.2F, scale));
  RecordProperty("found", std::to_string(repeat.found));
  RecordProperty("matched", std::to_string(repeat.matched));
  RecordProperty("correct", std::to_string(repeat.correct));
  EXPECT_GT(repeat.found, 0.5);
  EXPECT_GT(repeat.matched, 0.2);
  EXPECT_GT(repeat.correct, 0.9);
}

INSTANTIATE_TEST_SUITE_P(ByPercent, OrbExtractorScaled, testing::Values(70, 83, 90, 110, 120, 144));

}  // namespace
}  // namespace glide
