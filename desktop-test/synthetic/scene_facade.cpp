#include "synthetic/scene_builder.h"

namespace glide::synthetic {

namespace {

// Metres; the street is at y = 1.6, the camera on the other pavement at about the origin.
constexpr float kStreet = 1.6F, kWall = 8.0F;
constexpr float kTexels = 120.0F;    // per metre: a texel is smaller than a pixel from 4.4 m on
constexpr float kFarTexels = 12.0F;  // what is tens of metres away

void addWindows(Scene* scene) {
  constexpr float kPitch = 2.6F, kStorey = 2.9F;
  for (int storey = 0; storey < 3; ++storey) {
    for (int column = -4; column <= 4; ++column) {
      const float x = kPitch * static_cast<float>(column),
                  y = -0.2F - kStorey * static_cast<float>(storey);
      const bool is_bay = (column + storey) % 3 == 0;  // some stand out: depth in the facade
      const float depth = is_bay ? 0.7F : 0.12F;
      addBox({{x, y, kWall - 0.5F * depth},
              {1.3F, 1.7F, depth},
              0.0F,
              Material::window,
              Material::bricks,
              Material::metal},
             kTexels,
             scene);
      addBox({{x, y + 0.95F, kWall - 0.5F * depth - 0.1F},
              {1.6F, 0.12F, depth + 0.2F},
              0.0F,
              Material::wall,
              Material::wall,
              Material::wall},
             kTexels,
             scene);
    }
  }
}

void addStreetThings(Scene* scene) {
  const Material metal = Material::metal;
  for (const float x : {-5.2F, 0.6F, 6.0F}) {  // pillars before the wall
    addBox({{x, -3.0F, kWall - 0.35F},
            {0.5F, 9.2F, 0.7F},
            0.0F,
            Material::bricks,
            Material::bricks,
            metal},
           kTexels,
           scene);
  }
  addBox({{-3.0F, kStreet - 0.75F, 5.6F}, {3.6F, 1.5F, 1.6F}, 0.08F, metal, metal, metal},
         kTexels,
         scene);
  addBox(
      {{3.4F, kStreet - 0.6F, 5.3F}, {1.8F, 1.2F, 1.1F}, -0.3F, Material::cardboard, metal, metal},
      kTexels,
      scene);
  addBox({{1.2F, kStreet - 1.1F, 4.4F},
          {0.25F, 2.2F, 0.25F},
          0.5F,
          Material::picture,
          Material::picture,
          metal},
         2.0F * kTexels,
         scene);
  addBox({{-1.2F, kStreet - 0.5F, 3.8F},
          {0.7F, 1.0F, 0.5F},
          0.4F,
          Material::fabric,
          Material::fabric,
          metal},
         2.0F * kTexels,
         scene);
}

}  // namespace

Scene makeFacade(std::uint64_t seed) {
  Scene scene;
  Surface look;
  look.material = Material::bricks;
  look.texels_per_m = kTexels;
  addSurface({-12.0F, -8.0F, kWall}, {24.0F, 0.0F, 0.0F}, {0.0F, 9.6F, 0.0F}, look, &scene);
  look.material = Material::asphalt;
  addSurface({-14.0F, kStreet, kWall}, {28.0F, 0.0F, 0.0F}, {0.0F, 0.0F, -12.0F}, look, &scene);
  addWindows(&scene);
  addStreetThings(&scene);
  addBox({{-15.0F, -2.0F, 6.0F},
          {3.0F, 7.2F, 9.0F},
          0.1F,
          Material::wall,
          Material::bricks,
          Material::metal},
         0.5F * kTexels,
         &scene);
  addBox({{16.5F, -3.5F, 12.0F},
          {6.0F, 10.2F, 9.0F},
          -0.2F,
          Material::bricks,
          Material::bricks,
          Material::metal},
         0.5F * kTexels,
         &scene);
  look.material = Material::sky;
  look.texels_per_m = kFarTexels;
  const float sky = 60.0F;
  addSurface({-sky, -sky, sky}, {2 * sky, 0.0F, 0.0F}, {0.0F, 1.2F * sky, 0.0F}, look, &scene);
  scene.viewpoint = {{0.0, 0.0, 0.5}, {0.0, -0.3, 8.0}, 5.5, {0.0, 0.0, 6.5}, 5.5, 1.4};
  const Lighting lighting{0.7F, {{{-20.0F, -40.0F, -30.0F}, 3.0F, 0.9F, 60.0F}}};
  finishScene(lighting, seed, &scene);
  return scene;
}

Scene makeDesk(std::uint64_t seed) {
  constexpr float kDeskTexels = 900.0F;  // per metre: a texel is smaller than a pixel from 0.6 m on
  Scene scene;
  Surface look;
  look.material = Material::desk;
  look.texels_per_m = kDeskTexels;
  addSurface({-1.6F, -1.2F, 0.9F}, {3.2F, 0.0F, 0.0F}, {0.0F, 2.4F, 0.0F}, look, &scene);
  scene.viewpoint = {{0.0, 0.25, 0.0}, {0.0, 0.0, 0.9}, 0.9, {0.0, 0.0, 0.9}, 0.9, 1.2};
  finishScene({0.45F, {{{-0.8F, -0.9F, -1.2F}, 0.5F, 0.5F, 2.5F}}}, seed, &scene);
  return scene;
}

}  // namespace glide::synthetic
