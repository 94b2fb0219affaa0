#include "e2e/run_matchers.h"

#include <gtest/gtest.h>

#include <string>

namespace glide::test {
namespace {

constexpr int kFrames = 90;

void expectSameAnswer(const FrameResult& a, const FrameResult& b) {
  EXPECT_EQ(a.t_ns, b.t_ns);
  EXPECT_EQ(a.state, b.state);
  EXPECT_EQ(a.tracker, b.tracker);
  EXPECT_EQ(a.switch_reason, b.switch_reason);
  EXPECT_EQ(a.T_world_cam.t_xyz, b.T_world_cam.t_xyz);
  EXPECT_EQ(a.T_world_cam.q_xyzw, b.T_world_cam.q_xyzw);
  EXPECT_EQ(a.reference_keyframe, b.reference_keyframe);
  EXPECT_EQ(a.T_ref_cam.t_xyz, b.T_ref_cam.t_xyz);
  EXPECT_EQ(a.T_ref_cam.q_xyzw, b.T_ref_cam.q_xyzw);
  EXPECT_EQ(a.confidence, b.confidence);
  EXPECT_EQ(a.map_revision, b.map_revision);
  EXPECT_EQ(a.stats.keyframe, b.stats.keyframe);
  EXPECT_EQ(a.stats.visible, b.stats.visible);
  EXPECT_EQ(a.stats.inliers, b.stats.inliers);
  EXPECT_EQ(a.stats.rms, b.stats.rms);
}

TEST(Execution, TwoInlineRunsGiveTheSameBytes) {
  const synthetic::SequenceOptions options = roomWalk(kFrames);
  const Playback first = play(options, inlineConfig());
  const Playback second = play(options, inlineConfig());
  ASSERT_EQ(first.results.size(), second.results.size());
  ASSERT_THAT(first, IsTrackedToTheEnd());
  for (std::size_t i = 0; i < first.results.size() && !testing::Test::HasFailure(); ++i) {
    SCOPED_TRACE("frame " + std::to_string(i));
    expectSameAnswer(first.results[i], second.results[i]);
  }
}

TEST(Execution, AMappingThreadThatIsWaitedForTracksToTheEnd) {
  Config config = inlineConfig();
  config.execution = Execution::threaded;
  const synthetic::SequenceOptions options = roomWalk(kFrames);
  const Playback run = play(options, config);
  EXPECT_THAT(run, IsTrackedToTheEnd());
  EXPECT_THAT(run, IsAccurateAtDepth(typicalDepth_m(options.scene)));
}

}  // namespace
}  // namespace glide::test
