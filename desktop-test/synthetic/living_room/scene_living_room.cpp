#include "synthetic/living_room/furniture.h"
#include "synthetic/scene_builder.h"

#include <array>

// A living room about the origin: x right, y down, z forward, metres; the camera goes around the
// middle and looks inwards. Places and sizes are those of a room that one could live in.
namespace glide::synthetic {

namespace {

constexpr float kHalfX = 2.6F, kHalfZ = 2.3F;
constexpr float kFloor = 1.3F, kCeiling = -1.3F;  // y
constexpr float kHeight = kFloor - kCeiling;
constexpr float kQuarter = 1.57079633F;                    // radians
constexpr float kRoomTexels = 320.0F, kSkyTexels = 60.0F;  // per metre

// Walls by what one sees when the world's z points forward; foot and front of each.
const Stand kFront{{0, kFloor, kHalfZ}, 0.0F};
const Stand kBack{{0, kFloor, -kHalfZ}, 2.0F * kQuarter};
const Stand kRight{{kHalfX, kFloor, 0}, kQuarter};
const Stand kLeft{{-kHalfX, kFloor, 0}, -kQuarter};

const Rgb kWallPaint = hex(0xE9DFCB), kWhitePaint = hex(0xF1ECE2);

/// A part of a wall: its lower left corner as seen from the room.
struct Panel {
  float left, bottom, width, height;
};

void addPanel(const Stand& wall, const Panel& panel, const Painter& painter, RoomBuilder* room) {
  room->add(wall.at(panel.left, panel.bottom + panel.height, 0),
            wall.at(panel.width, 0, 0) - wall.foot,
            panel.height * Vec3f::UnitY(),
            {painter, kRoomTexels});
}

void addSkirting(const Stand& wall, float half_length, RoomBuilder* room) {
  constexpr float kDepth = 0.018F;
  const Look look{plain(kWhitePaint), kRoomTexels};
  room->addBox(
      wall.stand(0, 0, -0.5F * kDepth, 0), {2.0F * half_length, 0.09F, kDepth}, allAround(look));
}

// The window in the left wall.
constexpr Panel kWindow{-0.55F, 0.85F, 1.9F, 1.35F};
constexpr float kReveal = 0.2F;  // depth of the opening

void addShell(RoomBuilder* room) {
  const Painter plastered = plaster(kWallPaint);
  addPanel(
      kFront, {-kHalfX, 0, 2 * kHalfX, kHeight}, wallpaper(hex(0x9DB3A4), hex(0x5E7F70)), room);
  addPanel(kBack, {-kHalfX, 0, 2 * kHalfX, kHeight}, paintedBricks(hex(0xEBE4D8)), room);
  addPanel(kRight, {-kHalfZ, 0, 2 * kHalfZ, kHeight}, plastered, room);
  const float top = kWindow.bottom + kWindow.height, right = kWindow.left + kWindow.width;
  addPanel(kLeft, {-kHalfZ, 0, 2 * kHalfZ, kWindow.bottom}, plastered, room);
  addPanel(kLeft, {-kHalfZ, top, 2 * kHalfZ, kHeight - top}, plastered, room);
  addPanel(
      kLeft, {-kHalfZ, kWindow.bottom, kWindow.left + kHalfZ, kWindow.height}, plastered, room);
  addPanel(kLeft, {right, kWindow.bottom, kHalfZ - right, kWindow.height}, plastered, room);
  const Vec3f x = 2 * kHalfX * Vec3f::UnitX(), z = 2 * kHalfZ * Vec3f::UnitZ();
  room->add({-kHalfX, kFloor, kHalfZ}, x, -z, {planks(kOak), kRoomTexels});
  room->add({-kHalfX, kCeiling, -kHalfZ}, x, z, {plaster(kWhitePaint), 0.5F * kRoomTexels});
  for (const auto& [wall, half] : {std::pair(kFront, kHalfX),
                                   std::pair(kBack, kHalfX),
                                   std::pair(kRight, kHalfZ),
                                   std::pair(kLeft, kHalfZ)})
    addSkirting(wall, half, room);
  for (const float beam : {-1.5F, 0.0F, 1.5F}) {
    room->addSlab({{0, kCeiling + 0.16F, beam}},
                  {2 * kHalfX, 0.16F, 0.14F},
                  allAround({wood(kOak), kRoomTexels}));
  }
}

/// Sill, reveal, frame and bars.
void addWindowFrame(RoomBuilder* room) {
  const Look white{plain(kWhitePaint), kRoomTexels};
  const float middle = kWindow.left + 0.5F * kWindow.width;
  const Stand window = kLeft.stand(middle, kWindow.bottom, 0, 0);
  const float w = kWindow.width, h = kWindow.height;
  const Vec3f inwards = window.at(0, 0, kReveal) - window.foot;
  room->add(window.at(-0.5F * w, h, 0), inwards, h * Vec3f::UnitY(), white);
  room->add(window.at(0.5F * w, h, kReveal), -inwards, h * Vec3f::UnitY(), white);
  const Vec3f along = window.at(w, 0, 0) - window.foot;
  room->add(window.at(-0.5F * w, h, 0), along, inwards, white);
  room->add(window.at(-0.5F * w, 0, kReveal), along, -inwards, white);
  room->addSlab(window.stand(0, -0.04F, 0.02F, 0),
                {w + 0.1F, 0.04F, 0.3F},
                allAround({wood(kBirch), kThingTexels}));
  constexpr float kBar = 0.06F;
  for (const float x : {-0.5F * (w - kBar), -0.16F * w, 0.16F * w, 0.5F * (w - kBar)})
    room->addSlab(window.stand(x, 0, 0.15F, 0), {kBar, h, kBar}, allAround(white));
  for (const float y : {0.0F, 0.62F * h, h - kBar})
    room->addSlab(window.stand(0, y, 0.15F, 0), {w, kBar, kBar}, allAround(white));
}

/// Cloth in folds to both sides of the window, on a rod.
void addCurtains(RoomBuilder* room) {
  constexpr float kFold = 0.075F, kLength = 2.25F;
  constexpr int kFolds = 7;
  const float middle = kWindow.left + 0.5F * kWindow.width;
  const Stand rod = kLeft.stand(middle, kLength + 0.05F, -0.1F, 0);
  const float half = 0.5F * kWindow.width;
  room->addBar(rod.at(-half - 0.5F, 0.02F, 0),
               rod.at(half + 0.5F, 0.02F, 0),
               0.03F,
               {wood(kBlackened), kThingTexels});
  const Look cloth{curtain(hex(0xD8C3A0), hex(0x9A4B36)), kRoomTexels};
  for (const float side : {-1.0F, 1.0F}) {
    for (int k = 0; k < kFolds; ++k) {
      const float x = side * (half + 0.02F) +
                      (side < 0 ? -1.0F : 1.0F) * 0.06F * static_cast<float>(k) +
                      (side < 0 ? -0.06F : 0.0F);
      const float z0 = k % 2 == 0 ? 0.5F * kFold : -0.5F * kFold;
      const Vec3f fold = rod.at(0.06F, 0, -2.0F * z0) - rod.foot;
      room->add(rod.at(x, 0, z0), fold, kLength * Vec3f::UnitY(), cloth);
      room->add(rod.at(x, 0, z0) + fold, -fold, kLength * Vec3f::UnitY(), cloth);
    }
  }
}

RoomLight addWindow(RoomBuilder* room) {
  addWindowFrame(room);
  addCurtains(room);
  room->addBox(kLeft.stand(kWindow.left + 0.5F * kWindow.width, 0.14F, -0.06F, 0),
               {1.5F, 0.6F, 0.1F},
               allAround({radiator(), kThingTexels}));
  Look garden{gardenView(), kSkyTexels};
  garden.glow = 1.9F;
  room->add({-kHalfX - 6.0F, -4.6F, -9.0F}, 18.0F * Vec3f::UnitZ(), 7.5F * Vec3f::UnitY(), garden);
  RoomLight light;
  light.to_sun = Vec3f(-0.78F, -0.52F, 0.22F).normalized();
  light.sun = 7.0F * Vec3f(1.0F, 0.88F, 0.68F);
  const Stand corner = kLeft.stand(kWindow.left, kWindow.bottom, 0.1F, 0);
  light.openings.push_back({corner.foot,
                            corner.at(kWindow.width, 0, 0) - corner.foot,
                            -kWindow.height * Vec3f::UnitY(),
                            2.6F * Vec3f(0.92F, 1.0F, 1.12F)});
  return light;
}

void furnishFront(Random* random, RoomBuilder* room) {
  addSofa(kFront.stand(-0.1F, 0, -0.47F, 0), room);
  addPicture(kFront.stand(-1.0F, 1.12F, 0, 0), {0.5F, 0.62F}, botanical(hex(0x2A2521)), room);
  addPicture(kFront.stand(-0.2F, 1.1F, 0, 0), {0.92F, 0.66F}, mountains(hex(0x9A6B3A)), room);
  addPicture(kFront.stand(0.62F, 1.42F, 0, 0), {0.52F, 0.4F}, abstractForms(hex(0xF4F0E6)), room);
  addPicture(kFront.stand(0.62F, 1.06F, 0, 0), {0.44F, 0.31F}, cityAtNight(hex(0x2A2521)), room);
  addPicture(kFront.stand(1.12F, 1.14F, 0, 0), {0.36F, 0.5F}, stillLife(hex(0x6B4A2C)), room);
  const Stand side_table = kFront.stand(-1.65F, 0, -0.4F, 0.1F);
  addTable(side_table, {0.5F, 0.5F, 0.45F}, kWalnut, room);
  addPlant(side_table.stand(0.05F, 0.5F, 0.05F, 0), {0.22F, 22, 0.24F}, random, room);
  addBookStack(side_table.stand(-0.1F, 0.5F, -0.12F, 0.4F), 2, random, room);
}

void furnishRight(Random* random, RoomBuilder* room) {
  addBookcase(kRight.stand(0.78F, 0, -0.17F, 0), {1.15F, 2.15F, 0.32F}, random, room);
  addBookcase(kRight.stand(-0.39F, 0, -0.17F, 0), {1.15F, 1.8F, 0.32F}, random, room);
  addPlant(kRight.stand(1.78F, 0, -0.3F, 0), {0.95F, 42, 0.4F}, random, room);
  addPlant(kRight.stand(-0.6F, 1.8F, -0.17F, 0), {0.2F, 18, 0.22F}, random, room);
  addArmchair({{1.85F, kFloor, 1.35F}, 0.94F}, room);
}

void furnishBack(RoomBuilder* room) {
  const Stand desk = kBack.stand(-1.25F, 0, -0.36F, 0);
  addTable(desk, {1.45F, 0.74F, 0.66F}, kBirch, room);
  addDeskThings(desk.stand(0, 0.74F, 0, 0), room);
  addChair(desk.stand(0.1F, 0, -0.42F, 2.7F), room);
  addPicture(kBack.stand(-1.3F, 1.4F, 0, 0), {1.0F, 0.62F}, corkBoard(), room);
  const Stand sideboard = kBack.stand(0.35F, 0, -0.23F, 0);
  addSideboard(sideboard, room);
  addHiFi(sideboard.stand(0, 0.75F, 0, 0), room);
  addPicture(kBack.stand(0.1F, 1.22F, 0, 0), {0.86F, 0.64F}, abstractForms(hex(0x6B4A2C)), room);
  addPicture(kBack.stand(0.85F, 1.3F, 0, 0), {0.42F, 0.52F}, mountains(hex(0x2A2521)), room);
  Look clock{clockFace(), 600.0F};
  clock.is_round = true;
  room->add(kBack.at(-0.62F, 1.9F, -0.02F),
            kBack.at(0.34F, 0, 0) - kBack.foot,
            0.34F * Vec3f::UnitY(),
            clock);
  room->addSlab(kBack.stand(1.9F, 0, -0.02F, 0),
                {1.0F, 2.1F, 0.04F},
                allAround({plain(kWhitePaint), kRoomTexels}));
  const Look door{panelDoor(hex(0x7E9AA0)), kRoomTexels};
  room->addSlab(kBack.stand(1.9F, 0, -0.04F, 0), {0.86F, 2.02F, 0.04F}, allAround(door));
}

void furnishLeft(Random* random, RoomBuilder* room) {
  const Stand sill = kLeft.stand(kWindow.left, kWindow.bottom, 0.0F, 0);
  addPlant(sill.stand(0.3F, 0, 0.03F, 0), {0.16F, 16, 0.15F}, random, room);
  addPlant(sill.stand(1.6F, 0, 0.03F, 0), {0.2F, 18, 0.17F}, random, room);
  addPicture(kLeft.stand(-1.65F, 1.2F, 0, 0), {0.5F, 0.64F}, cityAtNight(hex(0xC49A63)), room);
  addBookcase(kLeft.stand(-1.65F, 0, -0.15F, 0), {0.9F, 0.8F, 0.28F}, random, room);
}

void furnishMiddle(Random* random, RoomBuilder* room) {
  room->addBox({{0.05F, kFloor, 0.1F}, 0.06F},
               {2.5F, 0.012F, 1.75F},
               {{plain(hex(0x5B2333)), kThingTexels},
                {plain(hex(0x5B2333)), kThingTexels},
                {rug(), kThingTexels}});
  const Stand table{{0.0F, kFloor, 0.15F}, 0.25F};
  addTable(table, {1.1F, 0.42F, 0.62F}, kOak, room);
  addCoffeeTableThings(table.stand(0, 0.42F, 0, 0), random, room);
}

}  // namespace

Scene makeLivingRoom(std::uint64_t seed) {
  Random random(mixBits(seed));
  RoomBuilder room;
  addShell(&room);
  RoomLight light = addWindow(&room);
  furnishFront(&random, &room);
  furnishRight(&random, &room);
  furnishBack(&room);
  furnishLeft(&random, &room);
  furnishMiddle(&random, &room);
  light.bulbs.push_back(addFloorLamp(kFront.stand(2.2F, 0, -0.35F, 0), &room));
  light.bulbs.push_back(addPendantLamp({0.0F, kCeiling, 0.15F}, 0.85F, &room));
  Scene scene = room.finish(light, seed);
  // Looking a little down: what is near is seen as well as what is far.
  scene.viewpoint.eye = {0.0, -0.04, -1.3};
  scene.viewpoint.target = {0.0, 0.36, 0.1};
  scene.viewpoint.depth = 2.0;
  scene.viewpoint.orbit_center = {0.0, 0.36, 0.1};
  scene.viewpoint.orbit_radius = 1.35;
  scene.viewpoint.orbit_rise = 0.3;
  return scene;
}

}  // namespace glide::synthetic
