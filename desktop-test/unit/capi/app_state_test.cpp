#include "capi/app_state.h"

#include "map/map_snapshot.h"

#include <gtest/gtest.h>

#include <memory>

namespace glide {
namespace {

constexpr std::uint64_t kGeneration = 4;

std::shared_ptr<const FrameMap> mapOf(std::uint64_t generation) {
  return std::make_shared<const FrameMap>(std::make_shared<const MapSnapshot>(), generation, 0);
}

/// Tracked in a world that the app has scaled.
AppState scaled() {
  AppState state{AppWorld(AppAxes::gl), {}, {}, {}, {}};
  FrameResult result;
  result.state = TrackingState::tracking;
  result.map_generation = kGeneration;
  state.take(result, mapOf(kGeneration), {TrackedPoint{}});
  state.world.scaleBy(3.0);
  return state;
}

TEST(AppState, KeepsItsWorldFromFrameToFrameOfTheSameMap) {
  AppState state = scaled();
  FrameResult next = state.last;
  next.state = TrackingState::lost;
  state.take(next, state.map, {});
  EXPECT_EQ(state.world.scale(), 3.0);
  EXPECT_FALSE(state.isTracking());
  EXPECT_TRUE(state.tracked_points.empty());
}

TEST(AppState, BeginsANewWorldWithAnotherMap) {
  AppState state = scaled();
  FrameResult next = state.last;
  ++next.map_generation;
  state.take(next, mapOf(next.map_generation), {});
  EXPECT_EQ(state.world.scale(), 1.0);
}

TEST(AppState, ShowsAMapThatTheAppHasNotSeenInAWorldOfItsOwn) {
  const AppState state = scaled();
  EXPECT_EQ(state.worldOf(kGeneration).scale(), 3.0);
  EXPECT_EQ(state.worldOf(kGeneration + 1).scale(), 1.0);
}

TEST(AppState, HasNothingToShowWhenItsMapIsReplaced) {
  AppState state = scaled();
  EXPECT_EQ(state.mapView()->generation, kGeneration);
  state.replaceMap();
  EXPECT_FALSE(state.isTracking());
  EXPECT_EQ(state.mapView()->generation, 0U);
  EXPECT_EQ(state.world.scale(), 1.0);
  EXPECT_TRUE(state.tracked_points.empty());
}

}  // namespace
}  // namespace glide
