#include "synthetic/living_room/furniture.h"

#include <algorithm>
#include <array>
#include <cmath>

// Sizes are in metres: what such things look like, nothing is derived from them.
namespace glide::synthetic {

namespace {

Look lookOf(const Painter& painter) { return {painter, kThingTexels}; }

/// Boxes with the same look all around, relative to where a thing stands.
class Maker {
 public:
  Maker(const Stand& stand, RoomBuilder* room) : stand_(stand), room_(room) {}

  struct Place {
    float right, up, back;
    float turn = 0.0F;
  };
  void box(const Place& place, const Vec3f& size, const Painter& painter) const {
    room_->addBox(standAt(place), size, allAround(lookOf(painter)));
  }
  void slab(const Place& place, const Vec3f& size, const Painter& painter) const {
    room_->addSlab(standAt(place), size, allAround(lookOf(painter)));
  }
  void box(const Place& place, const Vec3f& size, const BoxLook& look) const {
    room_->addBox(standAt(place), size, look);
  }
  Stand standAt(const Place& place) const {
    return stand_.stand(place.right, place.up, place.back, place.turn);
  }

 private:
  const Stand stand_;
  RoomBuilder* room_;
};

BoxLook bookRow() {
  return {lookOf(bookSpines()), lookOf(plain(hex(0x4E3B30))), lookOf(bookPages())};
}

/// What stands between books.
void addOrnament(const Stand& stand, Random* random, RoomBuilder* room) {
  const std::array painters{ceramic(hex(0x2F6F7E), hex(0xE8DCC0)),
                            ceramic(hex(0xE3D8C3), hex(0x9C3D2C)),
                            ceramic(hex(0xC79A3B), hex(0x3A3A3A))};
  const Look wall = lookOf(painters[static_cast<std::size_t>(random->below(3))]);
  const float radius = random->uniform(0.045F, 0.06F), height = random->uniform(0.12F, 0.22F);
  room->addDrum(stand, {radius, height, 8}, wall, lookOf(plain(hex(0x2A2522))));
}

/// Books, ornaments and gaps along one board.
void fillShelf(const Stand& board, const Vec2f& room_inside, Random* random, RoomBuilder* room) {
  const float half = 0.5F * room_inside.x(), depth = room_inside.y();
  for (float x = -half + random->uniform(0.0F, 0.03F); x < half - 0.08F;) {
    const float kind = random->uniform();
    if (kind < 0.14F) {
      addOrnament(board.stand(x + 0.07F, 0, -0.05F, 0), random, room);
      x += 0.15F;
    } else if (kind < 0.26F) {
      addBookStack(board.stand(x + 0.12F, 0, -0.02F, 0), 3, random, room);
      x += 0.25F;
    } else {
      const float width = std::min(random->uniform(0.13F, 0.32F), half - x);
      const Vec3f size(width, random->uniform(0.2F, 0.28F), random->uniform(0.15F, 0.21F));
      room->addBox(
          board.stand(x + 0.5F * width, 0, 0.5F * (size.z() - depth) + 0.03F, 0), size, bookRow());
      x += width + random->uniform(0.004F, 0.05F);
    }
  }
}

}  // namespace

void addBookcase(const Stand& stand, const Vec3f& size, Random* random, RoomBuilder* room) {
  constexpr float kBoard = 0.028F, kPitch = 0.345F;
  const Maker make(stand, room);
  const float w = size.x(), h = size.y(), d = size.z();
  for (const float side : {-0.5F, 0.5F})
    make.slab({side * (w - kBoard), 0, 0}, {kBoard, h, d}, wood(kWalnut));
  room->add(stand.at(-0.5F * w, h, 0.5F * d - 0.01F),
            stand.at(w, 0, 0) - stand.foot,
            h * Vec3f::UnitY(),
            lookOf(wood({0.8F * kWalnut.light, 0.8F * kWalnut.dark})));
  for (float y = 0.06F; y < h; y += kPitch) {
    make.slab({0, y, 0}, {w - 2 * kBoard, kBoard, d - 0.01F}, wood(kWalnut));
    if (y + kPitch < h + 0.1F)
      fillShelf(stand.stand(0, y + kBoard, 0, 0), {w - 2 * kBoard, d}, random, room);
  }
}

void addSofa(const Stand& stand, RoomBuilder* room) {
  const Painter cloth = weave(hex(0x4E6E78), hex(0x3C5962));
  const Maker make(stand, room);
  make.box({0, 0.06F, 0}, {2.0F, 0.26F, 0.85F}, cloth);
  make.box({0, 0.32F, 0.34F}, {1.76F, 0.5F, 0.2F}, cloth);
  for (const float side : {-1.0F, 1.0F}) {
    make.box({0.95F * side, 0.06F, 0}, {0.18F, 0.54F, 0.87F}, cloth);
    make.box(
        {0.43F * side, 0.32F, -0.08F}, {0.83F, 0.15F, 0.64F}, weave(hex(0x587A84), hex(0x45646E)));
    make.box({0.85F * side, 0, -0.35F}, {0.05F, 0.06F, 0.05F}, wood(kBlackened));
  }
  make.box(
      {-0.66F, 0.47F, 0.14F, 0.25F}, {0.44F, 0.4F, 0.13F}, zigzag(hex(0xE2C044), hex(0x8A5A1C)));
  make.box({-0.3F, 0.47F, 0.17F, -0.15F}, {0.4F, 0.36F, 0.12F}, dots(hex(0xB84A32), hex(0xF2E3C6)));
  make.box(
      {0.64F, 0.47F, 0.15F, -0.3F}, {0.46F, 0.42F, 0.13F}, stripes(hex(0xEDE3CF), hex(0x2F4E63)));
  // A blanket over the arm.
  make.box({0.95F, 0.585F, -0.05F}, {0.21F, 0.03F, 0.5F}, stripes(hex(0xC9573C), hex(0xEBD9B4)));
}

void addArmchair(const Stand& stand, RoomBuilder* room) {
  const Painter cloth = zigzag(hex(0xC9922E), hex(0xA87420));
  const Maker make(stand, room);
  make.box({0, 0.14F, 0}, {0.7F, 0.28F, 0.7F}, cloth);
  make.box({0, 0.42F, 0.28F}, {0.6F, 0.48F, 0.16F}, cloth);
  for (const float side : {-1.0F, 1.0F}) {
    make.box({0.37F * side, 0.14F, 0}, {0.11F, 0.44F, 0.7F}, cloth);
    make.box({0.3F * side, 0, -0.28F}, {0.04F, 0.14F, 0.04F}, wood(kOak));
    make.box({0.3F * side, 0, 0.28F}, {0.04F, 0.14F, 0.04F}, wood(kOak));
  }
  make.box({0.05F, 0.42F, 0.1F, 0.2F}, {0.4F, 0.38F, 0.12F}, dots(hex(0x2F5560), hex(0xE9DDBF)));
}

void addTable(const Stand& stand, const Vec3f& size, const Wood& tones, RoomBuilder* room) {
  constexpr float kTop = 0.035F, kLeg = 0.055F;
  const Maker make(stand, room);
  const float leg_height = size.y() - kTop;
  make.slab({0, leg_height, 0}, {size.x(), kTop, size.z()}, wood(tones));
  make.box({0, leg_height - 0.07F, 0}, {size.x() - 0.1F, 0.07F, size.z() - 0.1F}, wood(tones));
  for (const float x : {-0.5F, 0.5F}) {
    for (const float z : {-0.5F, 0.5F}) {
      make.box({x * (size.x() - 0.12F), 0, z * (size.z() - 0.12F)},
               {kLeg, leg_height, kLeg},
               wood(tones));
    }
  }
}

void addChair(const Stand& stand, RoomBuilder* room) {
  const Maker make(stand, room);
  make.slab({0, 0.44F, 0}, {0.44F, 0.04F, 0.42F}, wood(kBirch));
  make.box({0, 0.48F, -0.02F}, {0.4F, 0.035F, 0.36F}, dots(hex(0x3F6F64), hex(0xE9E2CC)));
  for (const float x : {-0.19F, 0.19F}) {
    make.box({x, 0, -0.18F}, {0.04F, 0.44F, 0.04F}, wood(kBirch));
    make.box({x, 0, 0.19F}, {0.04F, 0.92F, 0.04F}, wood(kBirch));
  }
  for (const float y : {0.62F, 0.74F, 0.86F})
    make.slab({0, y, 0.19F}, {0.36F, 0.06F, 0.02F}, wood(kBirch));
}

void addSideboard(const Stand& stand, RoomBuilder* room) {
  const Maker make(stand, room);
  make.box({0, 0.12F, 0}, {1.7F, 0.6F, 0.42F}, wood(kOak));
  make.slab({0, 0.72F, 0}, {1.76F, 0.03F, 0.45F}, wood(kWalnut));
  for (const float x : {-0.63F, -0.21F, 0.21F, 0.63F}) {
    make.box({x, 0.15F, -0.215F}, {0.4F, 0.54F, 0.02F}, wood(kOak));
    make.box({x + (x < -0.5F || (x > 0.0F && x < 0.5F) ? 0.15F : -0.15F), 0.4F, -0.235F},
             {0.02F, 0.09F, 0.02F},
             plain(hex(0x2B2622)));
    make.box({1.25F * x, 0, -0.14F}, {0.045F, 0.12F, 0.045F}, wood(kWalnut));
  }
}

void addPicture(const Stand& place, const Vec2f& size, const Painter& picture, RoomBuilder* room) {
  constexpr float kDepth = 0.025F;
  const Look edge = lookOf(plain(hex(0x2A2521)));
  Look front = lookOf(picture);
  front.texels_per_m = 500.0F;
  room->addSlab(
      place.stand(0, 0, -0.5F * kDepth, 0), {size.x(), size.y(), kDepth}, {front, edge, edge});
}

}  // namespace glide::synthetic
