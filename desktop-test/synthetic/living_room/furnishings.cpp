#include "synthetic/living_room/furniture.h"

#include <algorithm>
#include <array>
#include <cmath>

// What stands on tables, plants and lamps. Sizes are in metres: what such things look like, nothing
// is derived from them.
namespace glide::synthetic {

namespace {

constexpr float kGoldenAngle = 2.39996323F;  // spreads leaves evenly around a stem

Look lookOf(const Painter& painter) { return {painter, kThingTexels}; }
Look finely(const Painter& painter) { return {painter, 600.0F}; }
Look shining(const Painter& painter, float glow) { return {painter, kThingTexels, glow}; }

void addMug(const Stand& stand, const Rgb& color, RoomBuilder* room) {
  room->addDrum(stand,
                {0.04F, 0.095F, 10},
                finely(ceramic(color, hex(0xF4EFE2))),
                finely(plain(hex(0x3A2417))));
}

}  // namespace

void addBookStack(const Stand& stand, int books, Random* random, RoomBuilder* room) {
  float up = 0.0F;
  for (int k = 0; k < books; ++k) {
    const float shrink = 1.0F - 0.06F * static_cast<float>(k);
    const Vec3f size(0.22F * shrink, random->uniform(0.022F, 0.04F), 0.16F * shrink);
    room->addBox(stand.stand(0, up, 0, random->uniform(-0.25F, 0.25F)),
                 size,
                 {finely(bookPages()), finely(bookPages()), finely(bookCover())});
    up += size.y();
  }
}

void addCoffeeTableThings(const Stand& top, Random* random, RoomBuilder* room) {
  addBookStack(top.stand(-0.33F, 0, 0.06F, 0.3F), 4, random, room);
  addMug(top.stand(-0.08F, 0, -0.17F, 0.0F), hex(0xB5452F), room);
  addMug(top.stand(0.36F, 0, 0.2F, 0.6F), hex(0x2F5F73), room);
  room->addBox(top.stand(0.16F, 0, -0.12F, -0.35F),
               {0.22F, 0.006F, 0.29F},
               {finely(bookPages()), finely(bookPages()), finely(magazine())});
  room->addBox(top.stand(0.38F, 0, -0.15F, 0.2F),
               {0.2F, 0.005F, 0.27F},
               {finely(bookPages()), finely(bookPages()), finely(magazine())});
  room->addDrum(top.stand(0.08F, 0, 0.15F, 0),
                {0.13F, 0.06F, 16},
                finely(ceramic(hex(0xE6DCC6), hex(0x2F6173))),
                finely(plain(hex(0x54402C))));
  const std::array fruit{hex(0xC23B2A), hex(0xD98A24), hex(0x9FB03A), hex(0xC8562B)};
  for (int k = 0; k < 4; ++k) {
    const float angle = 1.57F * static_cast<float>(k);
    room->addDrum(
        top.stand(0.08F + 0.06F * std::cos(angle), 0.03F, 0.15F + 0.06F * std::sin(angle), angle),
        {0.036F, 0.065F, 7},
        finely(plain(0.9F * fruit[static_cast<std::size_t>(k)])),
        finely(plain(1.1F * fruit[static_cast<std::size_t>(k)])));
  }
}

void addDeskThings(const Stand& top, RoomBuilder* room) {
  const Look dark = lookOf(plain(hex(0x26272A)));
  room->addBox(top.stand(0, 0, 0.16F, 0), {0.22F, 0.012F, 0.16F}, allAround(dark));
  room->addBox(top.stand(0, 0.01F, 0.17F, 0), {0.05F, 0.1F, 0.03F}, allAround(dark));
  Look screen = shining(pointCloudScreen(), 1.1F);
  screen.texels_per_m = 600.0F;
  room->addSlab(top.stand(0, 0.11F, 0.15F, 0), {0.62F, 0.37F, 0.035F}, allAround(dark));
  room->add(
      top.at(-0.3F, 0.47F, 0.13F), top.at(0.6F, 0, 0) - top.foot, 0.35F * Vec3f::UnitY(), screen);
  room->addBox(
      top.stand(-0.03F, 0, -0.14F, 0.03F), {0.43F, 0.02F, 0.14F}, {dark, dark, finely(keyboard())});
  room->addBox(
      top.stand(-0.47F, 0, -0.05F, 0.3F), {0.21F, 0.003F, 0.297F}, {dark, dark, finely(page())});
  room->addBox(
      top.stand(0.47F, 0, -0.1F, -0.2F), {0.21F, 0.004F, 0.297F}, {dark, dark, finely(page())});
  addMug(top.stand(0.34F, 0, 0.1F, 0), hex(0xD8A33A), room);
  room->addBox(top.stand(-0.52F, 0, 0.2F, 0.1F),
               {0.16F, 0.24F, 0.12F},
               {finely(bookSpines()), dark, finely(bookPages())});
}

void addHiFi(const Stand& top, RoomBuilder* room) {
  const Look box = lookOf(wood(kWalnut));
  room->addBox(top.stand(-0.05F, 0, 0, 0), {0.44F, 0.09F, 0.34F}, {box, box, finely(record())});
  for (const float side : {-0.62F, 0.62F})
    room->addBox(top.stand(side, 0, 0.02F, side < 0 ? -0.15F : 0.15F),
                 {0.2F, 0.34F, 0.2F},
                 {finely(loudspeaker()), box, box});
}

void addPlant(const Stand& stand, const PlantShape& shape, Random* random, RoomBuilder* room) {
  const float pot = std::clamp(0.3F * shape.height, 0.07F, 0.2F);
  room->addDrum(stand, {0.8F * pot, 1.3F * pot, 12}, lookOf(wicker(hex(0xC49A62))), lookOf(soil()));
  const Vec3f root = stand.at(0, 1.3F * pot, 0), tip = stand.at(0, 1.3F * pot + shape.height, 0);
  if (shape.height > 0.3F) room->addBar(root, tip, 0.018F, lookOf(wood(kWalnut)));
  const std::array greens{hex(0x2E6B3A), hex(0x3F8045), hex(0x5A9150), hex(0x276048)};
  for (int k = 0; k < shape.leaves; ++k) {
    const float share = (static_cast<float>(k) + 0.5F) / static_cast<float>(shape.leaves);
    const float azimuth = kGoldenAngle * static_cast<float>(k);
    const float rise = 0.1F + 1.1F * share + random->uniform(-0.2F, 0.2F);
    const Vec3f out(std::cos(azimuth), 0.0F, std::sin(azimuth));
    const Vec3f along = std::cos(rise) * out - std::sin(rise) * Vec3f::UnitY();
    const Vec3f across = Vec3f::UnitY().cross(out).normalized();
    const float length = shape.leaf_length * random->uniform(0.75F, 1.2F);
    const Vec3f stalk = root + (0.25F + 0.75F * share) * (tip - root) + 0.03F * along;
    room->addLeaf(stalk,
                  length * along,
                  0.36F * length * across,
                  lookOf(leaf(greens[static_cast<std::size_t>(random->below(4))])));
  }
}

Bulb addFloorLamp(const Stand& stand, RoomBuilder* room) {
  constexpr float kPole = 1.45F, kShade = 0.3F;
  const Look metal = lookOf(plain(hex(0x2B2B2D)));
  room->addDrum(stand, {0.14F, 0.025F, 16}, metal, metal);
  room->addBar(stand.at(0, 0.02F, 0), stand.at(0, kPole, 0), 0.025F, metal);
  const Look shade = shining(lampshade(hex(0xFFDFA6)), 1.5F);
  room->addDrum(stand.stand(0, kPole - 0.05F, 0, 0), {0.21F, kShade, 20}, shade, shade);
  return {stand.at(0, kPole + 0.1F, 0), 0.16F, 1.1F * Vec3f(1.0F, 0.72F, 0.42F)};
}

Bulb addPendantLamp(const Vec3f& ceiling_point, float drop, RoomBuilder* room) {
  constexpr float kRadius = 0.2F, kHeight = 0.18F;
  const Stand lamp{ceiling_point + drop * Vec3f::UnitY()};
  room->addBar(ceiling_point, lamp.at(0, kHeight, 0), 0.012F, lookOf(plain(hex(0x222222))));
  const Look shade = shining(lampshade(hex(0xFFE9C4)), 1.4F);
  room->addDrum(lamp, {kRadius, kHeight, 20}, shade, lookOf(plain(hex(0x2B2B2D))));
  return {lamp.at(0, 0.05F, 0), 0.14F, 0.8F * Vec3f(1.0F, 0.78F, 0.5F)};
}

}  // namespace glide::synthetic
