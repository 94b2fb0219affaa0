#include "capi/app_state.h"

#include <gtest/gtest.h>

#include <memory>

namespace glide {
namespace {

constexpr std::uint64_t kGeneration = 4;

class EmptyMap final : public FrameMap {
 public:
  explicit EmptyMap(std::uint64_t generation) : generation_(generation) {}
  std::uint64_t generation() const override { return generation_; }
  std::uint64_t revision() const override { return 1; }
  std::shared_ptr<const MapView> view() const override {
    auto view = std::make_shared<MapView>();
    view->generation = generation_;
    return view;
  }

 private:
  std::uint64_t generation_;
};

std::shared_ptr<const FrameMap> mapOf(std::uint64_t generation) {
  return std::make_shared<const EmptyMap>(generation);
}

/// Tracked in a world that the app has scaled.
AppState scaled() {
  AppState state{AppWorld(AppAxes::gl), {}, {}, {}, {}};
  FrameResult result;
  result.state = TrackingState::tracking;
  result.map_revision = 1;
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

TEST(AppState, IsInitializingUntilThereIsAMapToHangThingsOn) {
  AppState state = scaled();
  FrameResult start = state.last;
  ++start.map_generation;
  start.map_revision = 0;
  state.take(start, mapOf(start.map_generation), {TrackedPoint{}});
  EXPECT_EQ(state.last.state, TrackingState::initializing);
  EXPECT_EQ(state.last.tracker, TrackerKind::none);
  EXPECT_TRUE(state.tracked_points.empty());
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
