#include "feature/fast_corners.h"

#include "unit/feature/dead_leaves.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <hwy/targets.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <random>
#include <vector>

namespace glide {
namespace {

constexpr int kBorder = 16;

constexpr std::array<int, 16> kCircleX{0, 1, 2, 3, 3, 3, 2, 1, 0, -1, -2, -3, -3, -3, -2, -1};
constexpr std::array<int, 16> kCircleY{-3, -3, -2, -1, 0, 1, 2, 3, 3, 3, 2, 1, 0, -1, -2, -3};

/// Whether nine neighbours in a row are brighter (sign 1) or darker (-1) by more than t: the
/// definition, word by word.
bool isCorner(const ImageU8& image, int x, int y, int t, int sign) {
  for (int start = 0; start < 16; ++start) {
    int length = 0;
    while (length < 9) {
      const std::size_t k = static_cast<std::size_t>((start + length) % 16);
      const int other = image.at(x + kCircleX[k], y + kCircleY[k]);
      if (sign * (other - image.at(x, y)) <= t) break;
      ++length;
    }
    if (length == 9) return true;
  }
  return false;
}

int naiveScore(const ImageU8& image, int x, int y, int sign) {
  int low = -1, high = 255;  // a corner at low, none at high
  while (high - low > 1) {
    const int middle = (low + high) / 2;
    (isCorner(image, x, y, middle, sign) ? low : high) = middle;
  }
  return low;
}

int naiveScore(const ImageU8& image, int x, int y) {
  return std::max(naiveScore(image, x, y, 1), naiveScore(image, x, y, -1));
}

std::vector<Corner> naiveCorners(const ImageU8& image, int min_score) {
  ImageU8 scores(image.width(), image.height());
  for (int y = 0; y < image.height(); ++y) {
    std::fill_n(scores.row(y), image.width(), std::uint8_t{0});
  }
  for (int y = kBorder - 1; y <= image.height() - kBorder; ++y) {
    for (int x = kBorder - 1; x <= image.width() - kBorder; ++x) {
      const int score = naiveScore(image, x, y);
      scores.at(x, y) = static_cast<std::uint8_t>(score >= min_score ? score : 0);
    }
  }
  std::vector<Corner> corners;
  for (int y = kBorder; y < image.height() - kBorder; ++y) {
    for (int x = kBorder; x < image.width() - kBorder; ++x) {
      const int score = scores.at(x, y);
      bool largest = score > 0;
      for (int k = 0; k < 9; ++k) {
        const int other = scores.at(x + k % 3 - 1, y + k / 3 - 1);
        if (k != 4) largest &= k < 4 ? score > other : score >= other;
      }
      if (largest) corners.push_back({x, y, score});
    }
  }
  return corners;
}

ImageU8 randomImage(int width, int height, unsigned seed) {
  ImageU8 image(width, height);
  std::mt19937 rng(seed);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      // Blocks, or else noise so dense leaves no corner.
      const bool keep = x > 0 && rng() % 3 != 0;
      image.at(x, y) = keep ? image.at(x - 1, y) : static_cast<std::uint8_t>(rng() >> 24U);
    }
  }
  return image;
}

void expectSameCorners(const std::vector<Corner>& a, const std::vector<Corner>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    ASSERT_EQ(a[i].x, b[i].x) << i;
    ASSERT_EQ(a[i].y, b[i].y) << i;
    ASSERT_EQ(a[i].score, b[i].score) << i;
  }
}

struct Size {
  int width, height;
};
class FastCornersOfSize : public testing::TestWithParam<Size> {};

TEST_P(FastCornersOfSize, AreThoseOfTheDefinitionOnEveryInstructionSet) {
  const ImageU8 image = randomImage(GetParam().width, GetParam().height, 11);
  for (const int min_score : {1, 7, 20, 120}) {
    const std::vector<Corner> expected = naiveCorners(image, min_score);
    for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
      SCOPED_TRACE(hwy::TargetName(target));
      hwy::SetSupportedTargetsForTest(target);
      std::vector<Corner> corners{{1, 2, 3}};
      fastCorners(image.view(), kBorder, min_score, &corners);
      expectSameCorners(corners, expected);
    }
    hwy::SetSupportedTargetsForTest(0);
  }
}

INSTANTIATE_TEST_SUITE_P(
    WholeAndBrokenVectors,
    FastCornersOfSize,
    testing::Values(Size{160, 70}, Size{97, 61}, Size{96, 48}, Size{33, 33}, Size{35, 90}),
    [](const auto& parameter) {
      return std::to_string(parameter.param.width) + "x" + std::to_string(parameter.param.height);
    });

TEST(FastCorners, AreFoundInTexture) {
  const ImageU8 image = test::DeadLeaves(1).render(320, 240);
  std::vector<Corner> corners;
  fastCorners(image.view(), kBorder, 20, &corners);
  EXPECT_GT(corners.size(), 500U);
}

TEST(FastCorners, AreNotFoundOnFlatGroundOrAlongAnEdge) {
  ImageU8 image(120, 100);
  std::vector<Corner> corners;
  for (int y = 0; y < 100; ++y) std::fill_n(image.row(y), 120, std::uint8_t{77});
  fastCorners(image.view(), kBorder, 1, &corners);
  EXPECT_THAT(corners, testing::IsEmpty());
  for (int y = 0; y < 100; ++y) std::fill_n(image.row(y), 60, std::uint8_t{200});
  fastCorners(image.view(), kBorder, 1, &corners);
  EXPECT_THAT(corners, testing::IsEmpty());
}

Vec2f naiveRefinement(const ImageU8& image, const Corner& c) {
  const int sign = naiveScore(image, c.x, c.y, 1) > naiveScore(image, c.x, c.y, -1) ? 1 : -1;
  const auto contrast = [&](int k) {
    return static_cast<float>(naiveScore(image, c.x + k % 5 - 2, c.y + k / 5 - 2, sign) + 1);
  };
  float smallest = contrast(0);
  for (int k = 1; k < 25; ++k) smallest = std::min(smallest, contrast(k));
  Vec2f sum = Vec2f::Zero();
  float mass = 0.0F;
  for (int k = 0; k < 25; ++k) {
    const float weight = std::pow(contrast(k) - smallest, 2.0F);
    sum += weight * Vec2f(static_cast<float>(k % 5 - 2), static_cast<float>(k / 5 - 2));
    mass += weight;
  }
  return Vec2f(static_cast<float>(c.x), static_cast<float>(c.y)) + sum / mass;
}

TEST(RefineCorners, WeighsByScoresOfTheCornersSignOnEveryInstructionSet) {
  const ImageU8 image = randomImage(150, 90, 12);
  std::vector<Corner> corners;
  fastCorners(image.view(), kBorder, 10, &corners);
  ASSERT_GT(corners.size(), 100U);
  for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
    SCOPED_TRACE(hwy::TargetName(target));
    hwy::SetSupportedTargetsForTest(target);
    std::vector<Vec2f> uv(corners.size());
    refineCorners(image.view(), corners, uv);
    for (std::size_t i = 0; i < corners.size(); ++i) {
      EXPECT_LT((uv[i] - naiveRefinement(image, corners[i])).norm(), 1e-4F);
    }
  }
  hwy::SetSupportedTargetsForTest(0);
}

/// Squared distances of corners of a view to the nearest true position of corners of a reference.
struct Localisation {
  double whole = 0.0, refined = 0.0;
  int count = 0;
};

void measure(const test::DeadLeaves& leaves, const Eigen::Matrix2f& A, Localisation* sum) {
  constexpr int kWidth = 320, kHeight = 240;
  const Vec2f centre(0.5F * (kWidth - 1), 0.5F * (kHeight - 1));
  std::vector<Corner> corners[2];
  std::vector<Vec2f> uv[2];
  for (std::size_t k = 0; k < 2; ++k) {
    ImageU8 image = leaves.render(kWidth, kHeight, k == 0 ? test::similarity(0.0F, 1.0F) : A, 0.7F);
    test::addNoise(2.0F, 7 + static_cast<unsigned>(k), &image);
    fastCorners(image.view(), kBorder, 20, &corners[k]);
    uv[k].resize(corners[k].size());
    refineCorners(image.view(), corners[k], uv[k]);
  }
  const auto whole = [](const Corner& c) {
    return Vec2f(static_cast<float>(c.x), static_cast<float>(c.y));
  };
  for (std::size_t i = 0; i < uv[1].size(); ++i) {
    const Vec2f true_uv = A * (whole(corners[1][i]) - centre) + centre;
    for (std::size_t j = 0; j < uv[0].size(); ++j) {
      if ((true_uv - whole(corners[0][j])).norm() > 1.5F) continue;
      sum->whole += (true_uv - whole(corners[0][j])).squaredNorm();
      sum->refined += (A * (uv[1][i] - centre) + centre - uv[0][j]).squaredNorm();
      ++sum->count;
    }
  }
}

TEST(RefineCorners, LocatesCornersBetterThanWholePixelsUnderKnownWarps) {
  const test::DeadLeaves leaves(2);
  Localisation sum;
  for (const float angle : {0.1F, 0.5F, 1.0F}) measure(leaves, test::similarity(angle, 1.0F), &sum);
  measure(leaves, test::similarity(0.05F, 1.1F), &sum);
  ASSERT_GT(sum.count, 1000);
  RecordProperty("rms_whole_px", std::to_string(std::sqrt(sum.whole / sum.count)));
  RecordProperty("rms_refined_px", std::to_string(std::sqrt(sum.refined / sum.count)));
  EXPECT_LT(std::sqrt(sum.refined), 0.75 * std::sqrt(sum.whole));
}

}  // namespace
}  // namespace glide
