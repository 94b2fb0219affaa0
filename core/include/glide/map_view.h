#pragma once

#include "glide/types.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace glide {

/// A value copy of the map at one revision, for viewers and files.
struct MapView {
  struct Keyframe {
    std::uint64_t id = 0;
    std::int64_t t_ns = 0;
    Pose T_world_cam;
    bool retired = false;  ///< Culled from the map; kept so that poses relative to it stay defined.
    /// How much lengths in its camera frame have grown by corrections since it was made.
    double scale = 1.0;
    std::vector<std::uint64_t> covisible;  ///< ids of keyframes that share landmarks, best first
  };
  struct Landmark {
    std::uint64_t id = 0;
    std::array<double, 3> p_world{};
    int observations = 0;
  };
  /// A place that was recognised: these two keyframes see the same landmarks.
  struct Loop {
    std::uint64_t newer = 0, older = 0;  ///< ids of keyframes
  };
  std::uint64_t revision = 0;  ///< 0: nothing was mapped yet
  /// Grows when another map takes this one's place (reset, given up, loaded): ids and coordinates
  /// begin to mean something else.
  std::uint64_t generation = 0;
  std::uint64_t resets = 0;         ///< How often the map was started over.
  std::vector<Keyframe> keyframes;  ///< by ascending id
  std::vector<Landmark> landmarks;  ///< by ascending id
  std::vector<Loop> loops;          ///< in the order of closing
  /// The camera as the map has corrected it (Config::Calibration); none while it is as given. The
  /// poses are of this camera: draw with it.
  std::optional<CameraIntrinsics> corrected_camera;

  /// The keyframe with this id, retired or not; null when there is none.
  const Keyframe* keyframe(std::uint64_t id) const {
    const auto found = std::lower_bound(
        keyframes.begin(), keyframes.end(), id, [](const Keyframe& keyframe, std::uint64_t wanted) {
          return keyframe.id < wanted;
        });
    return found != keyframes.end() && found->id == id ? &*found : nullptr;
  }
};

/// What a map consists of, counted; retired keyframes are not.
struct MapSize {
  std::size_t keyframes = 0, landmarks = 0, loops = 0;
};

}  // namespace glide
