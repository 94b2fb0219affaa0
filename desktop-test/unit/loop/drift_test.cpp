#include "loop/drift.h"

#include <gtest/gtest.h>

namespace glide {
namespace {

constexpr double kStep = 1.0;
constexpr double kDepth = 4.0;

/// Ten keyframes in a row along x, one unit apart; the first sees one landmark.
MapSnapshot row() {
  MapSnapshot::Parts parts;
  for (std::uint64_t i = 0; i < 10; ++i) {
    MapSnapshot::KeyframeEntry keyframe;
    keyframe.id = KeyframeId{i};
    keyframe.T_cam_world.t = Vec3d(-kStep * static_cast<double>(i), 0.0, 0.0);
    if (i > 0) keyframe.neighbors = {{KeyframeId{i - 1}, 50}};
    if (i == 0) keyframe.landmarks = {LandmarkId{0}};
    parts.keyframes.push_back(keyframe);
  }
  MapSnapshot::LandmarkEntry landmark{};
  landmark.p_world = Vec3d(0.0, 0.0, kDepth);
  landmark.normal = Vec3d::UnitZ();
  parts.landmarks.push_back(landmark);
  return MapSnapshot(std::move(parts));
}

class PlausibleDrift : public testing::Test {
 protected:
  bool isPlausible(const Sim3d& S_from_to) const {
    return isPlausibleDrift({KeyframeId{0}, KeyframeId{9}, S_from_to}, map_, graph_);
  }

  const MapSnapshot map_ = row();
  const KeyframeGraph graph_{map_};
  const Sim3d as_mapped_{Eigen::Quaterniond::Identity(), Vec3d(9.0, 0.0, 0.0), 1.0};
};

TEST_F(PlausibleDrift, IsWhatTheMapSaysAndALittleElse) {
  EXPECT_TRUE(isPlausible(as_mapped_));
  Sim3d off = as_mapped_;
  off.t += Vec3d(0.0, 1.0, -1.0);
  off.s = 1.4;
  off.q = so3Exp(Vec3d(0.1, 0.2, 0.1));
  EXPECT_TRUE(isPlausible(off));
}

TEST_F(PlausibleDrift, IsNoGapOfAQuarterOfThePath) {
  Sim3d off = as_mapped_;
  off.t.x() -= 2.25;
  EXPECT_FALSE(isPlausible(off));
}

TEST_F(PlausibleDrift, IsNoThreefoldScaleEitherWay) {
  Sim3d off = as_mapped_;
  off.s = 3.0;
  EXPECT_FALSE(isPlausible(off));
  off.s = 1.0 / 3.0;
  EXPECT_FALSE(isPlausible(off));
}

TEST_F(PlausibleDrift, IsNoTurnOfSixtyDegrees) {
  Sim3d off = as_mapped_;
  off.q = so3Exp(Vec3d(0.0, 1.05, 0.0));
  EXPECT_FALSE(isPlausible(off));
}

TEST_F(PlausibleDrift, AllowsShortPathsAShareOfTheDepth) {
  Sim3d off;
  off.t.x() = 0.04 * kDepth;
  EXPECT_TRUE(isPlausibleDrift({KeyframeId{0}, KeyframeId{0}, off}, map_, graph_));
  off.t.x() = 0.06 * kDepth;
  EXPECT_FALSE(isPlausibleDrift({KeyframeId{0}, KeyframeId{0}, off}, map_, graph_));
}

TEST_F(PlausibleDrift, KnowsNothingOfKeyframesThatAreGone) {
  EXPECT_FALSE(isPlausibleDrift({KeyframeId{0}, KeyframeId{77}, as_mapped_}, map_, graph_));
}

}  // namespace
}  // namespace glide
