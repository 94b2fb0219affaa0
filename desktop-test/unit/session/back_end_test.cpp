#include "session/back_end.h"

#include "support/synthetic_map.h"

#include <gtest/gtest.h>

#include <utility>

namespace glide::test {
namespace {

CameraIntrinsics intrinsics() {
  return {640, 480, 500.0, 500.0, 319.5, 239.5, DistortionModel::none, {}};
}

class BackEndTest : public testing::TestWithParam<Execution> {
 protected:
  BackEndTest()
      : camera_(CameraModel::create(intrinsics()).value()),
        cloud_(camera_, SyntheticCloudOptions{}),
        tracker_(&cloud_, SyntheticTracker::Options{}) {
    config_.camera = intrinsics();
    config_.execution = GetParam();
  }

  static SE3d poseAt(int step) { return lookAlong(Vec3d(0.25 * step, 0.0, 0.0), 0.0); }
  SyntheticView viewAt(int step) { return cloud_.look(poseAt(step)); }

  /// A map of `keyframes` views.
  void map(BackEnd* back_end, int keyframes) {
    back_end->send(tracker_.start(&cloud_, poseAt(0), poseAt(1), 1.0));
    back_end->waitIdle();
    for (int i = 2; i < keyframes; ++i) {
      const auto snapshot = back_end->snapshot();
      back_end->send(tracker_.track(*snapshot, viewAt(i), snapshot->keyframes().back().id));
      back_end->waitIdle();
    }
  }

  CameraModel camera_;
  SyntheticCloud cloud_;
  SyntheticTracker tracker_;
  Config config_;
};

TEST_P(BackEndTest, PublishesAnEmptyMapOfANewGenerationWhenAStartIsNoGeometry) {
  BackEnd back_end(config_, camera_);
  InitialMap start = tracker_.start(&cloud_, poseAt(0), poseAt(2), 1.0);
  for (std::size_t i = 0; i + 1 < start.points.size(); i += 2) {
    std::swap(start.points[i].feature_b, start.points[i + 1].feature_b);
    start.points[i].p_world = start.points[i + 1].p_world = Vec3d(0.0, 0.0, 1.0);
  }
  back_end.send(std::move(start));
  back_end.waitIdle();
  EXPECT_TRUE(back_end.snapshot()->empty());
  EXPECT_EQ(back_end.snapshot()->generation(), 1U);
}

TEST_P(BackEndTest, AnswersWhereALostFrameIs) {
  BackEnd back_end(config_, camera_);
  map(&back_end, 6);
  const SyntheticView lost = cloud_.look(lookAlong(Vec3d(0.6, 0.05, 0.1), 0.05));
  ASSERT_TRUE(back_end.ask({77, lost.features}));
  back_end.waitIdle();
  ASSERT_NE(back_end.answer(), nullptr);
  EXPECT_EQ(back_end.answer()->t_ns, 77);
  ASSERT_TRUE(back_end.answer()->found.has_value());
  const Relocalization& found = *back_end.answer()->found;
  EXPECT_NE(back_end.snapshot()->keyframe(found.keyframe), nullptr);
}

TEST_P(BackEndTest, ForgetsThePlacesOfAMapThatWasCleared) {
  BackEnd back_end(config_, camera_);
  map(&back_end, 6);
  back_end.send(ClearMap{});
  back_end.waitIdle();
  ASSERT_TRUE(back_end.ask({1, viewAt(3).features}));
  back_end.waitIdle();
  EXPECT_FALSE(back_end.answer()->found.has_value());
}

TEST_P(BackEndTest, EndsWhileMessagesWait) {
  for (int rounds = 0; rounds < 3; ++rounds) {
    BackEnd back_end(config_, camera_);
    SyntheticTracker tracker(&cloud_, SyntheticTracker::Options{});
    back_end.send(tracker.start(&cloud_, poseAt(0), poseAt(1), 1.0));
    for (int i = 0; i < rounds; ++i) back_end.send(ClearMap{});
    back_end.ask({1, viewAt(3).features});
  }
}

INSTANTIATE_TEST_SUITE_P(Executions,
                         BackEndTest,
                         testing::Values(Execution::inline_, Execution::threaded),
                         [](const auto& execution) {
                           return execution.param == Execution::inline_ ? "Inline" : "Threaded";
                         });

}  // namespace
}  // namespace glide::test
