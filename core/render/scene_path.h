#pragma once

#include "render/scene_array.h"
#include "render/scene_records.h"

#include "geometry/lie.h"

#include "glide/frame.h"
#include "glide/map_view.h"

#include <cstdint>
#include <vector>

namespace glide {

/// What is drawn of a camera.
PoseRecord poseRecord(const SE3d& T_world_cam, const PackedColor& color);

/// The camera's way through one map (MapView::generation), frame by frame. Each frame hangs at a
/// keyframe and goes where the map moves that to.
class ScenePath {
 public:
  /// A frame that was tracked. One that was not interrupts the way; one of another map begins it
  /// anew.
  void append(const FrameResult& frame, const MapView& map);
  /// Moves all frames to where `map` has their keyframes now. Another map than theirs begins the
  /// way anew.
  void place(const MapView& map);

  /// One for each tracked frame, in their order.
  SceneArray<PoseRecord>& records() { return records_; }
  const SceneArray<PoseRecord>& records() const { return records_; }

 private:
  struct Frame {
    std::uint64_t keyframe = 0;
    double reference_scale = 1.0;
    SE3d T_ref_cam;
    SE3d T_world_cam;  ///< as tracked: serves until the map has the keyframe
    PackedColor color{};
  };
  void beginIn(std::uint64_t generation);
  PoseRecord placed(const Frame& frame, const MapView& map) const;

  std::uint64_t generation_ = 0;  ///< of the frames
  std::vector<Frame> frames_;
  SceneArray<PoseRecord> records_;
  bool is_interrupted_ = true;  ///< no line leads to the first frame
};

}  // namespace glide
