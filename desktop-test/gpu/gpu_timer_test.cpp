#include "gpu/gpu_timer.h"

#include "gpu/align_fixture.h"
#include "gpu/gpu_aligner.h"

namespace glide::test {
namespace {

constexpr GpuStage kStages[] = {
    GpuStage::upload, GpuStage::pyramid, GpuStage::precompute, GpuStage::track, GpuStage::readback};

class GpuTimerTest : public GlTest {
 protected:
  /// A reference and a frame on an aligner with such a timer; without timer queries on request.
  std::unique_ptr<GpuAligner> timedFrame(GpuTiming timing, StageTimer clock) const {
    const AlignScene scene = makeAlignScene(
        {DistortionModel::none, imageWidth(), imageHeight(), pointCount(), smallMotion(), {}});
    GlCaps known = caps();
    known.has_timer_query = known.has_timer_query && clock == StageTimer::query;
    auto aligner = GpuAligner::createWith(
        known, Config::Direct{}, scene.camera, GpuTuning{}, {timing, GlStatePolicy::preserve});
    EXPECT_TRUE(aligner.ok());
    (*aligner)->loadFrame(scene.reference.view());
    (*aligner)->promoteReference(scene.points_ref);
    (*aligner)->loadFrame(scene.frame.view());
    EXPECT_TRUE((*aligner)->align(SE3d{}).valid);
    return std::move(*aligner);
  }
};

TEST_F(GpuTimerTest, TimesEveryStageWhateverTheClock) {
  for (const StageTimer clock : {StageTimer::query, StageTimer::sync}) {
    const auto aligner = timedFrame(GpuTiming::stages, clock);
    for (const GpuStage stage : kStages) EXPECT_GT(aligner->stageTimes().stageMs(stage), 0.0);
    EXPECT_EQ(aligner->stageTimes().levelMs(0), 0.0);
  }
}

TEST_F(GpuTimerTest, LooksAtLevelsWhenAsked) {
  for (const StageTimer clock : {StageTimer::query, StageTimer::sync}) {
    const auto aligner = timedFrame(GpuTiming::levels, clock);
    const GpuTimer& times = aligner->stageTimes();
    double sum_ms = 0.0;
    for (int level = 0; level < kMaxAlignLevels; ++level) sum_ms += times.levelMs(level);
    EXPECT_GT(times.levelMs(0), 0.0);
    EXPECT_GT(sum_ms, 0.5 * times.stageMs(GpuStage::track));
    EXPECT_LE(sum_ms, times.stageMs(GpuStage::track));
  }
}

TEST_F(GpuTimerTest, GivesTheTrackersTheTimeOfTheWaitWithoutQueries) {
  const auto aligner = timedFrame(GpuTiming::passive, StageTimer::sync);
  const GpuTimer& times = aligner->stageTimes();
  EXPECT_FALSE(times.usesQueries());
  EXPECT_DOUBLE_EQ(times.times().align_ms,
                   times.stageMs(GpuStage::track) + times.stageMs(GpuStage::readback));
  EXPECT_DOUBLE_EQ(times.times().pyramid_ms,
                   times.stageMs(GpuStage::upload) + times.stageMs(GpuStage::pyramid));
}

}  // namespace
}  // namespace glide::test
