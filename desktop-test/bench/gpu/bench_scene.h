#pragma once

#include "bench/gpu/command_line.h"
#include "bench/gpu/traffic.h"

#include "photometric/align_types.h"

#include "geometry/camera_model.h"
#include "image/image.h"

#include <vector>

namespace glide::gpubench {

/// EuRoC's cam0 at its 752 px, the focal length and the centre scaled.
CameraModel benchCamera(int width, int height);

/// What every plan is given: a reference with its points, and frames at growing distance from it,
/// the last one further than the direct tracker accepts a guess to be off.
struct BenchScene {
  CameraModel camera;
  ImageU8 reference;
  std::vector<ImageU8> frames;
  std::vector<AlignPoint> points_ref;
};

/// For each level of the pyramid the points whose patch, with a pixel around it, lies in it.
PerLevel pointsOfLevels(const BenchScene& scene, const Workload& workload);

/// A wall with panels through EuRoC's lens, scaled to the image; seeded.
BenchScene makeBenchScene(const Workload& workload);

}  // namespace glide::gpubench
