#pragma once

#include "glide/frame.h"
#include "glide/map_view.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace glide::test {

/// How much of a room there is.
struct RoomMapSize {
  int landmarks = 3000;
  int keyframes = 24;
  int frames = 240;
};

/// The map of a room as a session could have made it, to be drawn: a camera has walked once around
/// a table in the middle and closed the loop. Tween frames were tracked directly, keyframes and the
/// last quarter of the way indirectly. The same on every machine.
struct RoomMap {
  std::shared_ptr<const MapView> map;
  std::vector<FrameResult> frames;
  std::vector<Pose> truth;  ///< T_world_cam of the frames, a little beside them
};
RoomMap makeRoomMap(const RoomMapSize& size);

}  // namespace glide::test
