#pragma once

#include "ar/anchors.h"

#include "geometry/camera_model.h"

#include "glide/frame.h"
#include "glide/map_view.h"
#include "glide/types.h"

#include <cstdint>
#include <vector>

namespace glide::replay {

/// Cubes that set themselves down on what lies flat before the camera, as a person would place them
/// by tapping, and stay there: what shows at a glance whether poses are right.
class ArScene {
 public:
  explicit ArScene(const CameraModel& camera) : camera_(camera) {}

  /// The camera as the map has corrected it, for places from now on.
  void setCamera(const CameraModel& camera) { camera_ = camera; }

  /// Takes the cubes to where the map has their places now, and sets down another one when a new
  /// keyframe shows room for it. `map` is of the frame.
  void show(const FrameResult& frame, const MapView& map);

  /// T_world_cube of each: the centre of the bottom face, y down. Those of a map that is gone are
  /// left out.
  std::vector<Pose> cubes() const;
  /// Edge of a cube, scene units; zero before the first.
  double edge() const { return edge_; }

 private:
  void forgetGone();
  void placeOne(const FrameResult& frame, const MapView& map);
  bool isFree(const Vec3d& p_world) const;

  CameraModel camera_;
  Anchors anchors_;
  std::vector<std::uint64_t> ids_;
  double edge_ = 0.0;
};

}  // namespace glide::replay
