// Each alignment kernel against its scalar twin, for every group size and patch size.
#include "gpu/align_fixture.h"
#include "gpu/align_loop.h"
#include "gpu/align_twin.h"
#include "gpu/gl_state.h"
#include "gpu/gpu_reference.h"
#include "gpu/luma_upload.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <tuple>

namespace glide::test {
namespace {

constexpr int kLevels = 3;

/// Of the Cauchy-Schwarz bound of each sum: what float sums of a few hundred terms and a pixel
/// position in float leave.
constexpr double kSumTolerance = 1e-3;

/// (group size, patch size)
using Variant = std::tuple<int, int>;

class AlignKernelsTest : public GlTest, public ::testing::WithParamInterface<Variant> {
 protected:
  GpuAlignSpec spec(const CameraModel& camera) const {
    Config::Direct direct;
    std::tie(std::ignore, direct.patch_size) = GetParam();
    direct.max_points = pointCount() + 3;  // not a multiple of anything
    GpuTuning tuning;
    std::tie(tuning.group_size, std::ignore) = GetParam();
    return {direct, camera, kLevels, tuning};
  }
  AlignScene scene(DistortionModel model) const {
    return makeAlignScene(
        {model, imageWidth(), imageHeight(), pointCount(), smallMotion(), {1.2, -9.0}});
  }
};

/// The GPU's side of the kernels, fed with images.
struct KernelRig {
  GpuAlignSpec spec;
  GlBuffer constants;
  LumaUpload upload;
  GpuPyramid pyramid;
  PyramidPass pass;
  GpuReference reference;
  AlignLoop loop;
  AlignStateBuffer state = AlignStateBuffer::allocate();
  GpuCommands commands{};

  TrackInput input() const { return {pyramid, state}; }
  void load(const ImageU8& image) {
    upload.run(image.view(), pyramid.levels.front(), commands);
    pass.run(pyramid, commands);
  }
};

KernelRig makeRig(const GpuAlignSpec& spec) {
  const auto [width, height] = std::pair(spec.camera.width(), spec.camera.height());
  GlBuffer constants = makeBuffer(std::vector<GpuAlignConstants>{alignConstants(spec)});
  glBindBufferBase(GL_UNIFORM_BUFFER, 0, constants.get());
  GpuPyramid pyramid = GpuPyramid::allocate(width, height, spec.levels);
  PyramidPass pass = PyramidPass::create(spec.tuning, pyramid, spec.programs).value();
  return {spec,
          std::move(constants),
          LumaUpload::create(width, height, spec.tuning.group_size, spec.programs).value(),
          std::move(pyramid),
          std::move(pass),
          GpuReference::create(spec).value(),
          AlignLoop::create(spec).value()};
}

/// The twins of the points that the kernels run over at a level, in the kernels' order.
std::vector<TwinPoint> describeAll(const AlignScene& scene, const KernelRig& rig, int level) {
  const GpuAlignSpec& spec = rig.spec;
  const Pyramid pyramid = scene.referencePyramid(spec.levels);
  std::vector<TwinPoint> points;
  const auto count = static_cast<std::size_t>(rig.reference.order().count(level));
  for (const AlignPoint& point : rig.reference.order().points().first(count)) {
    points.push_back(describeTwin(pyramid.levels[static_cast<std::size_t>(level)],
                                  spec.camera.atLevel(level),
                                  point.p_ref,
                                  spec.direct.patch_size));
  }
  return points;
}

void expectClose(double actual, double expected, double bound) {
  EXPECT_NEAR(actual, expected, kSumTolerance * (bound + 1.0));
}

void expectSameRecord(const GpuPointRecord& gpu, const TwinPoint& twin) {
  ASSERT_EQ(gpu.p_ref[3] > 0.5F, twin.valid);
  if (!twin.valid) return;
  const double n = static_cast<double>(twin.pixels.size());
  EXPECT_NEAR(gpu.moments[0], twin.m0, 0.01);
  expectClose(gpu.moments[1], twin.E, twin.E);
  expectClose(gpu.moments[2], twin.Ex, std::sqrt(twin.E * twin.Gxx));
  expectClose(gpu.moments[3], twin.Ey, std::sqrt(twin.E * twin.Gyy));
  expectClose(gpu.gradients[0], twin.Gx, std::sqrt(n * twin.Gxx));
  expectClose(gpu.gradients[1], twin.Gy, std::sqrt(n * twin.Gyy));
  expectClose(gpu.gradients[2], twin.Gxx, twin.Gxx);
  expectClose(gpu.gradients[3], twin.Gxy, std::sqrt(twin.Gxx * twin.Gyy));
  expectClose(gpu.rest[0], twin.Gyy, twin.Gyy);
  for (int i = 0; i < 6; ++i) {
    EXPECT_NEAR(gpu.jx_jy[i], twin.Jx[i], 1e-4 * twin.Jx.norm());
    EXPECT_NEAR(gpu.jx_jy[6 + i], twin.Jy[i], 1e-4 * twin.Jy.norm());
  }
}

/// What the precompute kernel has written, read back.
struct CacheContents {
  std::vector<GpuPointRecord> records;
  std::vector<float> pixels;
};

void expectSamePixels(const CacheContents& cache,
                      const GpuAlignSpec& spec,
                      const TwinPoint& twin,
                      int level,
                      std::size_t point) {
  const int size = spec.direct.patch_size;
  const int row_pairs = (size + 1) / 2;
  for (int k = 0; k < size * size; ++k) {
    const int pair = (level * size + k / size) * row_pairs + k % size / 2;
    const Vec3d& pixel = twin.pixels[static_cast<std::size_t>(k)];
    for (int c = 0; c < kPixelFloats; ++c) {
      const int first = (pair * kPixelFloats + c) * spec.direct.max_points;
      const std::size_t at = 2 * (static_cast<std::size_t>(first) + point);
      ASSERT_NEAR(cache.pixels[at + static_cast<std::size_t>(k % size % 2)], pixel[c], 0.02);
    }
  }
}

/// Returns how many points are valid.
int expectSameLevel(const CacheContents& cache,
                    const GpuAlignSpec& spec,
                    const std::vector<TwinPoint>& twins,
                    int level) {
  int valid = 0;
  for (std::size_t i = 0; i < twins.size(); ++i) {
    SCOPED_TRACE(i);
    const int first = level * spec.direct.max_points;
    expectSameRecord(cache.records[static_cast<std::size_t>(first) + i], twins[i]);
    if (!twins[i].valid) continue;
    expectSamePixels(cache, spec, twins[i], level, i);
    ++valid;
  }
  return valid;
}

TEST_P(AlignKernelsTest, PrecomputeMatchesTwinOnEveryLevel) {
  const AlignScene scene = this->scene(DistortionModel::radial_tangential);
  const GpuAlignSpec spec = this->spec(scene.camera);
  const ScopedGlState state(GlStatePolicy::preserve);
  KernelRig rig = makeRig(spec);
  rig.load(scene.reference);
  rig.reference.precompute(rig.pyramid, scene.points_ref, rig.commands);
  const CacheContents cache{readBuffer<GpuPointRecord>(rig.reference.records()),
                            readBuffer<float>(rig.reference.pixels())};
  int valid = 0;
  for (int level = 0; level < kLevels; ++level) {
    valid += expectSameLevel(cache, spec, describeAll(scene, rig, level), level);
  }
  EXPECT_GT(valid, pointCount());
}

void expectSameSums(const GpuPointSums& gpu, const TwinPoint& p, const TwinSums& twin) {
  ASSERT_EQ(gpu.rest[1] > 0.5F, twin.visible);
  const double n = static_cast<double>(p.pixels.size());
  expectClose(gpu.intensity[0], twin.s1, std::sqrt(n * twin.s2));
  expectClose(gpu.intensity[1], twin.s2, twin.s2);
  expectClose(gpu.intensity[2], twin.sc, std::sqrt(twin.s2 * p.E));
  expectClose(gpu.intensity[3], twin.sx, std::sqrt(twin.s2 * p.Gxx));
  expectClose(gpu.rest[0], twin.sy, std::sqrt(twin.s2 * p.Gyy));
}

TEST_P(AlignKernelsTest, ResidualSumsMatchTwinOnEveryLevel) {
  const AlignScene scene = this->scene(DistortionModel::kannala_brandt4);
  const GpuAlignSpec spec = this->spec(scene.camera);
  const ScopedGlState state(GlStatePolicy::preserve);
  KernelRig rig = makeRig(spec);
  rig.load(scene.reference);
  rig.reference.precompute(rig.pyramid, scene.points_ref, rig.commands);
  rig.load(scene.frame);
  const Pyramid frame = scene.framePyramid(kLevels);
  for (int level = 0; level < kLevels; ++level) {
    rig.state.start(scene.T_cam_ref);
    rig.loop.residual(rig.input(), rig.reference, level, rig.commands);
    const auto sums = readBuffer<GpuPointSums>(rig.loop.sums());
    const std::vector<TwinPoint> points = describeAll(scene, rig, level);
    const ImageF& image = frame.levels[static_cast<std::size_t>(level)];
    int visible = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      SCOPED_TRACE(i);
      const TwinSums twin = sumTwin(image, spec.camera.atLevel(level), scene.T_cam_ref, points[i]);
      expectSameSums(sums[i], points[i], twin);
      visible += twin.visible ? 1 : 0;
    }
    EXPECT_GT(visible, pointCount() / 4) << "level " << level;
  }
}

template <class T>
void overwrite(const GlBuffer& buffer, const std::vector<T>& values) {
  buffer.write(values.data(), static_cast<std::int64_t>(values.size() * sizeof(T)));
}

void expectSameSolution(const AlignResult& gpu, const TwinState& twin) {
  ASSERT_TRUE(gpu.valid);
  EXPECT_EQ(gpu.visible, twin.visible);
  EXPECT_NEAR(gpu.inliers, twin.inliers, 1);  // one error may lie on the threshold
  EXPECT_NEAR(gpu.gain, twin.gain, 1e-4);
  EXPECT_NEAR(gpu.bias, twin.bias, 1e-2);
  EXPECT_NEAR(gpu.rms, twin.rms, 1e-2);
  EXPECT_NEAR(gpu.contrast, twin.contrast, 1e-2);
  EXPECT_LT((gpu.H - twin.H).norm(), 1e-3 * twin.H.norm());
  const Vec6d error = (twin.T_cam_ref.inverse() * gpu.T_cam_ref).log();
  EXPECT_LT(error.norm(), 1e-3 * twin.delta.norm() + 2e-6);
}

/// One iteration: the twin's sums go in, so that only the solve kernel is compared.
void solveBoth(KernelRig& rig,
               const Config::Direct& direct,
               const std::vector<TwinPoint>& points,
               const std::vector<TwinSums>& sums,
               TwinState* twin) {
  std::vector<GpuPointSums> packed;
  std::transform(sums.begin(), sums.end(), std::back_inserter(packed), packSums);
  for (std::size_t i = 0; i < packed.size(); ++i) {
    packed[i].rest[2] = static_cast<float>(twin->weights[i]);
  }
  overwrite(rig.loop.sums(), packed);
  rig.loop.solve(rig.input(), rig.reference, 0, rig.commands);
  const AlignResult gpu = toResult(readBuffer<GpuAlignState>(rig.state.buffer()).front());
  ASSERT_TRUE(solveTwin(points, sums, direct, twin));
  expectSameSolution(gpu, *twin);
  const auto after = readBuffer<GpuPointSums>(rig.loop.sums());
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_NEAR(after[i].rest[2], twin->weights[i], 1e-3);
  }
  twin->T_cam_ref = gpu.T_cam_ref;  // both go on from the same pose
}

/// Three iterations on level 0, from records and sums of the twin.
void expectSameIterations(const AlignScene& scene, const GpuAlignSpec& spec) {
  const ScopedGlState state(GlStatePolicy::preserve);
  KernelRig rig = makeRig(spec);
  rig.load(scene.reference);
  rig.reference.precompute(
      rig.pyramid, scene.points_ref, rig.commands);  // for the number of points
  const std::vector<TwinPoint> points = describeAll(scene, rig, 0);
  std::vector<GpuPointRecord> records;
  std::transform(points.begin(), points.end(), std::back_inserter(records), packRecord);
  overwrite(rig.reference.records(), records);

  const Pyramid frame = scene.framePyramid(1);
  TwinState twin;
  twin.weights.assign(points.size(), 1.0);
  rig.state.start(twin.T_cam_ref);
  for (int iteration = 1; iteration <= 3; ++iteration) {
    SCOPED_TRACE(iteration);
    std::vector<TwinSums> sums;
    std::transform(points.begin(), points.end(), std::back_inserter(sums), [&](const auto& p) {
      return sumTwin(frame.levels[0], scene.camera, twin.T_cam_ref, p);
    });
    solveBoth(rig, spec.direct, points, sums, &twin);
  }
}

TEST_P(AlignKernelsTest, SolveMatchesTwinOverThreeIterations) {
  const AlignScene scene = this->scene(DistortionModel::none);
  for (const auto& [photometric, hessian] :
       {std::pair{PhotometricModel::gain_bias, HessianMode::robust},
        std::pair{PhotometricModel::gain_bias, HessianMode::constant},
        std::pair{PhotometricModel::none, HessianMode::robust}}) {
    GpuAlignSpec spec = this->spec(scene.camera);
    spec.direct.photometric = photometric;
    spec.direct.hessian = hessian;
    spec.direct.convergence = 1e-12;  // never ends the level
    expectSameIterations(scene, spec);
  }
}

INSTANTIATE_TEST_SUITE_P(Variants,
                         AlignKernelsTest,
                         ::testing::Combine(::testing::ValuesIn(kGroupSizes),
                                            ::testing::Values(7, 11)),
                         [](const auto& test) {
                           return "Group" + std::to_string(std::get<0>(test.param)) + "Patch" +
                                  std::to_string(std::get<1>(test.param));
                         });

}  // namespace
}  // namespace glide::test
