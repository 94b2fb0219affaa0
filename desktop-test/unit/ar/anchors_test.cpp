#include "ar/anchors.h"

#include <gtest/gtest.h>

namespace glide {
namespace {

MapView::Keyframe keyframeAt(std::uint64_t id, double x) {
  MapView::Keyframe keyframe;
  keyframe.id = id;
  keyframe.T_world_cam.t_xyz = {x, 0.0, 0.0};
  return keyframe;
}

MapView twoKeyframes() {
  MapView map;
  map.revision = 1;
  map.generation = 1;
  map.keyframes = {keyframeAt(3, 0.0), keyframeAt(8, 10.0)};
  return map;
}

/// The next revision of twoKeyframes().
MapView corrected() {
  MapView map = twoKeyframes();
  map.revision = 2;
  return map;
}

SE3d at(double x, double y, double z) { return {Eigen::Quaterniond::Identity(), Vec3d(x, y, z)}; }

TEST(Anchors, StandStillWhileTheMapDoes) {
  Anchors anchors;
  const std::uint64_t id = anchors.create(at(9.0, 1.0, 2.0), twoKeyframes()).value();
  anchors.follow(twoKeyframes());
  EXPECT_TRUE(anchors.state(id)->T_world_anchor.t.isApprox(Vec3d(9.0, 1.0, 2.0)));
  EXPECT_EQ(anchors.state(id)->revision, 0U);
  EXPECT_TRUE(anchors.state(id)->is_tracked);
}

TEST(Anchors, FollowTheNearestKeyframeWhenItIsCorrected) {
  Anchors anchors;
  const std::uint64_t id = anchors.create(at(9.0, 1.0, 2.0), twoKeyframes()).value();
  MapView map = corrected();
  map.keyframes[0].T_world_cam.t_xyz = {-5.0, 0.0, 0.0};  // not the one it hangs on
  map.keyframes[1].T_world_cam.t_xyz = {10.0, 4.0, 0.0};
  anchors.follow(map);
  EXPECT_TRUE(anchors.state(id)->T_world_anchor.t.isApprox(Vec3d(9.0, 5.0, 2.0)));
  EXPECT_EQ(anchors.state(id)->revision, 1U);
}

TEST(Anchors, GrowWithTheScaleOfTheirKeyframe) {
  Anchors anchors;
  const std::uint64_t id = anchors.create(at(9.0, 1.0, 2.0), twoKeyframes()).value();
  MapView map = corrected();
  map.keyframes[1].scale = 2.0;
  anchors.follow(map);
  EXPECT_TRUE(anchors.state(id)->T_world_anchor.t.isApprox(Vec3d(8.0, 2.0, 4.0)));
}

TEST(Anchors, StayButAreNotTrackedWhenTheirMapIsGone) {
  Anchors anchors;
  const std::uint64_t id = anchors.create(at(9.0, 1.0, 2.0), twoKeyframes()).value();
  MapView other;
  other.generation = 2;
  other.keyframes = {keyframeAt(3, 0.0), keyframeAt(8, 77.0)};
  anchors.follow(other);
  EXPECT_FALSE(anchors.state(id)->is_tracked);
  EXPECT_TRUE(anchors.state(id)->T_world_anchor.t.isApprox(Vec3d(9.0, 1.0, 2.0)));
}

TEST(Anchors, AreNotTrackedOnceTheirKeyframeIsNoPartOfTheMap) {
  Anchors anchors;
  const std::uint64_t id = anchors.create(at(9.0, 1.0, 2.0), twoKeyframes()).value();
  MapView other = corrected();
  other.keyframes = {keyframeAt(3, 0.0)};
  anchors.follow(other);
  EXPECT_FALSE(anchors.state(id)->is_tracked);
}

TEST(Anchors, AreTakenAlongOnceForEachRevision) {
  Anchors anchors;
  const std::uint64_t id = anchors.create(at(9.0, 1.0, 2.0), twoKeyframes()).value();
  anchors.follow(twoKeyframes());
  MapView same = twoKeyframes();
  same.keyframes[1].T_world_cam.t_xyz = {10.0, 4.0, 0.0};  // cannot be: shows who looks again
  anchors.follow(same);
  EXPECT_EQ(anchors.state(id)->revision, 0U);
}

TEST(Anchors, NeedAMapAndAreGoneOnceDestroyed) {
  Anchors anchors;
  EXPECT_FALSE(anchors.create(SE3d{}, MapView{}).has_value());
  const std::uint64_t id = anchors.create(SE3d{}, twoKeyframes()).value();
  EXPECT_TRUE(anchors.destroy(id));
  EXPECT_FALSE(anchors.destroy(id));
  EXPECT_FALSE(anchors.state(id).has_value());
  EXPECT_NE(anchors.create(SE3d{}, twoKeyframes()).value(), id);
}

}  // namespace
}  // namespace glide
