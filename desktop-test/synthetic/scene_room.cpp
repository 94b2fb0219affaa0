#include "synthetic/scene_builder.h"

namespace glide::synthetic {

namespace {

// Metres; the floor is at y = 1.3, the camera at about the origin.
constexpr float kFloor = 1.3F;
constexpr float kRoomTexels = 400.0F;   // per metre: a texel is smaller than a pixel from 1.4 m on
constexpr float kThingTexels = 500.0F;  // furniture is closer

/// What the faces of a thing are made of.
struct Look {
  Material front, side, top;
};
constexpr Look kWooden{Material::wood, Material::wood, Material::wood};
constexpr Look kBookcase{Material::books, Material::wood, Material::desk};
constexpr Look kBookends{Material::wood, Material::books, Material::wood};
constexpr Look kSideboard{Material::wood, Material::wood, Material::desk};
constexpr Look kCabinet{Material::wood, Material::metal, Material::cardboard};
constexpr Look kCarton{Material::cardboard, Material::cardboard, Material::cardboard};
constexpr Look kParcel{Material::cardboard, Material::picture, Material::paper};
constexpr Look kScreen{Material::picture, Material::metal, Material::metal};
constexpr Look kTin{Material::picture, Material::fabric, Material::paper};
constexpr Look kCushion{Material::fabric, Material::fabric, Material::fabric};

struct Thing {
  float x, z, width, height, depth, yaw;  ///< metres, radians
  Look look;
  float bottom;  ///< y of what it stands on
};

constexpr float kOnSideboard = 0.4F;

constexpr Thing kThings[] = {
    // Along the front wall.
    {-1.75F, 2.25F, 1.0F, 2.0F, 0.35F, 0.0F, kBookcase, kFloor},
    {-0.2F, 2.15F, 1.5F, 0.9F, 0.5F, 0.0F, kSideboard, kFloor},
    {-0.6F, 2.15F, 0.42F, 0.34F, 0.3F, 0.25F, kCarton, kOnSideboard},
    {0.1F, 2.2F, 0.55F, 0.4F, 0.08F, -0.15F, kScreen, kOnSideboard},
    {0.42F, 2.0F, 0.16F, 0.25F, 0.12F, 0.6F, kTin, kOnSideboard},
    {1.5F, 2.2F, 0.9F, 1.5F, 0.45F, 0.0F, kWooden, kFloor},
    {1.4F, 2.2F, 0.5F, 0.3F, 0.35F, 0.3F, kCarton, -0.2F},
    // Nearer to the camera.
    {-1.05F, 1.35F, 0.5F, 0.9F, 0.45F, 0.5F, kCushion, kFloor},
    {0.95F, 1.45F, 0.55F, 0.75F, 0.4F, -0.4F, kCarton, kFloor},
    {0.9F, 1.42F, 0.38F, 0.32F, 0.3F, -0.1F, kParcel, 0.55F},
    // At the other walls, so that every direction has something.
    {-2.6F, -0.3F, 0.8F, 0.8F, 1.8F, 0.0F, kCushion, kFloor},
    {2.75F, 0.2F, 0.4F, 2.0F, 1.6F, 0.0F, kBookends, kFloor},
    {2.5F, -1.7F, 0.6F, 0.6F, 0.6F, 0.4F, kCarton, kFloor},
    {-0.9F, -2.25F, 1.6F, 1.1F, 0.4F, 0.0F, kBookcase, kFloor},
    {1.2F, -2.2F, 0.8F, 1.8F, 0.45F, 0.0F, kCabinet, kFloor},
};

void addThings(Scene* scene) {
  for (const Thing& thing : kThings) {
    Box box;
    box.center = {thing.x, thing.bottom - 0.5F * thing.height, thing.z};
    box.size = {thing.width, thing.height, thing.depth};
    box.yaw = thing.yaw;
    box.front = thing.look.front;
    box.side = thing.look.side;
    box.top = thing.look.top;
    addBox(box, kThingTexels, scene);
  }
}

}  // namespace

Scene makeRoom(std::uint64_t seed) {
  Scene scene;
  addInterior({{-3.0F, -1.3F, -2.5F},
               {3.0F, kFloor, 2.5F},
               Material::wall,
               Material::planks,
               Material::ceiling},
              kRoomTexels,
              &scene);
  addThings(&scene);
  addTable({{0.0F, 0.55F, -0.3F}, {1.1F, 0.75F, 0.7F}, 0.2F}, kThingTexels, &scene);
  addBox({{0.15F, 0.46F, -0.3F},
          {0.3F, 0.18F, 0.2F},
          0.7F,
          Material::cardboard,
          Material::fabric,
          Material::picture},
         kThingTexels,
         &scene);
  scene.viewpoint = {
      {0.0, 0.1, 0.35}, {0.0, 0.3, 2.0}, 1.5, {0.0, 0.5, -0.3}, 1.45, 6.283185307179586};
  const Lighting lighting{
      0.5F, {{{-1.0F, -1.25F, 0.6F}, 0.6F, 0.4F, 2.2F}, {{1.3F, -1.25F, -0.5F}, 0.6F, 0.4F, 2.2F}}};
  finishScene(lighting, seed, &scene);
  return scene;
}

}  // namespace glide::synthetic
