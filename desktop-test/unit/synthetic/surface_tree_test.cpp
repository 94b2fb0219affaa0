#include "synthetic/living_room/surface_tree.h"

#include "synthetic/ray_caster.h"
#include "synthetic/scene_builder.h"

#include <gtest/gtest.h>

#include <numeric>

namespace glide::synthetic {
namespace {

Vec3f randomPoint(Random* random) {
  return {random->uniform(-2, 2), random->uniform(-2, 2), random->uniform(-2, 2)};
}

/// Rectangles and ellipses all over the place.
std::vector<Surface> scattered(int count) {
  Random random(7);
  Scene scene;
  for (int i = 0; i < count; ++i) {
    const Vec3f u = randomPoint(&random).normalized();
    const Vec3f v = u.cross(randomPoint(&random)).normalized();
    Surface look;
    look.is_round = i % 3 == 0;
    addSurface(randomPoint(&random), 0.6F * u, 0.4F * v, look, &scene);
  }
  return scene.surfaces;
}

std::vector<int> allOf(const std::vector<Surface>& surfaces) {
  std::vector<int> indices(surfaces.size());
  std::iota(indices.begin(), indices.end(), 0);
  return indices;
}

TEST(SurfaceTree, FindsWhatTryingEverySurfaceFinds) {
  const std::vector<Surface> surfaces = scattered(60);
  const SurfaceTree tree(surfaces, allOf(surfaces));
  RayCaster caster;  // sees the front sides only
  for (const Surface& surface : surfaces) caster.add(surface);
  Random random(3);
  int met = 0;
  for (int i = 0; i < 2000; ++i) {
    const Vec3f from = randomPoint(&random), direction = randomPoint(&random);
    caster.moveTo(from);
    const Hit hit = caster.trace(direction);
    const Meeting meeting = tree.nearest(from, direction);
    if (meeting.index < 0 || meeting.is_from_behind) continue;
    ++met;
    EXPECT_EQ(meeting.index, hit.index);
    EXPECT_NEAR(meeting.range, hit.range, 1e-4F);
  }
  EXPECT_GT(met, 50);
}

TEST(SurfaceTree, BlocksFromBothSidesAndOnlyInBetween) {
  Scene scene;
  addSurface({-1, -1, 1}, {2, 0, 0}, {0, 2, 0}, {}, &scene);
  const SurfaceTree tree(scene.surfaces, {0});
  EXPECT_TRUE(tree.isBlocked({0, 0, 0}, {0, 0, 2}));
  EXPECT_TRUE(tree.isBlocked({0, 0, 2}, {0, 0, 0}));
  EXPECT_FALSE(tree.isBlocked({0, 0, 0}, {0, 0, 0.9F}));
  EXPECT_FALSE(tree.isBlocked({1.5F, 0, 0}, {1.5F, 0, 2}));
  EXPECT_TRUE(tree.nearest({0, 0, 2}, {0, 0, -1}).is_from_behind);
}

TEST(SurfaceTree, LetsLightPastTheCornersOfAnEllipse) {
  Scene scene;
  Surface look;
  look.is_round = true;
  addSurface({-1, -1, 1}, {2, 0, 0}, {0, 2, 0}, look, &scene);
  const SurfaceTree tree(scene.surfaces, {0});
  EXPECT_TRUE(tree.isBlocked({0.6F, 0.6F, 0}, {0.6F, 0.6F, 2}));
  EXPECT_FALSE(tree.isBlocked({0.9F, 0.9F, 0}, {0.9F, 0.9F, 2}));
}

}  // namespace
}  // namespace glide::synthetic
