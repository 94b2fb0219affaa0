#include "mapping/witnesses.h"

#include "support/mapped_scene.h"

#include "geometry/align_sim3.h"

#include <gtest/gtest.h>

#include <cstddef>

namespace glide {
namespace {

using test::MappedScene;
using test::smallCloud;
using test::walk;

/// Keyframes of a walk, the first and the last of which are asked about.
class WitnessesTest : public testing::Test {
 protected:
  WitnessesTest() {
    scene_.start();
    for (int step = 2; step < 6; ++step) scene_.insert(walk(step));
  }

  const Keyframe& keyframe(std::uint64_t id) const {
    return *scene_.state.map.keyframe(KeyframeId{id});
  }

  struct Votes {
    int agreed = 0, asked = 0;
  };
  /// About the landmarks of the newest keyframe, moved away from it by a factor.
  Votes ask(std::uint64_t oldest, double distance_factor) const {
    const Keyframe& a = keyframe(5);
    const Witnesses witnesses(scene_.state, a, keyframe(oldest));
    const Vec3d center = a.T_cam_world.inverse().t;
    Votes votes;
    for (std::size_t i = 0; i < a.landmarks.size(); ++i) {
      if (a.landmarks[i] == kNoLandmark) continue;
      const Vec3d& p_world = scene_.state.map.landmark(a.landmarks[i])->p_world;
      const Vec3d asked = center + distance_factor * (p_world - center);
      ++votes.asked;
      votes.agreed += witnesses.agree(asked, static_cast<int>(i)) ? 1 : 0;
    }
    return votes;
  }

  MappedScene scene_{smallCloud(), {}};
};

TEST_F(WitnessesTest, AgreeToWhatTheySee) {
  const Votes votes = ask(0, 1.0);
  ASSERT_GT(votes.asked, 50);
  EXPECT_GE(votes.agreed, votes.asked * 9 / 10);
}

TEST_F(WitnessesTest, RefuseAPointThatOnlyTheTwoViewsAgreeOn) {
  const Votes votes = ask(0, 10.0);
  ASSERT_GT(votes.asked, 50);
  EXPECT_LE(votes.agreed, votes.asked / 10);
}

TEST_F(WitnessesTest, AreNotAskedWhenNoneWasTakenBetween) {
  const Votes votes = ask(4, 10.0);
  EXPECT_EQ(votes.agreed, votes.asked);
}

}  // namespace
}  // namespace glide
