#pragma once

#include "support/synthetic_map.h"
#include "support/synthetic_problem.h"

#include "mapping/initial_map.h"
#include "mapping/insertion.h"
#include "mapping/mapper_state.h"

#include "map/snapshot_builder.h"

#include <cmath>
#include <memory>
#include <vector>

namespace glide::test {

/// Camera `step` of a wavy walk along +x that looks along +z, 0.25 units per step.
inline SE3d walk(double step) {
  const double s = 0.25 * step;
  const Vec3d center(s, 0.1 * std::sin(1.3 * s), 0.2 * std::sin(s));
  return lookAlong(center, 0.1 * std::sin(0.5 * s));
}

/// Small enough for tests under sanitizers: some 300 features per view.
inline SyntheticCloudOptions smallCloud() {
  SyntheticCloudOptions options;
  options.points = 1200;
  return options;
}

/// A mapper's state over a synthetic cloud, step by step: the tests call the steps they are about.
class MappedScene {
 public:
  MappedScene(const SyntheticCloudOptions& cloud_options,
              const SyntheticTracker::Options& tracker_options)
      : cloud(syntheticCamera(DistortionModel::radial_tangential), cloud_options),
        tracker(&cloud, tracker_options),
        state(Config{}, cloud.camera()) {}

  /// Starts the map at steps 0 and 1 of the walk.
  void start() { startMap(&state, tracker.start(&cloud, walk(0), walk(1), 2.0)); }

  /// Inserts a keyframe without extending the map.
  KeyframeId insert(const SE3d& T_cam_world) {
    const NewKeyframe message = tracker.track(*map(), cloud.look(T_cam_world), newest());
    insertKeyframe(&state, message);
    return message.id;
  }

  std::shared_ptr<const MapSnapshot> map() const { return snapshotOf(state.map, {1, 1, 0, 15}); }
  KeyframeId newest() const { return state.map.keyframes().rbegin()->first; }
  double keyframeError() const { return tracker.keyframeError(*map()); }
  double landmarkError() const { return tracker.landmarkError(*map()); }

  SyntheticCloud cloud;
  SyntheticTracker tracker;
  MapperState state;
};

}  // namespace glide::test
