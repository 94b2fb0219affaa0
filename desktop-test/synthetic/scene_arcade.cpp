// A street front whose bays are alike: for places that must not be mistaken for each other.
#include "synthetic/furnishing.h"

#include <cmath>

namespace glide::synthetic {

namespace {

// Metres; the street is at y = 1.6, the camera at y = 0 and z = 0.
constexpr float kStreet = 1.6F, kWall = 6.0F, kHeight = 9.0F;
constexpr float kPitch = 2.7F, kStorey = 2.9F;  // nine bricks; from floor to floor
constexpr float kTexels = 110.0F;               // per metre
constexpr int kStoreys = 3;
constexpr float kBeyond = 12.0F;  // metres of front beyond the ends of the walk

/// What all bays share gets one pattern each.
enum Pattern : int { masonry, window, sill, pillar, lantern, planter };

void addWindow(float x, float y, Scene* scene) {
  constexpr float kDepth = 0.15F;
  addBox({{x, y, kWall - 0.5F * kDepth},
          {1.3F, 1.7F, kDepth},
          0.0F,
          Material::window,
          Material::bricks,
          Material::metal,
          Pattern::window},
         kTexels,
         scene);
  addBox({{x, y + 0.95F, kWall - 0.17F},
          {1.6F, 0.12F, 0.34F},
          0.0F,
          Material::wall,
          Material::wall,
          Material::wall,
          Pattern::sill},
         kTexels,
         scene);
}

/// A pillar that stands out and a planter on the pavement: depth, without which a street front is
/// a plane.
void addForeground(float x, Scene* scene) {
  constexpr float kPillar = 0.9F, kPlanter = 0.8F;  // metres: depth, height
  addBox({{x - 0.5F * kPitch, kStreet - 0.5F * kHeight, kWall - 0.5F * kPillar},
          {0.4F, kHeight, kPillar},
          0.0F,
          Material::bricks,
          Material::bricks,
          Material::metal,
          Pattern::pillar},
         kTexels,
         scene);
  addBox({{x + 0.4F, kStreet - 0.5F * kPlanter, kWall - 2.2F},
          {0.9F, kPlanter, 0.45F},
          0.0F,
          Material::fabric,
          Material::fabric,
          Material::desk,
          Pattern::planter},
         kTexels,
         scene);
}

/// One bay: masonry, windows, what stands before them.
void addBay(float x, int masonry_pattern, Scene* scene) {
  Surface bricks;
  bricks.material = Material::bricks;
  bricks.texels_per_m = kTexels;
  bricks.pattern = masonry_pattern;
  addWall({{x, kStreet, kWall}, {0.0F, 0.0F, -1.0F}, kPitch}, kHeight, bricks, scene);
  for (int storey = 0; storey < kStoreys; ++storey)
    addWindow(x, -0.1F - kStorey * static_cast<float>(storey), scene);
  addForeground(x, scene);
}

void addLantern(float x, Scene* scene) {
  addBox({{x, kStreet - 1.3F, kWall - 2.8F},
          {0.18F, 2.6F, 0.18F},
          0.0F,
          Material::metal,
          Material::metal,
          Material::metal,
          Pattern::lantern},
         2.0F * kTexels,
         scene);
}

/// Posters and goods before some of the bays: all that tells them apart but for the street.
void addOwnThings(float x, Random* random, Scene* scene) {
  constexpr float kShare = 0.3F;  // of the bays
  if (random->uniform() < kShare) {
    const float size = random->uniform(0.4F, 0.7F);
    addBox({{x + 0.85F, random->uniform(-0.6F, 0.4F), kWall - 0.02F},
            {0.55F, size, 0.04F},
            0.0F,
            Material::picture,
            Material::wood,
            Material::wood},
           2.0F * kTexels,
           scene);
  }
  if (random->uniform() < kShare) {
    const float height = random->uniform(0.5F, 0.9F);
    addBox({{x + random->uniform(-0.6F, 0.6F), kStreet - 0.5F * height, kWall - 0.9F},
            {random->uniform(0.4F, 0.9F), height, 0.6F},
            random->uniform(-0.4F, 0.4F),
            Material::cardboard,
            Material::fabric,
            Material::desk},
           kTexels,
           scene);
  }
}

void addGround(float half_length, Scene* scene) {
  constexpr float kStreetTexels = 60.0F, kFarTexels = 8.0F, kSky = 60.0F;
  Surface look;
  look.material = Material::asphalt;
  look.texels_per_m = kStreetTexels;
  addSurface({-half_length, kStreet, kWall},
             {2.0F * half_length, 0.0F, 0.0F},
             {0.0F, 0.0F, -8.0F},
             look,
             scene);
  look.material = Material::sky;
  look.texels_per_m = kFarTexels;
  const float half_sky = half_length + kSky;
  addSurface({-half_sky, -kSky, kSky},
             {2.0F * half_sky, 0.0F, 0.0F},
             {0.0F, 1.2F * kSky, 0.0F},
             look,
             scene);
}

}  // namespace

Scene makeArcade(std::uint64_t seed) {
  constexpr double kShortest = 30.0, kLongest = 60.0;  // metres
  constexpr double kAhead = 0.35;  // radians by which one looks ahead while walking along the front
  Random random(mixBits(seed) ^ 0xFA);
  const double length = kShortest + (kLongest - kShortest) * random.uniform();
  const double direction = random.below(2) == 0 ? 1.0 : -1.0;
  const float half_length = 0.5F * static_cast<float>(length) + kBeyond;
  const int masonry_pattern = seed % 2 == 0 ? Surface::kUnique : Pattern::masonry;
  Scene scene;
  const int bays = static_cast<int>(std::ceil(half_length / kPitch));
  for (int bay = -bays; bay <= bays; ++bay) {
    const float x = kPitch * static_cast<float>(bay);
    addBay(x, masonry_pattern, &scene);
    if (bay % 3 == 0) addLantern(x, &scene);
    addOwnThings(x, &random, &scene);
  }
  addGround(half_length, &scene);
  const Straight line{-0.5 * direction * length, 0.5 * direction * length, 0.0};
  scene.viewpoint.way = walkStraight(line, {2.0, 1.0, direction * (kAhead - 1.5707963267948966)});
  scene.viewpoint.eye = {0.0, 0.0, 0.0};
  scene.viewpoint.depth = kWall;
  finishScene({0.85F, {}}, seed, &scene);
  return scene;
}

}  // namespace glide::synthetic
