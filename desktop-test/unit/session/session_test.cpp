#include "glide/session.h"

#include "unit/session/sequence_fixture.h"

#include "geometry/align_sim3.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace glide::test {
namespace {

using ::testing::HasSubstr;

constexpr double kStep_m = 0.012;
constexpr int kFrames = 40;

struct Walk {
  std::vector<FrameResult> results;
  std::vector<Vec3d> truth;
};

Walk walk(SequenceFixture* fixture, Session* session, int frames) {
  Walk run;
  for (int i = 0; i < frames; ++i) {
    run.results.push_back(fixture->feed(session, fixture->imageAt(i * kStep_m)));
    run.truth.push_back(SequenceFixture::poseAt(i * kStep_m).t);
  }
  return run;
}

int count(const Walk& run, TrackerKind kind) {
  int total = 0;
  for (const FrameResult& result : run.results) total += result.tracker == kind ? 1 : 0;
  return total;
}

double ateRmse(const Walk& run) {
  std::vector<Vec3d> truth;
  std::vector<Vec3d> estimate;
  for (std::size_t i = 0; i < run.results.size(); ++i) {
    if (run.results[i].state != TrackingState::tracking) continue;
    const auto& t = run.results[i].T_world_cam.t_xyz;
    truth.push_back(run.truth[i]);
    estimate.emplace_back(t[0], t[1], t[2]);
  }
  const std::optional<Sim3d> S = alignSim3(truth, estimate, AlignScale::estimated);
  if (!S) return 1e9;
  double sum = 0.0;
  for (std::size_t i = 0; i < truth.size(); ++i) sum += (truth[i] - *S * estimate[i]).squaredNorm();
  return std::sqrt(sum / static_cast<double>(truth.size()));
}

TEST(Session, RefusesAConfigAndNamesTheField) {
  Config config = SequenceFixture().config();
  config.direct.patch_size = 8;
  const Result<Session> session = Session::create(config);
  ASSERT_FALSE(session.ok());
  EXPECT_EQ(session.error().code, ErrorCode::invalid_argument);
  EXPECT_THAT(session.error().message, HasSubstr("direct.patch_size"));
}

TEST(Session, RefusesGlesWithoutACurrentContext) {
  Config config = SequenceFixture().config();
  config.backend = Backend::gles;
  const Result<Session> session = Session::create(config);
  ASSERT_FALSE(session.ok());
  EXPECT_EQ(session.error().code, ErrorCode::missing_context);
}

TEST(Session, NeedsTheContextOnlyForTheFirstFrameWhenToldSo) {
  SequenceFixture fixture;
  Config config = fixture.config();
  config.backend = Backend::gles;
  config.gl.creation = GlCreation::at_first_update;
  Session session = makeSession(config);
  const ImageU8 image = fixture.imageAt(0.0);
  const Luma luma{image.row(0), image.width(), image.height(), image.stride()};
  const Result<FrameResult> result = session.update({100, luma});
  ASSERT_FALSE(result.ok());
  EXPECT_EQ(result.error().code, ErrorCode::missing_context);
}

TEST(Session, RefusesBadInputByNameAndGoesOn) {
  SequenceFixture fixture;
  Session session = makeSession(fixture.config());
  const ImageU8 image = fixture.imageAt(0.0);
  const Luma luma{image.row(0), image.width(), image.height(), image.stride()};
  ASSERT_TRUE(session.update({100, luma}).ok());
  Luma wrong = luma;
  wrong.pixels = nullptr;
  EXPECT_THAT(session.update({200, wrong}).error().message, HasSubstr("pixels"));
  wrong = luma;
  wrong.width = 100;
  EXPECT_THAT(session.update({200, wrong}).error().message, HasSubstr("100x240"));
  wrong = luma;
  for (const std::ptrdiff_t stride : {std::ptrdiff_t{10}, std::ptrdiff_t{1} << 40}) {
    wrong.stride = stride;
    EXPECT_THAT(session.update({200, wrong}).error().message, HasSubstr("stride"));
  }
  EXPECT_THAT(session.update({100, luma}).error().message, HasSubstr("t_ns"));
  EXPECT_TRUE(session.update({200, luma}).ok());
}

TEST(Session, TracksASidewaysWalkMostlyByTheDirectTracker) {
  SequenceFixture fixture;
  Session session = makeSession(fixture.config());
  const Walk run = walk(&fixture, &session, kFrames);
  EXPECT_EQ(run.results.back().state, TrackingState::tracking);
  EXPECT_GT(count(run, TrackerKind::direct), kFrames / 2);
  EXPECT_GT(count(run, TrackerKind::indirect), 0);
  EXPECT_LT(ateRmse(run), 0.002);
}

TEST(Session, TracksWithTheIndirectTrackerAlone) {
  SequenceFixture fixture;
  Config config = fixture.config();
  config.tracker = TrackerMode::indirect;
  Session session = makeSession(config);
  const Walk run = walk(&fixture, &session, kFrames);
  EXPECT_EQ(count(run, TrackerKind::direct), 0);
  EXPECT_EQ(run.results.back().switch_reason, SwitchReason::disabled);
  EXPECT_LT(ateRmse(run), 0.004);
}

TEST(Session, SaysWhyItHasNotStarted) {
  SequenceFixture fixture;
  Session session = makeSession(fixture.config());
  EXPECT_EQ(fixture.feed(&session, fixture.blank()).initialization.status,
            InitializationStatus::waiting_for_image);
  FrameResult result;
  for (int i = 0; i < 5; ++i) result = fixture.feed(&session, fixture.imageAt(0.0));
  EXPECT_EQ(result.state, TrackingState::initializing);
  EXPECT_EQ(result.initialization.status, InitializationStatus::too_little_motion);
  EXPECT_GT(result.initialization.matches, 60);
}

TEST(Session, IsLostWhenItSeesNothingAndComesBack) {
  SequenceFixture fixture;
  Session session = makeSession(fixture.config());
  const Walk run = walk(&fixture, &session, kFrames);
  ASSERT_EQ(run.results.back().state, TrackingState::tracking);
  const ImageU8 blank = fixture.blank();
  for (int i = 0; i < 3; ++i) EXPECT_EQ(fixture.feed(&session, blank).state, TrackingState::lost);
  EXPECT_EQ(fixture.feed(&session, fixture.imageAt((kFrames - 2) * kStep_m)).state,
            TrackingState::tracking);
}

TEST(Session, AddsNoKeyframeAndDoesNotDriftWhileTheCameraStandsStill) {
  SequenceFixture fixture;
  Session session = makeSession(fixture.config());
  walk(&fixture, &session, kFrames);
  const double x = (kFrames - 1) * kStep_m;
  const ImageU8 still = fixture.imageAt(x);
  // The stop itself may deserve a keyframe: by the first indirect frame after max_interval frames.
  const int settled =
      fixture.config().keyframes.max_interval + fixture.config().direct.max_direct_frames;
  FrameResult first;
  for (int i = 0; i <= settled; ++i) first = fixture.feed(&session, still);
  const std::size_t keyframes = session.map()->keyframes.size();
  FrameResult last;
  for (int i = 0; i <= settled; ++i) last = fixture.feed(&session, still);
  EXPECT_EQ(session.map()->keyframes.size(), keyframes);
  for (std::size_t axis = 0; axis < 3; ++axis)
    EXPECT_NEAR(last.T_world_cam.t_xyz[axis], first.T_world_cam.t_xyz[axis], 2e-3);
}

TEST(Session, GivesTheSameBytesTwiceWhenInline) {
  Walk runs[2];
  for (Walk& run : runs) {
    SequenceFixture fixture;
    Session session = makeSession(fixture.config());
    run = walk(&fixture, &session, kFrames);
  }
  for (std::size_t i = 0; i < runs[0].results.size(); ++i) {
    EXPECT_EQ(runs[0].results[i].T_world_cam.t_xyz, runs[1].results[i].T_world_cam.t_xyz);
    EXPECT_EQ(runs[0].results[i].T_world_cam.q_xyzw, runs[1].results[i].T_world_cam.q_xyzw);
    EXPECT_EQ(runs[0].results[i].tracker, runs[1].results[i].tracker);
  }
}

TEST(Session, MapsOnItsOwnThreadAndStopsAtAnyMoment) {
  SequenceFixture fixture;
  Config config = fixture.config();
  config.execution = Execution::threaded;
  for (const int frames : {kFrames, kFrames / 2, 12}) {
    Session session = makeSession(config);
    walk(&fixture, &session, frames);
    EXPECT_EQ(session.map()->resets, 0U);
  }  // destroyed while the mapper may be at work
}

TEST(Session, RefersPosesToKeyframesOfTheMap) {
  SequenceFixture fixture;
  Session session = makeSession(fixture.config());
  const Walk run = walk(&fixture, &session, kFrames);
  const std::shared_ptr<const MapView> map = session.map();
  for (const FrameResult& result : run.results) {
    if (result.state != TrackingState::tracking) continue;
    const bool known =
        std::any_of(map->keyframes.begin(), map->keyframes.end(), [&](const auto& k) {
          return k.id == result.reference_keyframe;
        });
    EXPECT_TRUE(known) << result.reference_keyframe;
  }
}

}  // namespace
}  // namespace glide::test
