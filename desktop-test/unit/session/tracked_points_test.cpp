#include "unit/session/sequence_fixture.h"

#include "glide/session.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <memory>
#include <optional>
#include <vector>

namespace glide::test {
namespace {

constexpr double kStep_m = 0.012;
constexpr int kFrames = 28;

/// A frame of the walk, with the map as it was when the frame was tracked.
struct Step {
  double x = 0.0;
  FrameResult result;
  std::vector<TrackedPoint> points;
  std::shared_ptr<const MapView> map;
};

/// Images are rendered once for all tests.
class TrackedPointsTest : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    images_ = new std::vector<ImageU8>();
    for (int i = 0; i < kFrames; ++i)
      images_->push_back(SequenceFixture().imageAt(static_cast<double>(i) * kStep_m));
  }
  static void TearDownTestSuite() { delete images_; }

  Session session(ReportPoints report) const {
    Config config = fixture_.config();
    config.tracked_points = report;
    return makeSession(config);
  }

  std::vector<Step> walk(Session* session) const {
    SequenceFixture fixture;
    std::vector<Step> steps;
    for (const ImageU8& image : *images_) {
      Step step;
      step.x = static_cast<double>(steps.size()) * kStep_m;
      step.map = session->map();
      step.result = fixture.feed(session, image);
      step.points = session->trackedPoints();
      steps.push_back(step);
    }
    return steps;
  }

  static std::vector<ImageU8>* images_;
  SequenceFixture fixture_;
};

std::vector<ImageU8>* TrackedPointsTest::images_ = nullptr;

bool isIn(const MapView& map, std::uint64_t landmark) {
  return std::any_of(map.landmarks.begin(), map.landmarks.end(), [&](const auto& entry) {
    return entry.id == landmark;
  });
}

TEST_F(TrackedPointsTest, LieWhereTheSceneIsSeen) {
  Session reporting = session(ReportPoints::on);
  std::map<std::uint64_t, Vec3d> scene_points;  // by the pixel that showed the landmark first
  int compared = 0;
  int wrong = 0;
  for (const Step& step : walk(&reporting)) {
    for (const TrackedPoint& point : step.points) {
      const Vec2d uv(point.u, point.v);
      const auto known = scene_points.find(point.landmark);
      if (known == scene_points.end()) {
        const std::optional<Vec3d> p_world = fixture_.pointAt(step.x, uv);
        ASSERT_TRUE(p_world.has_value());
        scene_points[point.landmark] = *p_world;
        continue;
      }
      ++compared;
      const std::optional<Vec2d> truth = fixture_.pixelOf(step.x, known->second);
      wrong += !truth || (*truth - uv).norm() > 1.5 ? 1 : 0;
    }
  }
  EXPECT_GT(compared, 1500);
  EXPECT_LT(wrong, compared / 50);  // corners at the panels' edges belong to no one place
}

TEST_F(TrackedPointsTest, AreLandmarksOfTheMapByBothTrackers) {
  Session reporting = session(ReportPoints::on);
  int direct = 0;
  int indirect = 0;
  for (const Step& step : walk(&reporting)) {
    if (step.points.empty()) continue;
    const bool is_direct = step.result.tracker == TrackerKind::direct;
    (is_direct ? direct : indirect) += 1;
    for (const TrackedPoint& point : step.points) EXPECT_TRUE(isIn(*step.map, point.landmark));
    const auto inliers = std::count_if(
        step.points.begin(), step.points.end(), [](const TrackedPoint& p) { return p.inlier; });
    EXPECT_NEAR(static_cast<double>(inliers), step.result.stats.inliers, 3.0);
  }
  EXPECT_GT(direct, kFrames / 2);
  EXPECT_GT(indirect, 1);
}

TEST_F(TrackedPointsTest, CostNothingAndChangeNoPoseWhenTheyAreOff) {
  Session silent = session(ReportPoints::off);
  Session reporting = session(ReportPoints::on);
  const std::vector<Step> without = walk(&silent);
  const std::vector<Step> with = walk(&reporting);
  EXPECT_EQ(silent.trackedPoints().capacity(), 0U);
  for (std::size_t i = 0; i < with.size(); ++i)
    EXPECT_EQ(without[i].result.T_world_cam.t_xyz, with[i].result.T_world_cam.t_xyz);
}

TEST_F(TrackedPointsTest, AreThoseOfIndirectFramesWhenOnlyThoseAreWanted) {
  Session sparing = session(ReportPoints::indirect);
  int indirect = 0;
  for (const Step& step : walk(&sparing)) {
    EXPECT_FALSE(step.result.tracker == TrackerKind::direct && !step.points.empty());
    indirect += step.points.empty() ? 0 : 1;
  }
  EXPECT_GT(indirect, 1);
}

TEST_F(TrackedPointsTest, AreNoneWhileNothingIsTracked) {
  Session reporting = session(ReportPoints::on);
  EXPECT_TRUE(reporting.trackedPoints().empty());
  SequenceFixture fixture;
  for (const ImageU8& image : *images_) fixture.feed(&reporting, image);
  ASSERT_FALSE(reporting.trackedPoints().empty());
  fixture.feed(&reporting, fixture.blank());
  EXPECT_TRUE(reporting.trackedPoints().empty());
  fixture.feed(&reporting, images_->back());
  ASSERT_FALSE(reporting.trackedPoints().empty());
  reporting.reset();
  EXPECT_TRUE(reporting.trackedPoints().empty());
}

}  // namespace
}  // namespace glide::test
