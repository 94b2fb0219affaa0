// The scenes that one walks around: a corridor and a hall.
#include "synthetic/furnishing.h"

#include <algorithm>
#include <array>

namespace glide::synthetic {

namespace {

// Metres; the floor is at y = 1.4, the camera at y = 0.
constexpr float kFloor = 1.4F;
constexpr double kShortest = 60.0, kLongest = 200.0;  // metres once around

/// A block that the way surrounds: half of its sides.
struct HalfSizes {
  float x, z;
};

Surface lookOf(Material material, float texels_per_m) {
  Surface look;
  look.material = material;
  look.texels_per_m = texels_per_m;
  return look;
}

RoundTrip makeTrip(double corner_radius, Random* random) {
  constexpr float kNarrowest = 0.3F;  // of half_x + half_z
  RoundTrip trip;
  trip.corner_radius = corner_radius;
  const double length = kShortest + (kLongest - kShortest) * random->uniform();
  const double sum = halfSizesOfRound(length, corner_radius);
  trip.half_x = sum * random->uniform(kNarrowest, 1.0F - kNarrowest);
  trip.half_z = sum - trip.half_x;
  trip.is_mirrored = random->below(2) == 1;
  return trip;
}

/// The four walls of a rectangle: those of a room seen from inside, or of a block seen from around.
enum class Facing { inwards, outwards };
std::array<WallRun, 4> wallsOf(const HalfSizes& half, Facing facing) {
  const float sign = facing == Facing::inwards ? -1.0F : 1.0F;
  return {{{{half.x, kFloor, 0.0F}, {sign, 0.0F, 0.0F}, 2.0F * half.z},
           {{-half.x, kFloor, 0.0F}, {-sign, 0.0F, 0.0F}, 2.0F * half.z},
           {{0.0F, kFloor, half.z}, {0.0F, 0.0F, sign}, 2.0F * half.x},
           {{0.0F, kFloor, -half.z}, {0.0F, 0.0F, -sign}, 2.0F * half.x}}};
}

HalfSizes grown(const RoundTrip& trip, float metres) {
  return {static_cast<float>(trip.half_x) + metres, static_cast<float>(trip.half_z) + metres};
}

/// A floor and a ceiling of the corridor; `along` is its direction, its right is where v grows on
/// the floor.
void addStrip(const Vec3f& middle, const Vec3f& along, float width, float height, Scene* scene) {
  constexpr float kTexels = 130.0F;
  const Vec3f right = width * Vec3f::UnitY().cross(along).normalized();
  const Vec3f start = middle - 0.5F * along;
  addSurface(start - 0.5F * right, along, right, lookOf(Material::planks, kTexels), scene);
  const Vec3f up = -height * Vec3f::UnitY();
  addSurface(start + 0.5F * right + up, along, -right, lookOf(Material::ceiling, kTexels), scene);
}

void finish(const RoundTrip& trip, const Pace& pace, Scene* scene) {
  scene->viewpoint.way = walkAround(trip, pace);
  scene->viewpoint.eye = {0.0, 0.0, 0.0};
  scene->viewpoint.depth = 2.5;
}

constexpr std::array kAlongCorridor{
    Furniture{0.9F, 1.0F, 2.0F, 0.06F, 0.0F, Material::wood, Material::wood, Material::wood},
    Furniture{0.8F, 1.6F, 1.9F, 0.28F, 0.0F, Material::books, Material::wood, Material::desk},
    Furniture{1.0F, 1.8F, 0.9F, 0.05F, 1.1F, Material::picture, Material::wood, Material::wood},
    Furniture{
        0.4F, 0.7F, 0.5F, 0.35F, 0.0F, Material::cardboard, Material::cardboard, Material::paper},
    Furniture{0.8F, 1.3F, 0.65F, 0.12F, 0.0F, Material::metal, Material::metal, Material::metal},
    Furniture{0.4F, 0.6F, 1.1F, 0.35F, 0.0F, Material::fabric, Material::fabric, Material::fabric},
    Furniture{0.5F, 0.8F, 1.4F, 0.3F, 0.0F, Material::metal, Material::picture, Material::desk},
};

constexpr std::array kAlongHall{
    Furniture{1.5F, 3.0F, 2.4F, 0.5F, 0.0F, Material::books, Material::wood, Material::wood},
    Furniture{
        0.8F, 1.6F, 1.3F, 0.8F, 0.0F, Material::cardboard, Material::cardboard, Material::desk},
    Furniture{1.0F, 2.0F, 1.8F, 0.7F, 0.0F, Material::metal, Material::picture, Material::metal},
    Furniture{1.5F, 2.5F, 1.5F, 0.06F, 1.6F, Material::picture, Material::wood, Material::wood},
    Furniture{0.6F, 1.2F, 0.9F, 0.6F, 0.0F, Material::fabric, Material::fabric, Material::fabric},
    Furniture{1.0F, 1.8F, 3.2F, 0.3F, 0.0F, Material::wood, Material::wood, Material::wood},
};

}  // namespace

Scene makeCorridor(std::uint64_t seed) {
  constexpr float kHalfWidth = 1.2F, kHeight = 2.6F, kWallTexels = 150.0F;
  Random random(mixBits(seed) ^ 0xC0);
  const RoundTrip trip = makeTrip(1.2, &random);
  const HalfSizes outer = grown(trip, kHalfWidth), inner = grown(trip, -kHalfWidth);
  Scene scene;
  for (const Facing facing : {Facing::inwards, Facing::outwards}) {
    for (const WallRun& run : wallsOf(facing == Facing::inwards ? outer : inner, facing)) {
      addWall(run, kHeight, lookOf(Material::wall, kWallTexels), &scene);
      furnish(run, kAlongCorridor, {2.6F, 0.6F, 2.5F}, &random, &scene);
    }
  }
  for (const float side : {-1.0F, 1.0F}) {
    const auto x = static_cast<float>(trip.half_x), z = static_cast<float>(trip.half_z);
    const float width = 2.0F * kHalfWidth;
    addStrip({side * x, kFloor, 0.0F}, {0.0F, 0.0F, 2.0F * outer.z}, width, kHeight, &scene);
    addStrip({0.0F, kFloor, side * z}, {2.0F * inner.x, 0.0F, 0.0F}, width, kHeight, &scene);
  }
  finish(trip, {3.0, 1.2, 0.0}, &scene);
  finishScene({0.85F, {}}, seed, &scene);
  return scene;
}

Scene makeHall(std::uint64_t seed) {
  constexpr float kToWall = 3.2F, kToRacks = 2.4F, kHeight = 4.2F, kTexels = 90.0F;
  Random random(mixBits(seed) ^ 0xA1);
  const RoundTrip trip = makeTrip(2.5, &random);
  const HalfSizes outer = grown(trip, kToWall), inner = grown(trip, -kToRacks);
  Scene scene;
  addInterior({{-outer.x, kFloor - kHeight, -outer.z},
               {outer.x, kFloor, outer.z},
               Material::wall,
               Material::planks,
               Material::ceiling},
              kTexels,
              &scene);
  for (const WallRun& run : wallsOf(outer, Facing::inwards))
    furnish(run, kAlongHall, {1.5F, 0.3F, 2.0F}, &random, &scene);
  for (WallRun run : wallsOf(inner, Facing::outwards)) {
    run.foot -= run.normal;  // the racks stand inside of the rectangle
    furnish(run, kAlongHall, {1.0F, 0.8F, 3.0F}, &random, &scene);
  }
  finish(trip, {3.0, 1.2, -0.6}, &scene);
  finishScene({0.85F, {}}, seed, &scene);
  return scene;
}

}  // namespace glide::synthetic
