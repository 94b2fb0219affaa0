#pragma once

namespace glide::replay {

/// What a picture of a replay shows.
enum class RenderView {
  split,  ///< the camera's view beside the map
  map,    ///< the map in 3-D alone
  ar,     ///< the camera's picture with the world's axes and cubes that stand in it
};

}  // namespace glide::replay
