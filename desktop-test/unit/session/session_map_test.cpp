#include "unit/session/sequence_fixture.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <vector>

namespace glide::test {
namespace {

using ::testing::HasSubstr;

constexpr double kStep_m = 0.012;
constexpr int kFrames = 60;

FrameResult walkOn(SequenceFixture* fixture, Session* session, int from, int to) {
  FrameResult last;
  for (int i = from; i < to; ++i) last = fixture->feed(session, fixture->imageAt(i * kStep_m));
  return last;
}

double distance(const Pose& a, const Pose& b) {
  double sum = 0.0;
  for (std::size_t axis = 0; axis < 3; ++axis) sum += std::pow(a.t_xyz[axis] - b.t_xyz[axis], 2);
  return std::sqrt(sum);
}

/// A session that has mapped the walk, and what it said about the middle of it.
struct MappedWalk {
  explicit MappedWalk(const Config& config) : session(makeSession(config)) {
    middle = walkOn(&fixture, &session, 0, kFrames / 2);
    last = walkOn(&fixture, &session, kFrames / 2, kFrames);
    session.waitForMapping();
  }
  SequenceFixture fixture;
  Session session;
  FrameResult middle, last;
};

ImageU8 middleImage(const SequenceFixture& fixture) {
  return fixture.imageAt((kFrames / 2 - 1) * kStep_m);
}

Config localizing() {
  Config config = SequenceFixture().config();
  config.mode = SessionMode::localization_only;
  return config;
}

TEST(SessionMap, IsFoundAgainInAnotherSessionInTheSameFrame) {
  const MappedWalk walk(SequenceFixture().config());
  Session other = makeSession(localizing());
  SequenceFixture fixture;
  const Result<std::vector<std::byte>> bytes = walk.session.saveMap();
  ASSERT_TRUE(bytes.ok()) << bytes.error().message;
  const Status loaded = other.loadMap(*bytes);
  ASSERT_TRUE(loaded.ok()) << loaded.error().message;
  const FrameResult found = fixture.feed(&other, middleImage(fixture));
  ASSERT_EQ(found.state, TrackingState::tracking);
  EXPECT_LT(distance(found.T_world_cam, walk.middle.T_world_cam), 0.01);
}

TEST(SessionMap, IsNotChangedByASessionThatOnlyLocalizes) {
  const MappedWalk walk(SequenceFixture().config());
  Session other = makeSession(localizing());
  SequenceFixture fixture;
  ASSERT_TRUE(other.loadMap(*walk.session.saveMap()).ok());
  const FrameResult last = walkOn(&fixture, &other, 0, kFrames + 10);
  EXPECT_EQ(last.state, TrackingState::tracking);
  const std::shared_ptr<const MapView> before = walk.session.map();
  const std::shared_ptr<const MapView> after = other.map();
  ASSERT_EQ(after->keyframes.size(), before->keyframes.size());
  for (std::size_t i = 0; i < before->keyframes.size(); ++i)
    EXPECT_EQ(after->keyframes[i].T_world_cam.t_xyz, before->keyframes[i].T_world_cam.t_xyz);
  ASSERT_EQ(after->landmarks.size(), before->landmarks.size());
  for (std::size_t i = 0; i < before->landmarks.size(); ++i)
    EXPECT_EQ(after->landmarks[i].p_world, before->landmarks[i].p_world);
}

TEST(SessionMap, TellsItsSizeWithoutACopy) {
  const MappedWalk walk(SequenceFixture().config());
  const std::shared_ptr<const MapView> map = walk.session.map();
  std::size_t living = 0;
  for (const MapView::Keyframe& keyframe : map->keyframes) living += keyframe.retired ? 0U : 1U;
  const MapSize size = walk.session.mapSize();
  EXPECT_GT(size.keyframes, 1U);
  EXPECT_EQ(size.keyframes, living);
  EXPECT_EQ(size.landmarks, map->landmarks.size());
  EXPECT_EQ(size.loops, map->loops.size());
}

TEST(SessionMap, GrowsOnAfterItWasLoaded) {
  const MappedWalk walk(SequenceFixture().config());
  Session other = makeSession(SequenceFixture().config());
  SequenceFixture fixture;
  ASSERT_TRUE(other.loadMap(*walk.session.saveMap()).ok());
  const std::size_t before = other.map()->keyframes.size();
  const FrameResult last = walkOn(&fixture, &other, kFrames / 2, kFrames + 40);
  EXPECT_EQ(last.state, TrackingState::tracking);
  EXPECT_GT(other.map()->keyframes.size(), before);
  EXPECT_EQ(other.map()->resets, 0U);
}

TEST(SessionMap, OfAnotherCameraIsRefusedAndNothingChanges) {
  const MappedWalk walk(SequenceFixture().config());
  Config config = SequenceFixture().config();
  config.camera.fx += 5.0;
  Session other = makeSession(config);
  const Status loaded = other.loadMap(*walk.session.saveMap());
  ASSERT_FALSE(loaded.ok());
  EXPECT_EQ(loaded.error().code, ErrorCode::invalid_argument);
  EXPECT_THAT(loaded.error().message, HasSubstr("another camera"));
  EXPECT_TRUE(other.map()->keyframes.empty());
}

TEST(SessionMap, IsWrittenToAFileAndReadFromIt) {
  const MappedWalk walk(SequenceFixture().config());
  const std::filesystem::path path =
      std::filesystem::temp_directory_path() / "glide_session_map_test.map";
  ASSERT_TRUE(walk.session.saveMap(path).ok());
  Session other = makeSession(localizing());
  EXPECT_TRUE(other.loadMap(path).ok());
  EXPECT_EQ(other.map()->landmarks.size(), walk.session.map()->landmarks.size());
  std::filesystem::remove(path);
  const Status missing = other.loadMap(path);
  ASSERT_FALSE(missing.ok());
  EXPECT_EQ(missing.error().code, ErrorCode::io);
  EXPECT_THAT(missing.error().message, HasSubstr(path.string()));
}

TEST(SessionMap, IsNeededToLocalize) {
  SequenceFixture fixture;
  Session session = makeSession(localizing());
  EXPECT_EQ(walkOn(&fixture, &session, 0, 20).state, TrackingState::lost);
  EXPECT_TRUE(session.map()->keyframes.empty());
}

TEST(SessionMap, IsDroppedByResetAndStartedAnew) {
  MappedWalk walk(SequenceFixture().config());
  walk.session.reset();
  EXPECT_TRUE(walk.session.map()->keyframes.empty());
  EXPECT_EQ(walk.session.map()->resets, 1U);
  const FrameResult next = walkOn(&walk.fixture, &walk.session, 0, 1);
  EXPECT_EQ(next.state, TrackingState::initializing);
  EXPECT_EQ(next.T_world_cam.t_xyz, Pose{}.t_xyz);  // nothing of the world that is gone
  EXPECT_EQ(walkOn(&walk.fixture, &walk.session, 1, kFrames).state, TrackingState::tracking);
}

TEST(SessionMap, SurvivesAPauseInWhichTheCameraMoved) {
  MappedWalk walk(SequenceFixture().config());
  walk.session.pause();
  const FrameResult paused = walkOn(&walk.fixture, &walk.session, kFrames, kFrames + 5);
  EXPECT_EQ(paused.state, TrackingState::paused);
  EXPECT_EQ(paused.T_world_cam.t_xyz, walk.last.T_world_cam.t_xyz);
  walk.session.resume();
  FrameResult found;
  for (int i = 0; i < 3; ++i) found = walk.fixture.feed(&walk.session, middleImage(walk.fixture));
  ASSERT_EQ(found.state, TrackingState::tracking);
  EXPECT_LT(distance(found.T_world_cam, walk.middle.T_world_cam), 0.01);
}

TEST(SessionMap, IsKeptHoweverSmallWhenItCameFromAFile) {
  SequenceFixture fixture;
  Session session = makeSession(fixture.config());
  int frames = 0;
  while (session.map()->keyframes.size() < 2)
    walkOn(&fixture, &session, frames, frames + 1), ++frames;
  Session other = makeSession(SequenceFixture().config());
  ASSERT_TRUE(other.loadMap(*session.saveMap()).ok());
  const ImageU8 blank = fixture.blank();
  FrameResult result;
  for (int i = 0; i < 10; ++i) result = fixture.feed(&other, blank);
  EXPECT_EQ(result.state, TrackingState::lost);
  EXPECT_FALSE(other.map()->keyframes.empty());
}

TEST(SessionMap, LeavesNoPoseInTheWorldAfterItWhenItIsGivenUp) {
  SequenceFixture fixture;
  Session session = makeSession(fixture.config());
  int frames = 0;
  FrameResult result;
  while (session.map()->keyframes.size() < 2)
    result = walkOn(&fixture, &session, frames, frames + 1), ++frames;
  const std::uint64_t first = result.map_generation;
  const ImageU8 blank = fixture.blank();
  for (int i = 0; i < 10 && result.map_generation == first; ++i)
    result = fixture.feed(&session, blank);
  ASSERT_GT(result.map_generation, first);
  EXPECT_EQ(result.state, TrackingState::initializing);
  EXPECT_EQ(result.map_revision, 0U);
  EXPECT_EQ(result.T_world_cam.t_xyz, Pose{}.t_xyz);
}

TEST(SessionMap, LocatesNothingOfTheWorldBeforeAReset) {
  MappedWalk walk(SequenceFixture().config());
  ASSERT_TRUE(walk.session.locate(walk.last.t_ns).tracked);
  walk.session.reset();
  EXPECT_FALSE(walk.session.locate(walk.last.t_ns).valid);
}

TEST(SessionMap, LocatesNothingOfTheWorldBeforeALoad) {
  MappedWalk walk(SequenceFixture().config());
  ASSERT_TRUE(walk.session.loadMap(*walk.session.saveMap()).ok());
  EXPECT_FALSE(walk.session.locate(walk.middle.t_ns).valid);
}

TEST(SessionMap, LocatesTheCameraAtAFrameAndBetweenFrames) {
  SequenceFixture fixture;
  Session session = makeSession(fixture.config());
  const FrameResult before = walkOn(&fixture, &session, 0, kFrames - 1);
  const FrameResult last = walkOn(&fixture, &session, kFrames - 1, kFrames);
  EXPECT_LT(distance(session.locate(last.t_ns).T_world_cam, last.T_world_cam), 1e-9);
  const LocatedCamera between = session.locate((before.t_ns + last.t_ns) / 2);
  EXPECT_TRUE(between.tracked);
  const double step = distance(before.T_world_cam, last.T_world_cam);
  EXPECT_NEAR(distance(between.T_world_cam, last.T_world_cam), 0.5 * step, 0.1 * step);
  const LocatedCamera soon = session.locate(last.t_ns + 20'000'000);
  EXPECT_TRUE(soon.valid);
  EXPECT_FALSE(soon.tracked);
  EXPECT_FALSE(session.locate(last.t_ns + 1'000'000'000).valid);
}

TEST(SessionMap, IsCopiedOnceForEachRevision) {
  MappedWalk walk(SequenceFixture().config());
  const std::shared_ptr<const MapView> map = walk.session.map();
  EXPECT_EQ(walk.session.map(), map);
  walkOn(&walk.fixture, &walk.session, kFrames, kFrames + 40);
  EXPECT_GT(walk.session.map()->revision, map->revision);
}

TEST(SessionMap, IsToldFromTheOnesBeforeByItsGeneration) {
  MappedWalk walk(SequenceFixture().config());
  const std::uint64_t first = walk.session.map()->generation;
  EXPECT_EQ(walk.last.map_generation, first);
  EXPECT_EQ(walk.session.locate(walk.last.t_ns).map_generation, first);
  ASSERT_TRUE(walk.session.loadMap(*walk.session.saveMap()).ok());
  const std::uint64_t second = walk.session.map()->generation;
  EXPECT_GT(second, first);
  walk.session.reset();
  EXPECT_GT(walk.session.map()->generation, second);
  EXPECT_GT(walk.session.locate(walk.last.t_ns).map_generation, second);
}

/// A session whose mapper has a keyframe to work on.
struct BusyWalk {
  BusyWalk() : session(makeSession(threaded())) {
    for (int i = 0; i < kFrames; ++i) {
      walkOn(&fixture, &session, i, i + 1);
      session.waitForMapping();
    }
    int frame = kFrames;
    do last = walkOn(&fixture, &session, frame, frame + 1);
    while (!last.stats.keyframe && ++frame < 3 * kFrames);
  }
  static Config threaded() {
    Config config = SequenceFixture().config();
    config.execution = Execution::threaded;
    return config;
  }
  SequenceFixture fixture;
  Session session;
  FrameResult last;
};

TEST(BusySessionMap, IsEmptyFromAResetOn) {
  BusyWalk walk;
  ASSERT_TRUE(walk.last.stats.keyframe);
  ASSERT_FALSE(walk.session.map()->keyframes.empty());
  walk.session.reset();
  const std::shared_ptr<const MapView> map = walk.session.map();
  EXPECT_TRUE(map->keyframes.empty());
  EXPECT_TRUE(map->landmarks.empty());
  EXPECT_EQ(walk.session.saveMap().error().code, ErrorCode::no_map);
}

TEST(BusySessionMap, IsTakenWithoutWaitingForTheMapper) {
  BusyWalk walk;
  ASSERT_TRUE(walk.last.stats.keyframe);
  const auto file = Session::MapFile::decode(*walk.session.saveMap());
  ASSERT_TRUE(file.ok()) << file.error().message;
  ASSERT_TRUE(walk.session.takeMap(*file).ok());
  EXPECT_EQ(walk.fixture.feed(&walk.session, walk.fixture.blank()).state, TrackingState::lost);
  walk.session.waitForMapping();
  EXPECT_FALSE(walk.session.map()->keyframes.empty());
  FrameResult found;
  for (int i = 0; i < 10 && found.state != TrackingState::tracking; ++i) {
    found = walk.fixture.feed(&walk.session, middleImage(walk.fixture));
    walk.session.waitForMapping();
  }
  EXPECT_EQ(found.state, TrackingState::tracking);
}

}  // namespace
}  // namespace glide::test
