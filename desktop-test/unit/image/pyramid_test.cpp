#include "image/pyramid.h"

#include <gtest/gtest.h>
#include <hwy/highway.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

namespace glide {
namespace {

// Float sums of 25 products of grey levels up to 255 round by less than this per level.
constexpr double kTolerance = 1e-3;

ImageU8 randomImage(int width, int height, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_int_distribution<int> grey(0, 255);
  ImageU8 image(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) image.at(x, y) = static_cast<std::uint8_t>(grey(random));
  }
  return image;
}

/// A plain image of doubles with clamped access: the reference implementation's only type.
struct NaiveImage {
  int width = 0, height = 0;
  std::vector<double> pixels;
  double clamped(int x, int y) const {
    const int cx = std::clamp(x, 0, width - 1);
    const int cy = std::clamp(y, 0, height - 1);
    return pixels[static_cast<std::size_t>(cy) * static_cast<std::size_t>(width) +
                  static_cast<std::size_t>(cx)];
  }
};

double naiveBlurAt(const NaiveImage& fine, int x, int y) {
  constexpr double kWeights[] = {1.0, 4.0, 6.0, 4.0, 1.0};
  double sum = 0.0;
  for (int k = 0; k < 25; ++k) {
    const int i = k % 5;
    const int j = k / 5;
    sum += kWeights[i] * kWeights[j] * fine.clamped(x + i - 2, y + j - 2);
  }
  return sum / 256.0;
}

NaiveImage naiveHalf(const NaiveImage& fine) {
  NaiveImage coarse{(fine.width + 1) / 2, (fine.height + 1) / 2, {}};
  for (int y = 0; y < coarse.height; ++y) {
    for (int x = 0; x < coarse.width; ++x) {
      coarse.pixels.push_back(naiveBlurAt(fine, 2 * x, 2 * y));
    }
  }
  return coarse;
}

NaiveImage naiveLevel0(const ImageU8& image) {
  NaiveImage level{image.width(), image.height(), {}};
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) level.pixels.push_back(image.at(x, y));
  }
  return level;
}

double worstDifference(const ImageF& image, const NaiveImage& naive) {
  double worst = 0.0;
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      worst = std::max(worst, std::abs(image.at(x, y) - naive.clamped(x, y)));
    }
  }
  return worst;
}

bool areEqual(const ImageF& a, const ImageF& b) {
  if (a.width() != b.width() || a.height() != b.height()) return false;
  for (int y = 0; y < a.height(); ++y) {
    if (!std::equal(a.row(y), a.row(y) + a.width(), b.row(y))) return false;
  }
  return true;
}

void expectMatchesNaive(const ImageU8& image, int levels) {
  Pyramid pyramid;
  buildPyramid(image.view(), levels, &pyramid);
  NaiveImage naive = naiveLevel0(image);
  for (std::size_t l = 0; l < pyramid.levels.size(); ++l) {
    if (l > 0) naive = naiveHalf(naive);
    ASSERT_EQ(pyramid.levels[l].width(), naive.width) << "level " << l;
    ASSERT_EQ(pyramid.levels[l].height(), naive.height) << "level " << l;
    EXPECT_LT(worstDifference(pyramid.levels[l], naive), kTolerance)
        << image.width() << "x" << image.height() << " level " << l;
  }
}

struct Size {
  int width, height;
};

class PyramidOfSize : public testing::TestWithParam<Size> {};

TEST_P(PyramidOfSize, EqualsNaiveBlurAndDecimation) {
  expectMatchesNaive(randomImage(GetParam().width, GetParam().height, 7), 6);
}

INSTANTIATE_TEST_SUITE_P(EvenOddAndTiny,
                         PyramidOfSize,
                         testing::Values(Size{752, 480},
                                         Size{641, 479},
                                         Size{321, 33},
                                         Size{63, 65},
                                         Size{17, 31},
                                         Size{16, 16},
                                         Size{15, 200},
                                         Size{8, 8},
                                         Size{3, 5},
                                         Size{1, 1}),
                         [](const auto& parameter) {
                           return std::to_string(parameter.param.width) + "x" +
                                  std::to_string(parameter.param.height);
                         });

TEST(Pyramid, EqualsNaiveOnEveryInstructionSet) {
  const ImageU8 image = randomImage(145, 77, 3);
  for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
    SCOPED_TRACE(hwy::TargetName(target));
    hwy::SetSupportedTargetsForTest(target);
    expectMatchesNaive(image, 4);
  }
  hwy::SetSupportedTargetsForTest(0);
}

TEST(Pyramid, KeepsAConstantImageConstantUpToTheBorders) {
  ImageU8 image(101, 67);
  for (int y = 0; y < image.height(); ++y) std::fill_n(image.row(y), image.width(), 200);
  Pyramid pyramid;
  buildPyramid(image.view(), 3, &pyramid);
  for (const ImageF& level : pyramid.levels) {
    for (int y = 0; y < level.height(); ++y) {
      for (int x = 0; x < level.width(); ++x) ASSERT_FLOAT_EQ(level.at(x, y), 200.0F);
    }
  }
}

TEST(Pyramid, PlacesPixelsOfALevelAtTwiceTheirCoordinates) {
  ImageU8 image(128, 64);
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) image.at(x, y) = static_cast<std::uint8_t>(x + y);
  }
  Pyramid pyramid;
  buildPyramid(image.view(), 3, &pyramid);
  EXPECT_NEAR(pyramid.levels[1].at(20, 10), 2 * (20 + 10), kTolerance);
  EXPECT_NEAR(pyramid.levels[2].at(12, 7), 4 * (12 + 7), kTolerance);
}

TEST(Pyramid, ReadsOnlyTheRowsOfABorrowedImage) {
  // Rows end where the buffer does: a read beyond them is caught by the address sanitizer.
  constexpr int kWidth = 37;
  constexpr int kHeight = 19;
  const ImageU8 image = randomImage(kWidth, kHeight, 11);
  std::vector<std::uint8_t> packed;
  for (int y = 0; y < kHeight; ++y) {
    packed.insert(packed.end(), image.row(y), image.row(y) + kWidth);
  }
  packed.shrink_to_fit();
  Pyramid from_packed;
  Pyramid from_padded;
  buildPyramid({packed.data(), kWidth, kHeight, kWidth}, 2, &from_packed);
  buildPyramid(image.view(), 2, &from_padded);
  EXPECT_TRUE(areEqual(from_packed.levels[0], from_padded.levels[0]));
  EXPECT_TRUE(areEqual(from_packed.levels[1], from_padded.levels[1]));
}

TEST(Pyramid, KeepsItsBuffersFromFrameToFrame) {
  Pyramid pyramid;
  buildPyramid(randomImage(200, 100, 1).view(), 4, &pyramid);
  std::vector<const float*> buffers;
  for (const ImageF& level : pyramid.levels) buffers.push_back(level.row(0));
  buildPyramid(randomImage(200, 100, 2).view(), 4, &pyramid);
  for (std::size_t l = 0; l < pyramid.levels.size(); ++l) {
    EXPECT_EQ(pyramid.levels[l].row(0), buffers[l]);
  }
}

TEST(Pyramid, StopsBeforeLevelsBelowEightPixels) {
  EXPECT_EQ(pyramidLevels(752, 480, 6), 6);
  EXPECT_EQ(pyramidLevels(752, 480, 8), 7);
  EXPECT_EQ(pyramidLevels(752, 480, 1), 1);
  EXPECT_EQ(pyramidLevels(16, 1000, 8), 2);
  EXPECT_EQ(pyramidLevels(15, 1000, 8), 2);
  EXPECT_EQ(pyramidLevels(14, 1000, 8), 1);
  EXPECT_EQ(pyramidLevels(5, 5, 8), 1);
}

}  // namespace
}  // namespace glide
