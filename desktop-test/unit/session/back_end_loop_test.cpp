// A loop that the back end closes: the mapper hands a keyframe to the loop thread, which hands a
// correction back.
#include "support/synthetic_problem.h"
#include "unit/loop/drifted_map.h"

#include "session/back_end.h"

#include <gtest/gtest.h>

#include <memory>
#include <utility>

namespace glide::test {
namespace {

constexpr double kTwoPi = 6.283185307179586;
constexpr int kPerTurn = 60;
constexpr int kRestored = kPerTurn - 4;

class BackEndLoop : public testing::TestWithParam<Execution> {
 protected:
  BackEndLoop() {
    config_.camera = camera_.intrinsics();
    config_.execution = GetParam();
    while (map_.snapshot()->keyframes().size() < kRestored) look();
  }

  KeyframeId look() { return map_.add(ringPose(kTwoPi * next_++ / kPerTurn)); }

  /// The next keyframe of the ring, tracked by the landmarks that were there when it was restored.
  NewKeyframe nextKeyframe(LandmarkId end_of_restored) {
    const KeyframeId reference{static_cast<std::uint64_t>(next_ - 1)};
    const Keyframe& keyframe = *map_.map()->keyframe(look());
    NewKeyframe message;
    message.id = keyframe.id;
    message.t_ns = static_cast<std::int64_t>(keyframe.id.value);
    message.features = keyframe.features;
    message.reference = reference;
    message.T_cam_ref = keyframe.T_cam_world * map_.map()->T_cam_world(reference)->inverse();
    message.landmarks = keyframe.landmarks;
    for (LandmarkId& id : message.landmarks)
      if (!(id < end_of_restored)) id = kNoLandmark;
    return message;
  }

  CameraModel camera_ = syntheticCamera(DistortionModel::radial_tangential);
  DriftedMap map_{ringCloud(), camera_, someDrift()};
  Config config_;
  int next_ = 0;
};

TEST_P(BackEndLoop, IsWorkedInWhenAllIsWorkedOff) {
  const std::shared_ptr<const MapSnapshot> restored = map_.snapshot();
  const LandmarkId end{restored->landmarks().back().id.value + 1};
  BackEnd back_end(config_, camera_);
  back_end.send(RestoredMap{restored});
  for (int i = 0; i < 16 && back_end.snapshot()->loops().empty(); ++i) {
    back_end.send(nextKeyframe(end));
    back_end.waitIdle();
    const std::uint64_t revision = back_end.snapshot()->revision();
    back_end.waitIdle();
    EXPECT_EQ(back_end.snapshot()->revision(), revision) << "something was still under way";
  }
  ASSERT_EQ(back_end.snapshot()->loops().size(), 1U);
  EXPECT_GE(back_end.snapshot()->corrections(), 2U) << "the loop, and all of the map after it";
}

INSTANTIATE_TEST_SUITE_P(Executions,
                         BackEndLoop,
                         testing::Values(Execution::inline_, Execution::threaded),
                         [](const auto& execution) {
                           return execution.param == Execution::inline_ ? "Inline" : "Threaded";
                         });

}  // namespace
}  // namespace glide::test
