#include "unit/session/sequence_fixture.h"

#include "geometry/pose_conversion.h"

#include "glide/session.h"

#include <gtest/gtest.h>

#include <memory>
#include <optional>
#include <utility>

namespace glide::test {
namespace {

constexpr int kFrames = 40;
constexpr double kStep_m = 0.012;
constexpr double kRounding = 1e-9;

Session makeSession(Execution execution) {
  Config config = SequenceFixture().config();
  config.execution = execution;
  Result<Session> session = Session::create(config);
  EXPECT_TRUE(session.ok()) << session.error().message;
  return std::move(*session);
}

/// How far the frame's pose is from where its keyframe in the map puts it; nothing when the frame
/// became that keyframe.
std::optional<double> mismatch(const FrameResult& frame, const MapView& map) {
  const MapView::Keyframe* keyframe = map.keyframe(frame.reference_keyframe);
  if (frame.state != TrackingState::tracking || keyframe == nullptr) return std::nullopt;
  SE3d T_ref_cam = fromPose(frame.T_ref_cam);
  T_ref_cam.t *= keyframe->scale / frame.reference_scale;
  const SE3d T_world_cam = fromPose(keyframe->T_world_cam) * T_ref_cam;
  return (T_world_cam.inverse() * fromPose(frame.T_world_cam)).log().norm();
}

TEST(FrameMap, IsTheMapThatThePoseIsOf) {
  SequenceFixture fixture;
  Session session = makeSession(Execution::inline_);
  int compared = 0;
  for (int i = 0; i < kFrames; ++i) {
    const FrameResult frame = fixture.feed(&session, fixture.imageAt(i * kStep_m));
    const std::shared_ptr<const FrameMap> map = session.frameMap();
    EXPECT_EQ(map->revision(), frame.map_revision) << i;
    EXPECT_EQ(map->generation(), frame.map_generation) << i;
    EXPECT_EQ(map->view()->revision, frame.map_revision) << i;
    const std::optional<double> off = mismatch(frame, *map->view());
    if (!off) continue;
    EXPECT_LT(*off, kRounding) << i;
    ++compared;
  }
  EXPECT_GT(compared, kFrames / 2);
}

TEST(FrameMap, OfTheFrameThatStartsAMapIsThatMap) {
  SequenceFixture fixture;
  Session session = makeSession(Execution::inline_);
  FrameResult frame;
  for (int i = 0; i < kFrames && frame.state != TrackingState::tracking; ++i)
    frame = fixture.feed(&session, fixture.imageAt(i * kStep_m));
  ASSERT_EQ(frame.state, TrackingState::tracking);
  EXPECT_EQ(session.frameMap()->view(), session.map());
  EXPECT_EQ(session.map()->keyframes.size(), 2U);
  EXPECT_LT(mismatch(frame, *session.map()).value(), kRounding);
}

TEST(FrameMap, StaysWhileTheMapperGoesOn) {
  SequenceFixture fixture;
  Session session = makeSession(Execution::threaded);
  FrameResult frame;
  for (int i = 0; i < 3 * kFrames; ++i) {
    frame = fixture.feed(&session, fixture.imageAt(i * kStep_m));
    const bool is_first_map = frame.map_revision == 0;
    if (frame.stats.keyframe && !is_first_map) break;
    session.waitForMapping();
  }
  ASSERT_TRUE(frame.stats.keyframe);
  const std::shared_ptr<const FrameMap> before = session.frameMap();
  session.waitForMapping();
  EXPECT_GT(session.map()->revision, frame.map_revision);
  EXPECT_EQ(session.frameMap(), before);
  EXPECT_EQ(before->view()->revision, frame.map_revision);
}

TEST(FrameMap, OfAPausedFrameIsTheNewest) {
  SequenceFixture fixture;
  Session session = makeSession(Execution::inline_);
  for (int i = 0; i < kFrames; ++i) fixture.feed(&session, fixture.imageAt(i * kStep_m));
  session.pause();
  const FrameResult paused = fixture.feed(&session, fixture.blank());
  ASSERT_EQ(paused.state, TrackingState::paused);
  EXPECT_EQ(paused.map_revision, session.map()->revision);
  EXPECT_EQ(session.frameMap()->view(), session.map());
}

TEST(FrameMap, IsEmptyFromAResetOn) {
  SequenceFixture fixture;
  Session session = makeSession(Execution::inline_);
  EXPECT_TRUE(session.frameMap()->view()->keyframes.empty());
  for (int i = 0; i < kFrames; ++i) fixture.feed(&session, fixture.imageAt(i * kStep_m));
  const std::shared_ptr<const FrameMap> before = session.frameMap();
  session.reset();
  EXPECT_TRUE(session.frameMap()->view()->keyframes.empty());
  EXPECT_GT(session.frameMap()->generation(), before->generation());
  EXPECT_FALSE(before->view()->keyframes.empty());
}

}  // namespace
}  // namespace glide::test
