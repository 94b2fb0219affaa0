#include "map/landmark_summary.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

namespace glide {
namespace {

TEST(ViewingRange, LooksFromTheCamerasToThePoint) {
  const std::array<LandmarkSight, 2> sights{
      {{Vec3d(-1.0, 0.0, 0.0), 0}, {Vec3d(1.0, 0.0, 0.0), 0}}};
  const ViewingRange range = viewingRange(Vec3d(0.0, 0.0, 5.0), sights, ScaleLevels(1.2, 8));
  EXPECT_NEAR((range.normal - Vec3d(0.0, 0.0, 1.0)).norm(), 0.0, 1e-12);
}

TEST(ViewingRange, SpansThePyramidAroundTheObservedDistances) {
  const ScaleLevels levels(1.2, 8);
  const std::array<LandmarkSight, 2> sights{{{Vec3d(0.0, 0.0, 3.0), 2}, {Vec3d(0.0, 0.0, 0.0), 1}}};
  const ViewingRange range = viewingRange(Vec3d(0.0, 0.0, 5.0), sights, levels);
  EXPECT_NEAR(range.max_distance, std::sqrt(2.0 * 1.44 * 5.0 * 1.2), 1e-9);
  EXPECT_NEAR(range.min_distance, range.max_distance / levels.scale(7), 1e-9);
}

TEST(ViewingRange, StaysFiniteWhenACameraSitsOnThePoint) {
  const std::array<LandmarkSight, 1> sights{{{Vec3d(1.0, 2.0, 3.0), 0}}};
  const ViewingRange range = viewingRange(Vec3d(1.0, 2.0, 3.0), sights, ScaleLevels(1.2, 8));
  EXPECT_TRUE(range.normal.allFinite());
  EXPECT_TRUE(std::isfinite(range.max_distance));
}

TEST(Medoid, IsTheDescriptorClosestToTheOthers) {
  const Descriptor base{0xFFU, 0U, 0U, 0U};
  Descriptor near = base;
  near[1] = 0x3U;
  Descriptor nearer = base;
  nearer[1] = 0x1U;
  const Descriptor outlier{0U, ~0ULL, 0U, 0U};
  const std::vector<const Descriptor*> all{&outlier, &near, &nearer, &base};
  EXPECT_EQ(medoid(all), 2U);
  const std::vector<const Descriptor*> one{&outlier};
  EXPECT_EQ(medoid(one), 0U);
}

}  // namespace
}  // namespace glide
