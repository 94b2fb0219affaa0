#include "synthetic/living_room/room_light.h"

#include "synthetic/scene_builder.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

namespace glide::synthetic {
namespace {

/// A floor of 2 x 2 m at y = 0, seen from above (y points down).
Scene floorOnly() {
  Scene scene;
  Surface look;
  look.texels_per_m = 200.0F;
  addSurface({-1, 0, 1}, {2, 0, 0}, {0, 0, -2}, look, &scene);
  return scene;
}

RoomLight dark() {
  RoomLight light;
  light.sun = Vec3f::Zero();
  return light;
}

Vec3f middleOfFloor(const Scene& scene, const RoomLight& light) {
  const LitRoom room(
      scene.surfaces, std::vector<Reflector>(scene.surfaces.size(), {Vec3f::Ones(), false}), light);
  return room.at(0, 1.0F, 1.0F);
}

TEST(RoomLight, OfTheSunFallsWithTheCosine) {
  RoomLight light = dark();
  light.sun = {2.0F, 1.0F, 0.5F};
  light.to_sun = Vec3f(0, -1, 1).normalized();
  EXPECT_TRUE(middleOfFloor(floorOnly(), light).isApprox(light.sun * std::sqrt(0.5F), 1e-3F));
  light.to_sun = Vec3f::UnitY();  // under the floor
  EXPECT_EQ(middleOfFloor(floorOnly(), light), Vec3f(Vec3f::Zero()));
}

TEST(RoomLight, OfTheSunIsKeptOffByWhatStandsInItsWay) {
  Scene scene = floorOnly();
  addSurface({-0.3F, -1, 0.3F}, {0.6F, 0, 0}, {0, 0, -0.6F}, {}, &scene);  // a roof
  RoomLight light = dark();
  light.sun = Vec3f::Ones();
  light.to_sun = -Vec3f::UnitY();
  EXPECT_EQ(middleOfFloor(scene, light), Vec3f(Vec3f::Zero()));
}

TEST(RoomLight, OfABulbFallsWithTheSquareOfTheDistance) {
  RoomLight near = dark(), far = dark();
  near.bulbs.push_back({{0, -1, 0}, 0.01F, Vec3f::Ones()});
  far.bulbs.push_back({{0, -3, 0}, 0.01F, Vec3f::Ones()});
  EXPECT_NEAR(middleOfFloor(floorOnly(), near).x(), 1.0F, 2e-3F);
  EXPECT_NEAR(middleOfFloor(floorOnly(), far).x(), 1.0F / 9.0F, 1e-3F);
}

TEST(RoomLight, OfTheSkyIsThatOfTheShareOfTheHalfSpaceThatItFills) {
  RoomLight light = dark();
  // 20 cm square, 2 m above: area / (pi r^2).
  light.openings.push_back({{-0.1F, -2, -0.1F}, {0.2F, 0, 0}, {0, 0, 0.2F}, Vec3f::Ones()});
  EXPECT_NEAR(middleOfFloor(floorOnly(), light).x(), 0.04F / (3.14159F * 4.0F), 1e-4F);
}

TEST(RoomLight, IsPassedOnInTheColourOfTheWall) {
  Scene scene = floorOnly();
  addSurface({-1, -2, 0.5F}, {2, 0, 0}, {0, 2, 0}, {}, &scene);  // a wall, seen from z < 0.5
  RoomLight light = dark();
  light.sun = Vec3f::Ones();
  light.to_sun = -Vec3f::UnitZ();  // shines on the wall, along the floor
  const LitRoom room(scene.surfaces, {{Vec3f::Ones(), false}, {{0.8F, 0.1F, 0.1F}, false}}, light);
  const Vec3f floor = room.at(0, 1.0F, 0.8F);
  EXPECT_GT(floor.x(), 0.05F);
  EXPECT_NEAR(floor.y() / floor.x(), 0.125F, 0.02F);
}

}  // namespace
}  // namespace glide::synthetic
