#pragma once

#include "synthetic/living_room/room_builder.h"

#include <memory>
#include <utility>

namespace glide::synthetic {

/// One colour everywhere.
inline Look oneColor(const Rgb& color) {
  return {[color](ColorCanvas* canvas, Random*) { fill(canvas, color); }, 60.0F};
}

/// A wall that is red on the left and blue on the right, lit by a bulb; made in milliseconds.
inline std::shared_ptr<const Scene> smallColorScene() {
  RoomBuilder room;
  const Vec3f half = 2.0F * Vec3f::UnitX(), down = 3.0F * Vec3f::UnitY();
  room.add({-2.0F, -1.5F, 2.0F}, half, down, oneColor({0.9F, 0.2F, 0.2F}));
  room.add({0.0F, -1.5F, 2.0F}, half, down, oneColor({0.2F, 0.2F, 0.9F}));
  RoomLight light;
  light.sun = Vec3f::Zero();
  light.bulbs.push_back({{0.0F, 0.0F, 0.5F}, 0.1F, Vec3f::Constant(2.0F)});
  Scene scene = room.finish(light, 1);
  scene.viewpoint.target = {0.0, 0.0, 2.0};
  return std::make_shared<const Scene>(std::move(scene));
}

}  // namespace glide::synthetic
