#include "support/room_map.h"

#include <array>
#include <cmath>
#include <cstdlib>
#include <random>

namespace glide::test {
namespace {

using Point = std::array<double, 3>;

// The walk: a circle around (0, 0, kRadius), from the world's origin.
constexpr double kRadius = 1.4;
constexpr double kTurn = 6.283185307179586;
constexpr double kSwing = 0.12;  ///< up and down, scene units
// The room: y points down.
constexpr double kHalfWidth = 2.6, kFloor = 1.0, kCeiling = -1.2;
constexpr double kTableRadius = 0.45, kTableTop = 0.35;
constexpr double kTruthScale = 1.03;
constexpr int kNeighbors = 4;

/// Numbers that are the same with every standard library.
class Dice {
 public:
  double between(double low, double high) {
    return low + (high - low) * static_cast<double>(engine_() % kSteps) / (kSteps - 1);
  }
  int below(int count) { return static_cast<int>(engine_() % static_cast<std::uint32_t>(count)); }

 private:
  static constexpr std::uint32_t kSteps = 65536;
  std::mt19937 engine_{17};
};

Pose cameraAt(double share) {
  const double angle = kTurn * share;
  const double half = -0.5 * angle;  // looks at the table
  return {{kRadius * std::sin(angle),
           kSwing * std::sin(3.0 * angle),
           kRadius * (1.0 - std::cos(angle))},
          {0.0, std::sin(half), 0.0, std::cos(half)}};
}

Point onWall(Dice* dice) {
  const double along = dice->between(-kHalfWidth, kHalfWidth);
  // Pictures and shelves: not every height.
  const double y = dice->between(kCeiling, kFloor - 0.3) + 0.2 * std::floor(2.0 * along);
  const std::array<Point, 4> walls{{{along, y, kRadius + kHalfWidth},
                                    {along, y, kRadius - kHalfWidth},
                                    {kHalfWidth, y, kRadius + along},
                                    {-kHalfWidth, y, kRadius + along}}};
  return walls[static_cast<std::size_t>(dice->below(4))];
}

Point onTable(Dice* dice) {
  const double angle = dice->between(0.0, kTurn);
  const bool is_top = dice->below(2) == 0;
  const double radius = is_top ? kTableRadius * std::sqrt(dice->between(0.0, 1.0)) : kTableRadius;
  const double y = is_top ? kTableTop : dice->between(kTableTop, kFloor);
  return {radius * std::sin(angle), y, kRadius + radius * std::cos(angle)};
}

Point onFloor(Dice* dice) {
  return {dice->between(-kHalfWidth, kHalfWidth),
          kFloor,
          kRadius + dice->between(-kHalfWidth, kHalfWidth)};
}

Point somewhere(Dice* dice) {
  const int place = dice->below(10);
  if (place < 5) return onWall(dice);
  return place < 8 ? onTable(dice) : onFloor(dice);
}

MapView::Keyframe keyframe(int index, int count) {
  MapView::Keyframe made;
  made.id = static_cast<std::uint64_t>(index);
  made.T_world_cam = cameraAt(static_cast<double>(index) / count);
  for (int step = 1; step <= kNeighbors; ++step) {
    if (index - step >= 0) made.covisible.push_back(static_cast<std::uint64_t>(index - step));
    if (index + step < count) made.covisible.push_back(static_cast<std::uint64_t>(index + step));
  }
  return made;
}

/// Relative to the keyframe before: a turn of the circle between them, about a vertical axis.
FrameResult frame(int index, const RoomMapSize& size) {
  const double share = static_cast<double>(index) / size.frames;
  const auto reference = static_cast<int>(share * size.keyframes);
  FrameResult result;
  result.t_ns = index;
  result.state = TrackingState::tracking;
  const bool is_keyframe = index * size.keyframes % size.frames < size.keyframes;
  const bool is_indirect = is_keyframe || 4 * index >= 3 * size.frames;
  result.tracker = is_indirect ? TrackerKind::indirect : TrackerKind::direct;
  result.T_world_cam = cameraAt(share);
  result.reference_keyframe = static_cast<std::uint64_t>(reference);
  const Pose T_world_ref = cameraAt(static_cast<double>(reference) / size.keyframes);
  const double turn = kTurn * (share - static_cast<double>(reference) / size.keyframes);
  result.T_ref_cam.q_xyzw = {0.0, std::sin(-0.5 * turn), 0.0, std::cos(0.5 * turn)};
  const auto& to = result.T_world_cam.t_xyz;
  const auto& from = T_world_ref.t_xyz;
  const double angle = kTurn * static_cast<double>(reference) / size.keyframes;
  const double dx = to[0] - from[0];
  const double dz = to[2] - from[2];
  result.T_ref_cam.t_xyz = {std::cos(angle) * dx + std::sin(angle) * dz,
                            to[1] - from[1],
                            -std::sin(angle) * dx + std::cos(angle) * dz};
  return result;
}

Pose truthAt(double share) {
  Pose pose = cameraAt(share);
  for (double& value : pose.t_xyz) value *= kTruthScale;
  return pose;
}

}  // namespace

RoomMap makeRoomMap(const RoomMapSize& size) {
  Dice dice;
  auto map = std::make_shared<MapView>();
  map->revision = 1;
  for (int i = 0; i < size.keyframes; ++i) map->keyframes.push_back(keyframe(i, size.keyframes));
  for (int i = 0; i < size.landmarks; ++i) {
    const Point p_world = somewhere(&dice);
    map->landmarks.push_back({static_cast<std::uint64_t>(i), p_world, 2 + dice.below(14)});
  }
  map->loops.push_back({static_cast<std::uint64_t>(size.keyframes - 1), 0});
  RoomMap room{map, {}, {}};
  for (int i = 0; i < size.frames; ++i) {
    room.frames.push_back(frame(i, size));
    room.truth.push_back(truthAt(static_cast<double>(i) / size.frames));
  }
  return room;
}

}  // namespace glide::test
