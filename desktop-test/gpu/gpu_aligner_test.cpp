#include "gpu/gpu_aligner.h"

#include "gpu/align_fixture.h"
#include "photometric/cpu_aligner.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>
#include <tuple>

namespace glide::test {
namespace {

using ::testing::HasSubstr;

/// Pose of the GPU against the CPU's: float against double, scene units and radians.
constexpr double kPoseTolerance = 1e-4;

GpuTuning tuningOf(int group_size) {
  GpuTuning tuning;
  tuning.group_size = group_size;
  return tuning;
}

class GpuAlignerTest : public GlTest {
 protected:
  AlignScene scene(const SE3d& T_cam_ref, const Exposure& exposure) const {
    return makeAlignScene({DistortionModel::radial_tangential,
                           imageWidth(),
                           imageHeight(),
                           pointCount(),
                           T_cam_ref,
                           exposure});
  }
  std::unique_ptr<Aligner> makeGpu(const Config::Direct& direct,
                                   const CameraModel& camera,
                                   int group_size) const {
    Result<std::unique_ptr<Aligner>> made =
        GpuAligner::createTuned(caps(), direct, camera, tuningOf(group_size));
    EXPECT_TRUE(made.ok()) << made.error().message;
    return std::move(*made);
  }
};

AlignResult alignScene(Aligner* aligner, const AlignScene& scene, const SE3d& T_cam_ref_guess) {
  aligner->loadFrame(scene.reference.view());
  aligner->promoteReference(scene.points_ref);
  aligner->loadFrame(scene.frame.view());
  return aligner->align(T_cam_ref_guess);
}

AlignResult alignOnCpu(const Config::Direct& direct, const AlignScene& scene) {
  Result<std::unique_ptr<CpuAligner>> cpu = CpuAligner::create(direct, scene.camera);
  EXPECT_TRUE(cpu.ok());
  return alignScene(cpu->get(), scene, SE3d{});
}

double poseDistance(const SE3d& T_a, const SE3d& T_b) { return (T_a.inverse() * T_b).log().norm(); }

void expectSameResult(const AlignResult& gpu, const AlignResult& cpu) {
  ASSERT_TRUE(gpu.valid);
  ASSERT_TRUE(cpu.valid);
  EXPECT_LT(poseDistance(gpu.T_cam_ref, cpu.T_cam_ref), kPoseTolerance);
  EXPECT_NEAR(gpu.gain, cpu.gain, 1e-3);
  EXPECT_NEAR(gpu.bias, cpu.bias, 0.1);
  EXPECT_NEAR(gpu.rms, cpu.rms, 0.05);
  EXPECT_NEAR(gpu.contrast, cpu.contrast, 0.05);
  EXPECT_EQ(gpu.points, cpu.points);
  EXPECT_NEAR(gpu.visible, cpu.visible, 1);
  EXPECT_NEAR(gpu.inliers, cpu.inliers, 3);
  EXPECT_LT((gpu.H - cpu.H).norm(), 0.01 * cpu.H.norm());
  EXPECT_GT(gpu.iterations[0], 0);
}

/// Scene units and radians; an image of 376 px has a pixel of 4e-3, softpipe's of 160 px one of
/// 1e-2.
double truthTolerance(bool slow) { return slow ? 5e-3 : 2e-3; }

/// (group size, patch size)
class GpuAlignerVariantTest : public GpuAlignerTest,
                              public ::testing::WithParamInterface<std::tuple<int, int>> {};

TEST_P(GpuAlignerVariantTest, GivesTheCpusPose) {
  const auto [group_size, patch_size] = GetParam();
  Config::Direct direct;
  direct.patch_size = patch_size;
  const AlignScene scene = this->scene(smallMotion(), Exposure{});
  const AlignResult gpu =
      alignScene(makeGpu(direct, scene.camera, group_size).get(), scene, SE3d{});
  expectSameResult(gpu, alignOnCpu(direct, scene));
  EXPECT_LT(poseDistance(gpu.T_cam_ref, scene.T_cam_ref), truthTolerance(isSlow()));
}

INSTANTIATE_TEST_SUITE_P(Variants,
                         GpuAlignerVariantTest,
                         ::testing::Combine(::testing::ValuesIn(kGroupSizes),
                                            ::testing::Values(7, 11)),
                         [](const auto& test) {
                           return "Group" + std::to_string(std::get<0>(test.param)) + "Patch" +
                                  std::to_string(std::get<1>(test.param));
                         });

TEST_F(GpuAlignerTest, GivesTheCpusPoseAtTheEndsOfTheConfigsRange) {
  const AlignScene scene = this->scene(smallMotion(), Exposure{});
  for (const auto& [patch_size, levels] : {std::pair{5, 8}, std::pair{15, 1}}) {
    Config::Direct direct;
    direct.patch_size = patch_size;
    direct.levels = levels;
    const AlignResult gpu = alignScene(makeGpu(direct, scene.camera, 64).get(), scene, SE3d{});
    expectSameResult(gpu, alignOnCpu(direct, scene));
  }
}

TEST_F(GpuAlignerTest, FollowsAChangeOfExposure) {
  for (const Exposure& exposure : {Exposure{0.6, 20.0}, Exposure{1.15, -12.0}}) {
    const AlignScene scene = this->scene(smallMotion(), exposure);
    const Config::Direct direct;
    const AlignResult gpu = alignScene(makeGpu(direct, scene.camera, 64).get(), scene, SE3d{});
    expectSameResult(gpu, alignOnCpu(direct, scene));
    EXPECT_NEAR(gpu.gain, exposure.gain, 0.03);
    EXPECT_LT(poseDistance(gpu.T_cam_ref, scene.T_cam_ref), truthTolerance(isSlow()));
  }
}

TEST_F(GpuAlignerTest, GivesTheCpusPoseWithAConstantHessianAndWithoutGain) {
  const AlignScene scene = this->scene(smallMotion(), Exposure{});
  for (const auto& [photometric, hessian] :
       {std::pair{PhotometricModel::none, HessianMode::robust},
        std::pair{PhotometricModel::gain_bias, HessianMode::constant}}) {
    Config::Direct direct;
    direct.photometric = photometric;
    direct.hessian = hessian;
    const AlignResult gpu = alignScene(makeGpu(direct, scene.camera, 64).get(), scene, SE3d{});
    expectSameResult(gpu, alignOnCpu(direct, scene));
  }
}

TEST_F(GpuAlignerTest, RepeatsTheSameBits) {
  const AlignScene scene = this->scene(smallMotion(), Exposure{1.1, 3.0});
  const Config::Direct direct;
  const std::unique_ptr<Aligner> first = makeGpu(direct, scene.camera, 64);
  const AlignResult a = alignScene(first.get(), scene, SE3d{});
  const AlignResult b = first->align(SE3d{});
  const AlignResult c = alignScene(makeGpu(direct, scene.camera, 64).get(), scene, SE3d{});
  for (const AlignResult& again : {b, c}) {
    EXPECT_EQ(again.T_cam_ref.q.coeffs(), a.T_cam_ref.q.coeffs());
    EXPECT_EQ(again.T_cam_ref.t, a.T_cam_ref.t);
    EXPECT_EQ(again.H, a.H);
    EXPECT_EQ(again.rms, a.rms);
    EXPECT_EQ(again.iterations, a.iterations);
  }
}

TEST_F(GpuAlignerTest, StopsIteratingOnceConverged) {
  const AlignScene scene = this->scene(SE3d{}, Exposure{});
  Config::Direct direct;
  direct.convergence = 1e-3;
  const AlignResult result = alignScene(makeGpu(direct, scene.camera, 64).get(), scene, SE3d{});
  ASSERT_TRUE(result.valid);
  EXPECT_EQ(result.iterations[0], 1);
  EXPECT_LT(result.rms, 0.1);
}

TEST_F(GpuAlignerTest, AlignsTheReferenceToItselfBeforeTheNextFrame) {
  const AlignScene scene = this->scene(SE3d{}, Exposure{});
  const std::unique_ptr<Aligner> gpu = makeGpu(Config::Direct{}, scene.camera, 64);
  gpu->loadFrame(scene.reference.view());
  EXPECT_FALSE(gpu->hasReference());
  EXPECT_FALSE(gpu->align(SE3d{}).valid);
  gpu->promoteReference(scene.points_ref);
  EXPECT_TRUE(gpu->hasReference());
  const AlignResult result = gpu->align(SE3d{});
  ASSERT_TRUE(result.valid);
  EXPECT_LT(poseDistance(result.T_cam_ref, SE3d{}), 1e-5);
}

TEST_F(GpuAlignerTest, IsInvalidWithTooFewPointsAndRecovers) {
  const AlignScene scene = this->scene(smallMotion(), Exposure{});
  const std::unique_ptr<Aligner> gpu = makeGpu(Config::Direct{}, scene.camera, 64);
  gpu->loadFrame(scene.reference.view());
  gpu->promoteReference({});
  EXPECT_FALSE(gpu->align(SE3d{}).valid);
  gpu->promoteReference(std::span(scene.points_ref).first(10));
  EXPECT_FALSE(gpu->align(SE3d{}).valid);
  EXPECT_TRUE(alignScene(gpu.get(), scene, SE3d{}).valid);
}

TEST_F(GpuAlignerTest, IsInvalidWhenTheGuessLooksAway) {
  const AlignScene scene = this->scene(smallMotion(), Exposure{});
  const std::unique_ptr<Aligner> gpu = makeGpu(Config::Direct{}, scene.camera, 64);
  Vec6d turn = Vec6d::Zero();
  turn[4] = 3.0;
  EXPECT_FALSE(alignScene(gpu.get(), scene, SE3d::exp(turn)).valid);
  EXPECT_TRUE(gpu->align(SE3d{}).valid);
}

TEST_F(GpuAlignerTest, IsInvalidOnABlankReference) {
  AlignScene scene = this->scene(smallMotion(), Exposure{});
  for (int y = 0; y < scene.reference.height(); ++y) {
    std::fill_n(scene.reference.row(y), scene.reference.width(), std::uint8_t{90});
  }
  const AlignResult result =
      alignScene(makeGpu(Config::Direct{}, scene.camera, 64).get(), scene, SE3d{});
  EXPECT_FALSE(result.valid);
  EXPECT_GT(result.points, 0);
}

TEST_F(GpuAlignerTest, LeavesOutPointsBeyondMaxPoints) {
  const AlignScene scene = this->scene(smallMotion(), Exposure{});
  Config::Direct direct;
  direct.max_points = pointCount() / 2;
  const AlignResult gpu = alignScene(makeGpu(direct, scene.camera, 64).get(), scene, SE3d{});
  expectSameResult(gpu, alignOnCpu(direct, scene));
  EXPECT_LE(gpu.points, direct.max_points);
}

TEST_F(GpuAlignerTest, MakesNoGlObjectAfterTheFirstFrame) {
  const AlignScene scene = this->scene(smallMotion(), Exposure{});
  const std::unique_ptr<Aligner> gpu = makeGpu(Config::Direct{}, scene.camera, 64);
  // Drivers hand out names in a fixed order: as many steps as calls of this means that nobody else
  // took one.
  const auto nextNames = [] {
    GLuint buffer = 0;
    GLuint texture = 0;
    glGenBuffers(1, &buffer);
    glGenTextures(1, &texture);
    glDeleteBuffers(1, &buffer);
    glDeleteTextures(1, &texture);
    return std::array{buffer, texture};
  };
  const auto first = nextNames();
  const auto second = nextNames();
  for (int i = 0; i < 3; ++i) EXPECT_TRUE(alignScene(gpu.get(), scene, SE3d{}).valid);
  const auto third = nextNames();
  for (std::size_t i = 0; i < first.size(); ++i) {
    EXPECT_EQ(third[i] - second[i], second[i] - first[i]);
  }
}

TEST_F(GpuAlignerTest, MeasuresItsStages) {
  const AlignScene scene = this->scene(smallMotion(), Exposure{});
  const std::unique_ptr<Aligner> gpu = makeGpu(Config::Direct{}, scene.camera, 64);
  alignScene(gpu.get(), scene, SE3d{});
  EXPECT_GT(gpu->times().pyramid_ms, 0.0);
  EXPECT_GT(gpu->times().precompute_ms, 0.0);
  EXPECT_GT(gpu->times().align_ms, 0.0);
}

TEST_F(GpuAlignerTest, NamesTheLimitThatAContextLacks) {
  const CameraModel camera = testCamera(DistortionModel::none, 376, 240);
  GlCaps small = caps();
  small.max_texture_size = 256;
  Result<std::unique_ptr<Aligner>> made = GpuAligner::create(small, Config::Direct{}, camera);
  ASSERT_FALSE(made.ok());
  EXPECT_EQ(made.error().code, ErrorCode::unsupported);
  EXPECT_THAT(made.error().message, HasSubstr("GL_MAX_TEXTURE_SIZE"));
  small = caps();
  small.max_storage_bytes = 1000;
  made = GpuAligner::create(small, Config::Direct{}, camera);
  ASSERT_FALSE(made.ok());
  EXPECT_THAT(made.error().message, HasSubstr("max_points"));
  made = GpuAligner::createTuned(caps(), Config::Direct{}, camera, tuningOf(48));
  ASSERT_FALSE(made.ok());
  EXPECT_THAT(made.error().message, HasSubstr("group_size"));
}

}  // namespace
}  // namespace glide::test
