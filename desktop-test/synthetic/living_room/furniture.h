#pragma once

#include "synthetic/living_room/painters.h"
#include "synthetic/living_room/room_builder.h"

// Things of a living room. All stand on `stand` with their front towards its front; metres.
namespace glide::synthetic {

/// How fine the textures are, texels per metre.
inline constexpr float kThingTexels = 420.0F;

/// Filled with books and a few other things.
void addBookcase(const Stand& stand, const Vec3f& size, Random* random, RoomBuilder* room);
void addSofa(const Stand& stand, RoomBuilder* room);
void addArmchair(const Stand& stand, RoomBuilder* room);
/// Four legs and a top.
void addTable(const Stand& stand, const Vec3f& size, const Wood& tones, RoomBuilder* room);
void addChair(const Stand& stand, RoomBuilder* room);
void addSideboard(const Stand& stand, RoomBuilder* room);

/// What stands on tables.
void addCoffeeTableThings(const Stand& top, Random* random, RoomBuilder* room);
void addDeskThings(const Stand& top, RoomBuilder* room);
void addHiFi(const Stand& top, RoomBuilder* room);
void addBookStack(const Stand& stand, int books, Random* random, RoomBuilder* room);

struct PlantShape {
  float height;  ///< of the trunk
  int leaves;
  float leaf_length;
};
void addPlant(const Stand& stand, const PlantShape& shape, Random* random, RoomBuilder* room);

/// The lamps' shades shine; where their light comes from is returned.
Bulb addFloorLamp(const Stand& stand, RoomBuilder* room);
Bulb addPendantLamp(const Vec3f& ceiling_point, float drop, RoomBuilder* room);

/// Hangs on a wall: `place` is the picture's lower edge, its front turned away from the wall.
void addPicture(const Stand& place, const Vec2f& size, const Painter& picture, RoomBuilder* room);

}  // namespace glide::synthetic
