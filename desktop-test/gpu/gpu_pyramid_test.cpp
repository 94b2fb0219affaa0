#include "gpu/gpu_pyramid.h"

#include "gpu/gl_state.h"
#include "gpu/gl_test.h"
#include "gpu/luma_upload.h"

#include "image/pyramid.h"

#include <gtest/gtest.h>

#include <cmath>

namespace glide::test {
namespace {

constexpr int kLevels = 6;
constexpr float kTolerance = 0.01F;  // grey levels; both blur in float, in another order

class GpuPyramidTest : public GlTest {
 protected:
  /// Uploads `luma` and builds the levels.
  GpuPyramid build(const ImageViewU8& luma, int group_size) const {
    const ScopedGlState state(GlStatePolicy::preserve);
    const int levels = pyramidLevels(luma.width, luma.height, kLevels);
    GpuPyramid pyramid = GpuPyramid::allocate(luma.width, luma.height, levels);
    const Result<LumaUpload> upload = LumaUpload::create(luma.width, luma.height, group_size);
    const Result<PyramidPass> pass = PyramidPass::create(group_size);
    EXPECT_TRUE(upload.ok() && pass.ok());
    GpuCommands commands;
    upload->run(luma, pyramid.levels.front(), commands);
    pass->run(pyramid, commands);
    return pyramid;
  }
};

float largestDifference(const ImageF& a, const ImageF& b) {
  float largest = 0.0F;
  for (int y = 0; y < a.height(); ++y) {
    for (int x = 0; x < a.width(); ++x)
      largest = std::max(largest, std::abs(a.at(x, y) - b.at(x, y)));
  }
  return largest;
}

void expectSamePyramid(const GpuPyramid& gpu, const Pyramid& cpu) {
  ASSERT_EQ(gpu.levels.size(), cpu.levels.size());
  for (std::size_t l = 0; l < cpu.levels.size(); ++l) {
    const ImageF level = readTexture(gpu.levels[l]);
    ASSERT_EQ(level.width(), cpu.levels[l].width()) << "level " << l;
    ASSERT_EQ(level.height(), cpu.levels[l].height()) << "level " << l;
    const float tolerance = l == 0 ? 0.0F : kTolerance;
    EXPECT_LE(largestDifference(level, cpu.levels[l]), tolerance) << "level " << l;
  }
}

TEST_F(GpuPyramidTest, EqualsTheCpusForEveryGroupSize) {
  const ImageU8 image = randomImage(imageWidth(), imageHeight(), 1);
  Pyramid cpu;
  buildPyramid(image.view(), kLevels, &cpu);
  for (const int group_size : kGroupSizes) {
    SCOPED_TRACE(group_size);
    expectSamePyramid(build(image.view(), group_size), cpu);
  }
}

TEST_F(GpuPyramidTest, EqualsTheCpusForOddSizesAndForeignStrides) {
  for (const auto& [width, height] : {std::pair{161, 119}, std::pair{33, 57}, std::pair{9, 200}}) {
    SCOPED_TRACE(width);
    const ImageU8 image = randomImage(width + 3, height, 2);
    const ImageViewU8 cropped{image.row(0) + 1, width, height, image.stride()};
    Pyramid cpu;
    buildPyramid(cropped, kLevels, &cpu);
    expectSamePyramid(build(cropped, 64), cpu);
  }
}

}  // namespace
}  // namespace glide::test
