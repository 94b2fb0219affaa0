#pragma once

#include "replay/outputs/run_record.h"
#include "replay/readers/frame_source.h"

#include "geometry/lie.h"

#include <vector>

namespace glide::replay {

/// Camera poses on a loop around the middle of a room, T_world_cam; the first is the world.
std::vector<SE3d> sampleTourPoses(int count);

/// Landmarks on floor, walls and a block in the middle, in the same world.
std::vector<MapView::Landmark> sampleRoom();

/// A colour picture with the landmarks as dots, and where they are in it.
struct SampleView {
  SourceFrame frame;
  std::vector<TrackedPoint> points;
};

/// What a camera there sees.
SampleView sampleView(const std::vector<MapView::Landmark>& landmarks, const SE3d& T_world_cam);

/// The camera of the pictures.
CameraIntrinsics sampleCamera();

}  // namespace glide::replay
