#include "unit/capi/c_walk_fixture.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace glide::test {
namespace {

constexpr int kFrames = 30;

double norm(const double v[3]) { return std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]); }

class CScene : public ::testing::Test {
 protected:
  CScene() { frame_ = walk_.walk(kFrames); }

  std::vector<glide_point> pointCloud() const {
    std::size_t count = 0;
    EXPECT_EQ(glide_session_point_cloud(walk_.session(), 0, nullptr, &count), GLIDE_TRUNCATED);
    std::vector<glide_point> points(count);
    EXPECT_EQ(glide_session_point_cloud(walk_.session(), count, points.data(), &count), GLIDE_OK);
    return points;
  }

  CWalk walk_{GLIDE_AXES_GL};
  glide_frame frame_{};
};

TEST_F(CScene, ShowsThePointsInFrontOfTheCamera) {
  const std::vector<glide_point> points = pointCloud();
  ASSERT_GT(points.size(), 40U);
  for (const glide_point& point : points) {
    EXPECT_LT(point.z, 0.0F);  // the camera has hardly turned: in front is -z
    EXPECT_GT(point.confidence, 0.0F);
    EXPECT_LT(point.confidence, 1.0F);
  }
}

TEST_F(CScene, ScalesEverythingAtOnce) {
  const float before = pointCloud().front().z;
  ASSERT_EQ(glide_session_set_metric_scale(walk_.session(), 2.0F), GLIDE_OK);
  EXPECT_FLOAT_EQ(pointCloud().front().z, 2.0F * before);
  glide_location location = sized<glide_location>();
  ASSERT_EQ(glide_session_locate(walk_.session(), frame_.t_ns, &location), GLIDE_OK);
  EXPECT_NEAR(norm(location.camera.p), 2.0 * norm(frame_.camera.p), 1e-9);
  EXPECT_EQ(glide_session_set_metric_scale(walk_.session(), -1.0F), GLIDE_ERROR_INVALID_ARGUMENT);
}

TEST_F(CScene, TurnsUprightByGravity) {
  const float down[3] = {1.0F, 0.0F, 0.0F};  // the phone is held in portrait
  ASSERT_EQ(glide_session_set_gravity(walk_.session(), down), GLIDE_OK);
  float view[16];
  ASSERT_EQ(glide_session_view_matrix(walk_.session(), view), GLIDE_OK);
  // The world's down (0,-1,0), seen by the camera: minus the second column of the view's rotation.
  EXPECT_NEAR(-view[4], 1.0F, 1e-5F);
  EXPECT_NEAR(-view[5], 0.0F, 1e-5F);
}

TEST_F(CScene, GivesMatricesThatPutLandmarksIntoTheImage) {
  ASSERT_EQ(glide_session_set_display(walk_.session(), 0, 320, 240), GLIDE_OK);
  float view[16];
  float projection[16];
  ASSERT_EQ(glide_session_view_matrix(walk_.session(), view), GLIDE_OK);
  ASSERT_EQ(glide_session_projection_matrix(walk_.session(), 0.01F, 100.0F, projection), GLIDE_OK);
  using Mat4f = Eigen::Matrix4f;
  const Mat4f to_clip = Eigen::Map<const Mat4f>(projection) * Eigen::Map<const Mat4f>(view);
  for (const glide_point& point : pointCloud()) {
    const Eigen::Vector4f clip = to_clip * Eigen::Vector4f(point.x, point.y, point.z, 1.0F);
    EXPECT_LE(std::abs(clip.x()), clip.w() * 1.001F);
    EXPECT_LE(std::abs(clip.y()), clip.w() * 1.001F);
  }
  EXPECT_EQ(glide_session_projection_matrix(walk_.session(), 1.0F, 0.5F, projection),
            GLIDE_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(glide_session_set_display(walk_.session(), 45, 320, 240), GLIDE_ERROR_INVALID_ARGUMENT);
}

TEST(CSceneOfPoints, ShowsWhatTheFrameWasTrackedBy) {
  CWalk walk("tracked_points=on");
  const glide_frame frame = walk.walk(kFrames);
  std::size_t count = 0;
  ASSERT_EQ(glide_session_tracked_points(walk.session(), 0, nullptr, &count), GLIDE_TRUNCATED);
  std::vector<glide_tracked_point> points(count);
  ASSERT_EQ(glide_session_tracked_points(walk.session(), count, points.data(), &count), GLIDE_OK);
  EXPECT_GT(count, 40U);
  int inliers = 0;
  for (const glide_tracked_point& point : points) {
    EXPECT_TRUE(point.u > 0.0F && point.u < 320.0F && point.v > 0.0F && point.v < 240.0F);
    EXPECT_GE(point.residual, 0.0F);
    inliers += point.inlier;
  }
  EXPECT_NEAR(inliers, frame.inliers, 3);
  EXPECT_EQ(glide_session_tracked_points(walk.session(), 1, nullptr, &count),
            GLIDE_ERROR_INVALID_ARGUMENT);
}

TEST_F(CScene, TellsNoTrackedPointsUnlessAskedTo) {
  std::size_t count = 9;
  EXPECT_EQ(glide_session_tracked_points(walk_.session(), 0, nullptr, &count), GLIDE_OK);
  EXPECT_EQ(count, 0U);
}

TEST_F(CScene, HitsTheWall) {
  glide_hit hits[4];
  std::size_t count = 0;
  const float uv[2] = {160.0F, 120.0F};
  ASSERT_EQ(glide_session_hit_test(walk_.session(), uv, 4, hits, &count), GLIDE_OK)
      << glide_last_error();
  ASSERT_GT(count, 0U);
  EXPECT_GT(hits[0].distance, 0.3F);
  EXPECT_LT(hits[0].pose.p[2], 0.0);
}

TEST_F(CScene, KeepsAnchorsByTheirIds) {
  std::uint64_t id = 0;
  glide_pose pose = frame_.camera;
  pose.p[2] -= 1.0;
  ASSERT_EQ(glide_anchor_create(walk_.session(), &pose, &id), GLIDE_OK) << glide_last_error();
  glide_anchor anchor = sized<glide_anchor>();
  ASSERT_EQ(glide_anchor_get(walk_.session(), id, &anchor), GLIDE_OK);
  EXPECT_EQ(anchor.tracking, 1);
  for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(anchor.pose.p[k], pose.p[k], 1e-9);
  ASSERT_EQ(glide_session_reset(walk_.session()), GLIDE_OK);
  ASSERT_EQ(glide_anchor_get(walk_.session(), id, &anchor), GLIDE_OK);
  EXPECT_EQ(anchor.tracking, 0);
  EXPECT_EQ(glide_anchor_destroy(walk_.session(), id), GLIDE_OK);
  EXPECT_EQ(glide_anchor_get(walk_.session(), id, &anchor), GLIDE_ERROR_INVALID_ARGUMENT);
  pose.q[3] = 5.0;
  EXPECT_EQ(glide_anchor_create(walk_.session(), &pose, &id), GLIDE_ERROR_INVALID_ARGUMENT);
}

/// Walks to the first frame with a pose, while the mapper works on a thread of its own.
struct ThreadedStart {
  ThreadedStart() {
    while (frame.state != GLIDE_STATE_TRACKING && frames < 2 * kFrames) {
      EXPECT_EQ(frame.state, GLIDE_STATE_INITIALIZING);
      frame = walk.walk(++frames);
      EXPECT_EQ(glide_session_wait_for_mapping(walk.session()), GLIDE_OK);
    }
  }
  CWalk walk{GLIDE_AXES_GL, GLIDE_EXECUTION_THREADED};
  glide_frame frame{};
  int frames = 0;
};

TEST(CSceneOfThreads, KeepsTheScaleThatWasSetOnTheFirstTrackedFrame) {
  ThreadedStart start;
  CWalk& walk = start.walk;
  ASSERT_EQ(glide_session_set_metric_scale(walk.session(), 3.0F), GLIDE_OK) << glide_last_error();
  ASSERT_EQ(walk.walk(start.frames + 1).state, GLIDE_STATE_TRACKING);
  std::vector<glide_point> points(2000);
  std::size_t count = 0;
  ASSERT_EQ(glide_session_point_cloud(walk.session(), points.size(), points.data(), &count),
            GLIDE_OK);
  ASSERT_GT(count, 40U);
  std::vector<float> depths;
  for (std::size_t i = 0; i < count; ++i) depths.push_back(-points[i].z);
  std::nth_element(depths.begin(), depths.begin() + depths.size() / 2, depths.end());
  EXPECT_NEAR(depths[depths.size() / 2], 3.0F, 0.6F);  // a start has a median depth of one
}

/// A session whose last frame has given the mapper a keyframe to work on.
class CSceneBeingMapped : public ::testing::Test {
 protected:
  CSceneBeingMapped() {
    do walkOn();
    while (!isNewKeyframe() && frames_ < 3 * kFrames);
  }
  bool isNewKeyframe() const {
    return frame_.state == GLIDE_STATE_TRACKING && frame_.keyframe != 0;
  }
  /// Lets the mapper finish before.
  void walkOn() {
    mapAll();
    frame_ = walk_.walk(++frames_);
  }
  void mapAll() { EXPECT_EQ(glide_session_wait_for_mapping(walk_.session()), GLIDE_OK); }

  std::vector<float> depths() const {
    std::vector<glide_point> points(5000);
    std::size_t count = 0;
    EXPECT_EQ(glide_session_point_cloud(walk_.session(), points.size(), points.data(), &count),
              GLIDE_OK);
    std::vector<float> z;
    for (std::size_t i = 0; i < count; ++i) z.push_back(points[i].z);
    return z;
  }
  using Acquire = glide_status (*)(glide_session*, glide_map**);
  std::uint64_t revisionOf(Acquire acquire) const {
    glide_map* map = nullptr;
    EXPECT_EQ(acquire(walk_.session(), &map), GLIDE_OK);
    std::uint64_t revision = 0, generation = 0;
    EXPECT_EQ(glide_map_revision(map, &revision), GLIDE_OK);
    EXPECT_EQ(glide_map_generation(map, &generation), GLIDE_OK);
    EXPECT_EQ(generation, frame_.map_generation);
    glide_map_release(map);
    return revision;
  }
  glide_anchor anchor(std::uint64_t id) const {
    glide_anchor state = sized<glide_anchor>();
    EXPECT_EQ(glide_anchor_get(walk_.session(), id, &state), GLIDE_OK);
    return state;
  }

  CWalk walk_{GLIDE_AXES_GL, GLIDE_EXECUTION_THREADED};
  glide_frame frame_{};
  int frames_ = 0;
};

TEST(CSceneOfThreads, CanHangAnAnchorOnTheFirstTrackedFrame) {
  const ThreadedStart start;
  ASSERT_EQ(start.frame.state, GLIDE_STATE_TRACKING);
  std::uint64_t id = 0;
  EXPECT_EQ(glide_anchor_create(start.walk.session(), &start.frame.camera, &id), GLIDE_OK)
      << glide_last_error();
}

TEST_F(CSceneBeingMapped, IsOfTheMapThatTheFrameWasTrackedIn) {
  const std::vector<float> depths_before = depths();
  std::uint64_t id = 0;
  glide_pose pose = frame_.camera;
  pose.p[2] -= 1.0;
  ASSERT_EQ(glide_anchor_create(walk_.session(), &pose, &id), GLIDE_OK) << glide_last_error();
  const std::uint64_t revision = anchor(id).revision;
  mapAll();
  ASSERT_GT(revisionOf(glide_map_acquire), frame_.map_revision);
  EXPECT_EQ(revisionOf(glide_map_acquire_frame), frame_.map_revision);
  EXPECT_EQ(depths(), depths_before);
  EXPECT_EQ(anchor(id).revision, revision);
  for (std::size_t k = 0; k < 3; ++k) EXPECT_EQ(anchor(id).pose.p[k], pose.p[k]);

  walkOn();
  EXPECT_NE(depths(), depths_before);
}

TEST_F(CScene, UntracksAnAnchorThatWasNeverLookedAt) {
  std::uint64_t id = 0;
  glide_anchor anchor = sized<glide_anchor>();
  ASSERT_EQ(glide_anchor_create(walk_.session(), &frame_.camera, &id), GLIDE_OK);
  ASSERT_EQ(glide_session_reset(walk_.session()), GLIDE_OK);
  ASSERT_EQ(glide_anchor_get(walk_.session(), id, &anchor), GLIDE_OK);
  EXPECT_EQ(anchor.tracking, 0);
}

TEST_F(CScene, HasNothingToShowRightAfterAReset) {
  ASSERT_EQ(glide_session_reset(walk_.session()), GLIDE_OK);
  glide_pose pose{};
  pose.q[3] = 1.0;
  std::uint64_t id = 0;
  EXPECT_EQ(glide_anchor_create(walk_.session(), &pose, &id), GLIDE_ERROR_NOT_TRACKING);
  std::size_t count = 9;
  EXPECT_EQ(glide_session_point_cloud(walk_.session(), 0, nullptr, &count), GLIDE_OK);
  EXPECT_EQ(count, 0U);
}

TEST(CSceneWithoutMap, HasNothingToHangOn) {
  const CWalk walk(GLIDE_AXES_GL);
  glide_pose pose{};
  pose.q[3] = 1.0;
  std::uint64_t id = 0;
  EXPECT_EQ(glide_anchor_create(walk.session(), &pose, &id), GLIDE_ERROR_NOT_TRACKING);
  EXPECT_EQ(glide_session_set_metric_scale(walk.session(), 2.0F), GLIDE_ERROR_NOT_TRACKING);
  std::size_t count = 9;
  EXPECT_EQ(glide_session_point_cloud(walk.session(), 0, nullptr, &count), GLIDE_OK);
  EXPECT_EQ(count, 0U);
}

}  // namespace
}  // namespace glide::test
