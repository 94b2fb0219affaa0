#include "render/scene_path.h"

#include "geometry/pose_conversion.h"

#include <gtest/gtest.h>

namespace glide::test {
namespace {

constexpr float kTolerance = 1e-5F;

MapView::Keyframe keyframeAt(std::uint64_t id, const SE3d& T_world_cam) {
  MapView::Keyframe keyframe;
  keyframe.id = id;
  keyframe.T_world_cam = toPose(T_world_cam);
  return keyframe;
}

/// One keyframe, 7, at `T_world_key`.
MapView mapWith(const SE3d& T_world_key) {
  MapView map;
  map.keyframes.push_back(keyframeAt(7, T_world_key));
  return map;
}

/// A frame a little beside keyframe 7.
FrameResult frameAt(const SE3d& T_world_key, const SE3d& T_key_cam) {
  FrameResult frame;
  frame.state = TrackingState::tracking;
  frame.tracker = TrackerKind::direct;
  frame.reference_keyframe = 7;
  frame.T_ref_cam = toPose(T_key_cam);
  frame.T_world_cam = toPose(T_world_key * T_key_cam);
  return frame;
}

void expectAt(const PoseRecord& record, const SE3d& T_world_cam) {
  for (int i = 0; i < 3; ++i)
    EXPECT_NEAR(record.p_world[static_cast<std::size_t>(i)], T_world_cam.t[i], kTolerance);
  const auto& q = record.q_world_cam_xyzw;
  const Eigen::Quaterniond drawn(q[3], q[0], q[1], q[2]);
  EXPECT_LT(drawn.angularDistance(T_world_cam.q), kTolerance);
}

const SE3d kWorldKey = SE3d::exp((Vec6d() << 1.0, -2.0, 3.0, 0.3, -0.2, 0.5).finished());
const SE3d kKeyCam = SE3d::exp((Vec6d() << 0.1, 0.05, -0.2, 0.02, 0.1, -0.03).finished());

TEST(ScenePath, LiesWhereTheFramesWereTracked) {
  ScenePath path;
  path.append(frameAt(kWorldKey, kKeyCam), mapWith(kWorldKey));
  ASSERT_EQ(path.records().size(), 1U);
  expectAt(path.records().items()[0], kWorldKey * kKeyCam);
}

TEST(ScenePath, FollowsAKeyframeThatWasCorrected) {
  ScenePath path;
  path.append(frameAt(kWorldKey, kKeyCam), mapWith(kWorldKey));
  const SE3d moved = SE3d::exp((Vec6d() << 0.5, 0.1, 0.0, 0.0, 0.4, 0.0).finished()) * kWorldKey;
  path.place(mapWith(moved));
  expectAt(path.records().items()[0], moved * kKeyCam);
}

TEST(ScenePath, GrowsWithTheScaleOfItsKeyframe) {
  ScenePath path;
  FrameResult frame = frameAt(kWorldKey, kKeyCam);
  frame.reference_scale = 2.0;
  MapView map = mapWith(kWorldKey);
  map.keyframes[0].scale = 3.0;
  path.append(frame, map);
  expectAt(path.records().items()[0], kWorldKey * SE3d{kKeyCam.q, 1.5 * kKeyCam.t});
}

TEST(ScenePath, StaysWhereItWasTrackedUntilTheMapHasTheKeyframe) {
  ScenePath path;
  path.append(frameAt(kWorldKey, kKeyCam), MapView{});
  expectAt(path.records().items()[0], kWorldKey * kKeyCam);
  path.place(mapWith(SE3d{}));
  expectAt(path.records().items()[0], kKeyCam);
}

TEST(ScenePath, UploadsOnlyWhatACorrectionMoved) {
  MapView map;
  map.keyframes = {keyframeAt(1, SE3d{}), keyframeAt(7, kWorldKey)};
  ScenePath path;
  FrameResult first = frameAt(SE3d{}, kKeyCam);
  first.reference_keyframe = 1;
  path.append(first, map);
  path.append(frameAt(kWorldKey, kKeyCam), map);
  path.records().markUploaded();
  path.place(map);
  EXPECT_FALSE(path.records().isChanged());
  map.keyframes[1].T_world_cam.t_xyz[0] += 0.1;
  path.place(map);
  EXPECT_EQ(path.records().changedFrom(), 1U);
}

TEST(ScenePath, HasTheTrackersColours) {
  ScenePath path;
  FrameResult frame = frameAt(kWorldKey, kKeyCam);
  for (const TrackerKind tracker :
       {TrackerKind::direct, TrackerKind::direct, TrackerKind::indirect}) {
    frame.tracker = tracker;
    path.append(frame, MapView{});
  }
  EXPECT_EQ(path.records().items()[1].color, packColor(kDirectColor));
  EXPECT_EQ(path.records().items()[2].color, packColor(kIndirectColor));
}

TEST(ScenePath, HasNoLineToTheFirstFrameNorAcrossALoss) {
  ScenePath path;
  const FrameResult tracked = frameAt(kWorldKey, kKeyCam);
  FrameResult lost = tracked;
  lost.state = TrackingState::lost;
  for (const FrameResult& frame : {tracked, tracked, lost, lost, tracked, tracked})
    path.append(frame, MapView{});
  std::vector<int> alphas;
  for (const PoseRecord& record : path.records().items()) alphas.push_back(record.color[3]);
  EXPECT_EQ(alphas, (std::vector<int>{0, 255, 0, 255}));
}

TEST(ScenePath, BeginsAnewInAnotherMap) {
  ScenePath path;
  MapView map = mapWith(kWorldKey);
  path.append(frameAt(kWorldKey, kKeyCam), map);
  map.generation = 1;
  path.place(map);
  EXPECT_EQ(path.records().size(), 0U);
  FrameResult frame = frameAt(kWorldKey, kKeyCam);
  frame.map_generation = 1;
  path.append(frame, map);
  ASSERT_EQ(path.records().size(), 1U);
  EXPECT_EQ(path.records().items()[0].color[3], 0);
}

TEST(ScenePath, TakesAFrameOfANewMapBeforeTheMapAndNoKeyframeOfTheOldOne) {
  ScenePath path;
  const MapView old_map = mapWith(SE3d{});
  path.append(frameAt(SE3d{}, kKeyCam), old_map);
  FrameResult frame = frameAt(kWorldKey, kKeyCam);
  frame.map_generation = 1;
  path.append(frame, old_map);
  ASSERT_EQ(path.records().size(), 1U);
  expectAt(path.records().items()[0], kWorldKey * kKeyCam);
  MapView new_map = mapWith(kWorldKey);
  new_map.generation = 1;
  path.place(new_map);
  EXPECT_EQ(path.records().size(), 1U);
}

}  // namespace
}  // namespace glide::test
