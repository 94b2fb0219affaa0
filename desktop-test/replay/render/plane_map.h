#pragma once

#include "geometry/camera_model.h"
#include "geometry/lie.h"
#include "geometry/pose_conversion.h"

#include "glide/frame.h"
#include "glide/map_view.h"

#include <cstdint>
#include <random>

namespace glide::replay {

/// The camera that sees planeMap().
inline CameraIntrinsics planeCamera() {
  CameraIntrinsics intrinsics;
  intrinsics.width = 640;
  intrinsics.height = 480;
  intrinsics.fx = intrinsics.fy = 500.0;
  intrinsics.cx = 319.5;
  intrinsics.cy = 239.5;
  return intrinsics;
}

/// Landmarks 2 m before the first camera, on a plane through (0, 1.5, 2) with this normal.
inline MapView planeMap(const Vec3d& normal) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> around(-2.0, 2.0);
  const Eigen::Quaterniond turn = Eigen::Quaterniond::FromTwoVectors(-Vec3d::UnitY(), normal);
  MapView map;
  map.generation = 1;
  map.revision = 1;
  MapView::Keyframe keyframe;
  keyframe.id = 1;
  map.keyframes.push_back(keyframe);
  for (std::uint64_t id = 0; id < 900; ++id) {
    const Vec3d p = Vec3d(0.0, 1.5, 2.5) + turn * Vec3d(around(random), 0.0, around(random));
    map.landmarks.push_back({id, {p.x(), p.y(), p.z()}, 3});
  }
  return map;
}

/// A keyframe of a camera that looks 34 degrees down.
inline FrameResult planeKeyframe() {
  FrameResult frame;
  frame.state = TrackingState::tracking;
  frame.stats.keyframe = true;
  frame.T_world_cam = toPose({so3Exp(Vec3d(-0.6, 0.0, 0.0)), Vec3d::Zero()});
  return frame;
}

}  // namespace glide::replay
