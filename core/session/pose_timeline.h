#pragma once

#include "track/anchored_pose.h"

#include "glide/frame.h"

#include <cstdint>
#include <vector>

namespace glide {

/// The poses of the last frames in one map, immutable: answers where the camera was, or soon will
/// be. A value that update() makes anew for each frame and any thread may read.
class PoseTimeline {
 public:
  /// `generation` is the map's, MapSnapshot::generation().
  explicit PoseTimeline(std::uint64_t generation) : generation_(generation) {}
  std::uint64_t generation() const { return generation_; }

  struct Entry {
    std::int64_t t_ns = 0;
    bool tracked = false;
    AnchoredPose pose;  ///< the last known one when not tracked
  };

  /// This timeline and one more frame, the oldest dropped when there are many. `t_ns` ascends.
  PoseTimeline with(const Entry& entry) const;

  /// Interpolated between two frames, extrapolated with constant velocity after the last (a little:
  /// see kMaxExtrapolation_ns); before the first, far in the future or while lost not valid. `map`
  /// is of this generation, or empty.
  LocatedCamera at(std::int64_t t_ns, const MapSnapshot& map) const;

  /// Farther into the future a hand-held camera is anywhere: 100 ms.
  static constexpr std::int64_t kMaxExtrapolation_ns = 100'000'000;

 private:
  std::uint64_t generation_;
  std::vector<Entry> entries_;  ///< ascending time
};

}  // namespace glide
