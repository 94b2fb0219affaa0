#include "photometric/patch_kernels.h"

#include "unit/photometric/align_fixture.h"

#include "photometric/aligned_vector.h"

#include <gtest/gtest.h>
#include <hwy/highway.h>

#include <cmath>
#include <random>
#include <vector>

namespace glide {
namespace {

using test::bilinear;

ImageF randomImage(int width, int height, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> grey(0.0F, 255.0F);
  ImageF image(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) image.at(x, y) = grey(random);
  }
  return image;
}

/// One reference patch as the derivation page says it, in double.
struct PlainPatch {
  std::vector<double> e, gx, gy;
  double mean = 0.0;
};

PlainPatch plainPatch(const ImageF& image, double u, double v, int size) {
  PlainPatch patch;
  for (int k = 0; k < size * size; ++k) {
    const Vec2d offset = test::patchOffset(k, size);
    const double x = u + offset.x();
    const double y = v + offset.y();
    patch.e.push_back(bilinear(image, x, y));
    patch.gx.push_back((bilinear(image, x + 1, y) - bilinear(image, x - 1, y)) / 2);
    patch.gy.push_back((bilinear(image, x, y + 1) - bilinear(image, x, y - 1)) / 2);
    patch.mean += patch.e.back() / (size * size);
  }
  for (double& e : patch.e) e -= patch.mean;
  return patch;
}

double dot(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

/// Sums of up to 225 products of grey levels, in float.
double tolerance(int size) { return 0.02 * size * size; }

void expectMomentsMatch(const PatchMoments& moments, const PlainPatch& plain, int size) {
  const std::vector<double> ones(plain.e.size(), 1.0);
  EXPECT_NEAR(moments.mean, plain.mean, 1e-3);
  EXPECT_NEAR(moments.e_e, dot(plain.e, plain.e), tolerance(size));
  EXPECT_NEAR(moments.gx_gx, dot(plain.gx, plain.gx), tolerance(size));
  EXPECT_NEAR(moments.gx_gy, dot(plain.gx, plain.gy), tolerance(size));
  EXPECT_NEAR(moments.gy_gy, dot(plain.gy, plain.gy), tolerance(size));
  EXPECT_NEAR(moments.gx, dot(plain.gx, ones), tolerance(size));
  EXPECT_NEAR(moments.gy, dot(plain.gy, ones), tolerance(size));
  EXPECT_NEAR(moments.gx_e, dot(plain.gx, plain.e), tolerance(size));
  EXPECT_NEAR(moments.gy_e, dot(plain.gy, plain.e), tolerance(size));
}

void expectSumsMatch(const PatchSums& sums,
                     const std::vector<double>& frame,
                     const PlainPatch& plain,
                     int size) {
  const std::vector<double> ones(plain.e.size(), 1.0);
  EXPECT_NEAR(sums.s1, dot(frame, ones), tolerance(size));
  EXPECT_NEAR(sums.s2, dot(frame, frame), tolerance(size));
  EXPECT_NEAR(sums.sc, dot(frame, plain.e), tolerance(size));
  EXPECT_NEAR(sums.sx, dot(frame, plain.gx), tolerance(size));
  EXPECT_NEAR(sums.sy, dot(frame, plain.gy), tolerance(size));
}

/// Caches random patches of one image, one at each extreme of the valid range among them, and
/// compares them with another image.
void expectKernelsMatchPlainCode(int size) {
  const ImageF reference = randomImage(53, 41, 1);
  const ImageF frame = randomImage(53, 41, 2);
  const PatchLayout layout = PatchLayout::ofSize(size);
  const int half = size / 2;
  std::mt19937 random(3);
  std::uniform_real_distribution<double> along_x(half + 1, reference.width() - half - 2.01);
  std::uniform_real_distribution<double> along_y(half + 1, reference.height() - half - 2.01);
  std::vector<Vec2d> pixels{
      Vec2d(half + 1, half + 1),
      Vec2d(reference.width() - half - 2.01, reference.height() - half - 2.01)};
  for (int i = 0; i < 10; ++i) pixels.push_back({along_x(random), along_y(random)});

  std::vector<PatchSite> sites;
  sites.reserve(pixels.size());
  for (const Vec2d& uv : pixels) sites.push_back(PatchSite::around(uv.x(), uv.y(), half));
  AlignedVector<float> blocks(sites.size() * layout.blockSize(), NAN);
  std::vector<PatchMoments> moments(sites.size());
  cachePatches(reference, layout, sites, {blocks.data(), moments.data()});

  std::vector<PatchProbe> probes;
  for (std::size_t i = 0; i < sites.size(); ++i) {
    const std::size_t other = sites.size() - 1 - i;
    probes.push_back({sites[other], moments[i].mean, blocks.data() + i * layout.blockSize()});
  }
  std::vector<PatchSums> sums(probes.size());
  sumPatches(frame, layout, probes, sums.data());

  for (std::size_t i = 0; i < sites.size(); ++i) {
    const PlainPatch plain = plainPatch(reference, pixels[i].x(), pixels[i].y(), size);
    expectMomentsMatch(moments[i], plain, size);
    const Vec2d& uv = pixels[sites.size() - 1 - i];
    const PlainPatch seen = plainPatch(frame, uv.x(), uv.y(), size);
    std::vector<double> values = seen.e;
    for (double& value : values) value += seen.mean - plain.mean;
    expectSumsMatch(sums[i], values, plain, size);
  }
}

class PatchKernelsOfSize : public testing::TestWithParam<int> {};

TEST_P(PatchKernelsOfSize, MatchPlainCodeOnEveryInstructionSet) {
  for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
    SCOPED_TRACE(hwy::TargetName(target));
    hwy::SetSupportedTargetsForTest(target);
    expectKernelsMatchPlainCode(GetParam());
  }
  hwy::SetSupportedTargetsForTest(0);
}

INSTANTIATE_TEST_SUITE_P(OddSizes, PatchKernelsOfSize, testing::Values(3, 5, 7, 9, 11, 13, 15));

TEST(PatchKernels, PadTheirRowsWithZeros) {
  const ImageF image = randomImage(40, 40, 4);
  const PatchLayout layout = PatchLayout::ofSize(11);
  AlignedVector<float> block(layout.blockSize(), NAN);
  PatchMoments moments;
  const std::vector<PatchSite> sites{PatchSite::around(20.3, 19.8, 5)};
  cachePatches(image, layout, sites, {block.data(), &moments});
  for (int row = 0; row < 3 * layout.size; ++row) {
    for (int c = layout.size; c < layout.stride; ++c) {
      ASSERT_EQ(block[static_cast<std::size_t>(row * layout.stride + c)], 0.0F);
    }
  }
}

TEST(PatchKernels, IgnoreWhatLiesBesideAPatch) {
  // Vectors are longer than a patch row; even a NaN beyond it must not count.
  ImageF image = randomImage(64, 40, 5);
  const PatchLayout layout = PatchLayout::ofSize(7);
  AlignedVector<float> block(layout.blockSize());
  PatchMoments moments;
  const std::vector<PatchSite> sites{PatchSite::around(20.5, 20.5, 3)};
  cachePatches(image, layout, sites, {block.data(), &moments});
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 25; x < image.width(); ++x) image.at(x, y) = NAN;
  }
  const std::vector<PatchProbe> probes{{sites[0], moments.mean, block.data()}};
  PatchSums sums;
  sumPatches(image, layout, probes, &sums);
  EXPECT_NEAR(sums.s1, 0.0F, 0.05F);
  EXPECT_NEAR(sums.s2, moments.e_e, tolerance(7));
  EXPECT_NEAR(sums.sc, moments.e_e, tolerance(7));
}

}  // namespace
}  // namespace glide
