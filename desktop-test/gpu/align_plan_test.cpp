// The plans against each other and against the CPU: what they compute and how many commands they
// take.
#include "gpu/align_fixture.h"
#include "gpu/gpu_aligner.h"
#include "photometric/cpu_aligner.h"

#include <gtest/gtest.h>

#include <limits>

namespace glide::test {
namespace {

/// Poses of one scene, scene units and radians.
constexpr double kPoseTolerance = 1e-4;

/// What the paper's plan computes.
Config::Direct paperMode() {
  Config::Direct direct;
  direct.photometric = PhotometricModel::none;
  direct.hessian = HessianMode::constant;
  return direct;
}

AlignResult alignScene(Aligner* aligner, const AlignScene& scene) {
  EXPECT_TRUE(aligner->loadFrame(scene.reference.view()).ok());
  aligner->promoteReference(scene.points_ref);
  EXPECT_TRUE(aligner->loadFrame(scene.frame.view()).ok());
  return aligner->align(SE3d{});
}

double poseDistance(const SE3d& T_a, const SE3d& T_b) { return (T_a.inverse() * T_b).log().norm(); }

void expectSameResult(const AlignResult& gpu, const AlignResult& cpu) {
  ASSERT_TRUE(gpu.valid);
  ASSERT_TRUE(cpu.valid);
  EXPECT_LT(poseDistance(gpu.T_cam_ref, cpu.T_cam_ref), kPoseTolerance);
  EXPECT_NEAR(gpu.rms, cpu.rms, 0.05);
  EXPECT_NEAR(gpu.contrast, cpu.contrast, 0.05);
  EXPECT_EQ(gpu.points, cpu.points);
  EXPECT_NEAR(gpu.visible, cpu.visible, 1);
  EXPECT_NEAR(gpu.inliers, cpu.inliers, 3);
  EXPECT_LT((gpu.H - cpu.H).norm(), 0.01 * cpu.H.norm());
}

struct PlanCommands {
  int dispatches = 0, barriers = 0;
};

PlanCommands countStages(const GpuCommands& commands, std::initializer_list<GpuStage> stages) {
  PlanCommands sum;
  for (const GpuStage stage : stages) {
    sum.dispatches += commands.count(stage).dispatches;
    sum.barriers += commands.count(stage).barriers;
  }
  return sum;
}

void expectAThird(const PlanCommands& fused, const PlanCommands& paper) {
  EXPECT_GT(fused.dispatches, 0);
  EXPECT_LE(3 * fused.dispatches, paper.dispatches);
  EXPECT_LE(3 * fused.barriers, paper.barriers);
}

class AlignPlanTest : public GlTest {
 protected:
  AlignScene scene() const {
    return makeAlignScene({DistortionModel::radial_tangential,
                           imageWidth(),
                           imageHeight(),
                           pointCount(),
                           smallMotion(),
                           Exposure{}});
  }
  std::unique_ptr<GpuAligner> make(const Config::Direct& direct, const GpuTuning& tuning) const {
    auto made = GpuAligner::createWith(
        caps(),
        direct,
        testCamera(DistortionModel::radial_tangential, imageWidth(), imageHeight()),
        tuning,
        GpuRunOptions{});
    EXPECT_TRUE(made.ok()) << made.error().message;
    return std::move(*made);
  }
  static GpuTuning paperTuning(int group_size) {
    GpuTuning tuning;
    tuning.group_size = group_size;
    tuning.plan = GpuPlan::paper;
    return tuning;
  }
  /// Cuts the levels of the test's images as the default does those of 752 x 480.
  GpuTuning fusedTuning() const {
    GpuTuning tuning;
    tuning.single_group_pixels =
        tuning.single_group_pixels * imageWidth() * imageHeight() / (752 * 480);
    return tuning;
  }
};

AlignResult alignOnCpu(const Config::Direct& direct, const AlignScene& scene) {
  Result<std::unique_ptr<CpuAligner>> cpu = CpuAligner::create(direct, scene.camera);
  EXPECT_TRUE(cpu.ok());
  return alignScene(cpu->get(), scene);
}

TEST_F(AlignPlanTest, PaperGivesTheCpusPoseWithoutWeightsAndGain) {
  const AlignScene scene = this->scene();
  for (const int patch_size : {7, 11}) {
    Config::Direct direct = paperMode();
    direct.patch_size = patch_size;
    const AlignResult cpu = alignOnCpu(direct, scene);
    for (const int group_size : kGroupSizes) {
      SCOPED_TRACE(group_size);
      expectSameResult(alignScene(make(direct, paperTuning(group_size)).get(), scene), cpu);
    }
  }
}

TEST_F(AlignPlanTest, BothPlansGiveTheSamePoseWithoutWeightsAndGain) {
  const AlignScene scene = this->scene();
  const AlignResult paper = alignScene(make(paperMode(), paperTuning(64)).get(), scene);
  const AlignResult fused = alignScene(make(paperMode(), fusedTuning()).get(), scene);
  ASSERT_TRUE(paper.valid && fused.valid);
  EXPECT_LT(poseDistance(paper.T_cam_ref, fused.T_cam_ref), kPoseTolerance);
}

TEST_F(AlignPlanTest, FusedTakesAThirdOfThePapersCommands) {
  const AlignScene scene = this->scene();
  const std::unique_ptr<GpuAligner> paper = make(Config::Direct{}, paperTuning(64));
  const std::unique_ptr<GpuAligner> fused = make(Config::Direct{}, fusedTuning());
  alignScene(paper.get(), scene);
  alignScene(fused.get(), scene);
  const auto third = [&](std::initializer_list<GpuStage> stages) {
    expectAThird(countStages(fused->commands(), stages), countStages(paper->commands(), stages));
  };
  third({GpuStage::track});
  third({GpuStage::upload, GpuStage::pyramid, GpuStage::track, GpuStage::readback});
  third({GpuStage::upload,
         GpuStage::pyramid,
         GpuStage::precompute,
         GpuStage::track,
         GpuStage::readback});
}

TEST_F(AlignPlanTest, PaperDoesAllIterationsAndRepeatsTheSameBits) {
  const AlignScene scene = this->scene();
  Config::Direct direct;
  direct.max_iterations = 4;
  direct.levels = 3;
  direct.convergence = 0.1;
  const std::unique_ptr<GpuAligner> paper = make(direct, paperTuning(64));
  const AlignResult first = alignScene(paper.get(), scene);
  const AlignResult second = paper->align(SE3d{});
  for (int level = 0; level < direct.levels; ++level) {
    EXPECT_EQ(first.iterations[static_cast<std::size_t>(level)], direct.max_iterations);
  }
  EXPECT_EQ(first.T_cam_ref.q.coeffs(), second.T_cam_ref.q.coeffs());
  EXPECT_EQ(first.T_cam_ref.t, second.T_cam_ref.t);
  EXPECT_EQ(first.H, second.H);
  EXPECT_EQ(first.rms, second.rms);
}

TEST_F(AlignPlanTest, PaperIsInvalidWithTooFewPointsAndRecovers) {
  const AlignScene scene = this->scene();
  const std::unique_ptr<GpuAligner> paper = make(paperMode(), paperTuning(64));
  EXPECT_TRUE(paper->loadFrame(scene.reference.view()).ok());
  paper->promoteReference({});
  EXPECT_FALSE(paper->align(SE3d{}).valid);
  paper->promoteReference(std::span(scene.points_ref).first(10));
  EXPECT_FALSE(paper->align(SE3d{}).valid);
  EXPECT_TRUE(alignScene(paper.get(), scene).valid);
}

TEST_F(AlignPlanTest, FusedGivesTheCpusPoseWhicheverLevelsIterateInOneWorkgroup) {
  const AlignScene scene = this->scene();
  const AlignResult cpu = alignOnCpu(Config::Direct{}, scene);
  for (const int group_size : kGroupSizes) {
    for (const int pixels : {0, std::numeric_limits<int>::max()}) {
      SCOPED_TRACE(::testing::Message() << "group " << group_size << " pixels " << pixels);
      GpuTuning tuning;
      tuning.group_size = group_size;
      tuning.single_group_pixels = pixels;
      const std::unique_ptr<GpuAligner> fused = make(Config::Direct{}, tuning);
      const AlignResult gpu = alignScene(fused.get(), scene);
      expectSameResult(gpu, cpu);
      EXPECT_EQ(fused->align(SE3d{}).T_cam_ref.t, gpu.T_cam_ref.t);
    }
  }
}

TEST_F(AlignPlanTest, FusedInOneWorkgroupALevelIsInvalidWithTooFewPointsAndRecovers) {
  const AlignScene scene = this->scene();
  GpuTuning tuning;
  tuning.single_group_pixels = std::numeric_limits<int>::max();
  const std::unique_ptr<GpuAligner> fused = make(Config::Direct{}, tuning);
  EXPECT_TRUE(fused->loadFrame(scene.reference.view()).ok());
  fused->promoteReference(std::span(scene.points_ref).first(10));
  EXPECT_FALSE(fused->align(SE3d{}).valid);
  EXPECT_TRUE(alignScene(fused.get(), scene).valid);
}

}  // namespace
}  // namespace glide::test
