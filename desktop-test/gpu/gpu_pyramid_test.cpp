#include "gpu/gpu_pyramid.h"

#include "gpu/gl_state.h"
#include "gpu/gl_test.h"
#include "gpu/luma_upload.h"

#include "image/pyramid.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace glide::test {
namespace {

constexpr int kLevels = 6;
constexpr float kTolerance = 0.01F;  // grey levels; both blur in float, in another order
constexpr PyramidKernel kKernels[] = {
    PyramidKernel::strip, PyramidKernel::tile, PyramidKernel::two_pass};

struct Variant {
  PyramidKernel kernel;
  int group_size;
};

std::vector<Variant> variants() {
  std::vector<Variant> all;
  for (const PyramidKernel kernel : kKernels) {
    for (const int group_size : kGroupSizes) all.push_back({kernel, group_size});
  }
  return all;
}

std::string nameOf(const Variant& variant) {
  const std::array<const char*, 3> names{"strip", "tile", "two_pass"};
  return std::string(names.at(static_cast<std::size_t>(variant.kernel))) + " with groups of " +
         std::to_string(variant.group_size);
}

GpuTuning tuningOf(const Variant& variant) {
  GpuTuning tuning;
  tuning.group_size = variant.group_size;
  tuning.pyramid = variant.kernel;
  return tuning;
}

class GpuPyramidTest : public GlTest {
 protected:
  /// Uploads `luma` and builds the levels.
  GpuPyramid build(const ImageViewU8& luma, const Variant& variant) {
    const ScopedGlState state(GlStatePolicy::preserve);
    const int levels = pyramidLevels(luma.width, luma.height, kLevels);
    GpuPyramid pyramid = GpuPyramid::allocate(luma.width, luma.height, levels);
    const Result<LumaUpload> upload =
        LumaUpload::create(luma.width, luma.height, variant.group_size, ProgramCache());
    const Result<PyramidPass> pass =
        PyramidPass::create(tuningOf(variant), pyramid, ProgramCache());
    EXPECT_TRUE(upload.ok() && pass.ok());
    upload->run(luma, pyramid.levels.front(), commands_);
    commands_.beginStage(GpuStage::pyramid);
    pass->run(pyramid, commands_);
    commands_.endStage();
    return pyramid;
  }

  GpuCommands commands_;
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

TEST_F(GpuPyramidTest, EqualsTheCpusForEveryKernelAndGroupSize) {
  const ImageU8 image = randomImage(imageWidth(), imageHeight(), 1);
  Pyramid cpu;
  buildPyramid(image.view(), kLevels, &cpu);
  for (const Variant& variant : variants()) {
    SCOPED_TRACE(nameOf(variant));
    expectSamePyramid(build(image.view(), variant), cpu);
  }
}

TEST_F(GpuPyramidTest, EqualsTheCpusForOddSizesAndForeignStrides) {
  for (const auto& [width, height] : {std::pair{161, 119}, std::pair{33, 57}, std::pair{9, 200}}) {
    SCOPED_TRACE(width);
    const ImageU8 image = randomImage(width + 3, height, 2);
    const ImageViewU8 cropped{image.row(0) + 1, width, height, image.stride()};
    Pyramid cpu;
    buildPyramid(cropped, kLevels, &cpu);
    for (const Variant& variant : variants()) {
      SCOPED_TRACE(nameOf(variant));
      expectSamePyramid(build(cropped, variant), cpu);
    }
  }
}

TEST_F(GpuPyramidTest, TakesOneDispatchALevelUnlessItIsThePapers) {
  const ImageU8 image = randomImage(imageWidth(), imageHeight(), 3);
  for (const PyramidKernel kernel : kKernels) {
    const Variant variant{kernel, 64};
    SCOPED_TRACE(nameOf(variant));
    const auto made = static_cast<int>(build(image.view(), variant).levels.size()) - 1;
    const int passes = kernel == PyramidKernel::two_pass ? 2 : 1;
    EXPECT_EQ(commands_.count(GpuStage::pyramid).dispatches, passes * made);
    EXPECT_EQ(commands_.count(GpuStage::pyramid).barriers, passes * made);
  }
}

TEST(PyramidKernelOfATuning, IsThePapersInThePapersPlanOnly) {
  GpuTuning tuning;
  tuning.pyramid = PyramidKernel::tile;
  EXPECT_EQ(pyramidKernel(tuning), PyramidKernel::tile);
  tuning.plan = GpuPlan::paper;
  EXPECT_EQ(pyramidKernel(tuning), PyramidKernel::two_pass);
}

}  // namespace
}  // namespace glide::test
