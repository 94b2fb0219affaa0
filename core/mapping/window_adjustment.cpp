#include "mapping/window_adjustment.h"

#include <algorithm>
#include <unordered_map>

namespace glide {
namespace {

template <class T>
void sortUnique(std::vector<T>* values) {
  std::sort(values->begin(), values->end());
  values->erase(std::unique(values->begin(), values->end()), values->end());
}

std::vector<KeyframeId> keyframesAround(const Map& map, KeyframeId id, std::size_t count) {
  std::vector<KeyframeId> result;
  if (map.keyframes().size() <= count) {
    for (const auto& entry : map.keyframes()) result.push_back(entry.first);
    return result;
  }
  result.push_back(id);
  for (const CovisibleKeyframe& neighbor : map.covisibility().neighbors(id, 1)) {
    if (result.size() >= count) break;
    result.push_back(neighbor.id);
  }
  return result;
}

// Keyframes that see the landmarks but do not move.
std::vector<KeyframeId> observersOf(const Map& map,
                                    const std::vector<LandmarkId>& landmarks,
                                    const std::vector<KeyframeId>& moving) {
  std::vector<KeyframeId> result;
  for (const LandmarkId id : landmarks) {
    for (const Observation& observation : map.landmark(id)->observations) {
      const KeyframeId keyframe = observation.keyframe;
      if (!std::binary_search(moving.begin(), moving.end(), keyframe)) result.push_back(keyframe);
    }
  }
  sortUnique(&result);
  return result;
}

// A window as the solver wants it, with the way back.
struct WindowProblem {
  BundleProblem bundle;
  std::vector<KeyframeId> keyframe_of_observation;
};

WindowProblem buildProblem(const Map& map, const AdjustmentWindow& window) {
  WindowProblem problem;
  for (const KeyframeId id : window.moving) {
    problem.bundle.cameras.push_back({map.keyframe(id)->T_cam_world, false});
  }
  for (const KeyframeId id : window.fixed) {
    problem.bundle.cameras.push_back({map.keyframe(id)->T_cam_world, true});
  }
  std::unordered_map<KeyframeId, int> camera_of;
  for (const KeyframeId id : window.moving)
    camera_of.emplace(id, static_cast<int>(camera_of.size()));
  for (const KeyframeId id : window.fixed)
    camera_of.emplace(id, static_cast<int>(camera_of.size()));
  for (const LandmarkId id : window.landmarks) {
    const Landmark& landmark = *map.landmark(id);
    const int point = static_cast<int>(problem.bundle.points.size());
    problem.bundle.points.push_back(landmark.p_world);
    for (const Observation& seen : landmark.observations) {
      const Keyframe& keyframe = *map.keyframe(seen.keyframe);
      const Feature& feature = keyframe.features->feature(static_cast<std::size_t>(seen.feature));
      BundleObservation& observation = problem.bundle.observations.emplace_back();
      observation.camera = camera_of.at(seen.keyframe);
      observation.point = point;
      observation.uv = feature.uv.cast<double>();
      observation.inv_sigma = inverseSigma(map.levels(), feature.level);
      problem.keyframe_of_observation.push_back(seen.keyframe);
    }
  }
  return problem;
}

double meanDistance(const BundleProblem& bundle, const Vec3d& from) {
  double sum = 0.0;
  for (const BundleProblem::Camera& camera : bundle.cameras) {
    sum += (camera.T_cam_world.inverse().t - from).norm();
  }
  return sum / static_cast<double>(bundle.cameras.size());
}

// Scales everything about the centre of the only fixed camera.
void rescale(BundleProblem* bundle, const Vec3d& about, double factor) {
  for (BundleProblem::Camera& camera : bundle->cameras) {
    const Vec3d center = about + factor * (camera.T_cam_world.inverse().t - about);
    camera.T_cam_world.t = -(camera.T_cam_world.q * center);
  }
  for (Vec3d& point : bundle->points) point = about + factor * (point - about);
}

BundleSummary solve(const CameraModel& camera,
                    const BundleOptions& options,
                    BundleProblem* bundle) {
  const auto is_fixed = [](const BundleProblem::Camera& c) { return c.fixed; };
  const auto& cameras = bundle->cameras;
  const auto fixed = std::find_if(cameras.begin(), cameras.end(), is_fixed);
  const bool is_scale_free = std::count_if(cameras.begin(), cameras.end(), is_fixed) == 1;
  if (!is_scale_free) return solveBundle(camera, options, bundle);
  const Vec3d anchor = fixed->T_cam_world.inverse().t;
  const double before = meanDistance(*bundle, anchor);
  const BundleSummary summary = solveBundle(camera, options, bundle);
  const double after = meanDistance(*bundle, anchor);
  if (summary.usable && before > 0.0 && after > 0.0) rescale(bundle, anchor, before / after);
  return summary;
}

void writeBack(const AdjustmentWindow& window, const BundleProblem& bundle, Map* map) {
  for (std::size_t i = 0; i < window.moving.size(); ++i) {
    map->setPose(window.moving[i], bundle.cameras[i].T_cam_world);
  }
  for (std::size_t i = 0; i < window.landmarks.size(); ++i) {
    map->setPosition(window.landmarks[i], bundle.points[i]);
  }
}

void removeOutliers(const AdjustmentWindow& window, const WindowProblem& problem, Map* map) {
  for (std::size_t i = 0; i < problem.bundle.observations.size(); ++i) {
    const BundleObservation& observation = problem.bundle.observations[i];
    if (observation.inlier) continue;
    map->removeObservation(window.landmarks[static_cast<std::size_t>(observation.point)],
                           problem.keyframe_of_observation[i]);
  }
}

}  // namespace

AdjustmentWindow windowAround(const Map& map, KeyframeId id, int max_keyframes) {
  AdjustmentWindow window;
  window.moving = keyframesAround(map, id, static_cast<std::size_t>(max_keyframes));
  sortUnique(&window.moving);
  for (const KeyframeId keyframe : window.moving) {
    for (const LandmarkId landmark : map.keyframe(keyframe)->landmarks) {
      if (landmark != kNoLandmark) window.landmarks.push_back(landmark);
    }
  }
  sortUnique(&window.landmarks);
  window.fixed = observersOf(map, window.landmarks, window.moving);
  const KeyframeId first = map.keyframes().begin()->first;
  if (window.moving.front() == first || window.fixed.empty()) {
    window.fixed.insert(window.fixed.begin(), window.moving.front());
    window.moving.erase(window.moving.begin());
    sortUnique(&window.fixed);
  }
  return window;
}

BundleProblem bundleOf(const Map& map, const AdjustmentWindow& window) {
  return buildProblem(map, window).bundle;
}

BundleSummary adjustWindow(MapperState* state,
                           const AdjustmentWindow& window,
                           const BundleOptions& options) {
  if (window.moving.empty() || window.landmarks.empty()) return {};
  WindowProblem problem = buildProblem(state->map, window);
  const BundleSummary summary = solve(state->camera, options, &problem.bundle);
  if (!summary.usable) return summary;
  writeBack(window, problem.bundle, &state->map);
  if (!summary.cancelled) removeOutliers(window, problem, &state->map);
  state->map.refreshChanged();
  for (const LandmarkId id : window.landmarks) state->map.refreshGeometry(id);
  return summary;
}

}  // namespace glide
