#include "mapping/initial_map.h"

#include "mapping/new_landmarks.h"
#include "mapping/window_adjustment.h"

namespace glide {
namespace {

// The two-view solution is further from the optimum than a tracked keyframe; this runs once.
constexpr int kIterations = 30;
constexpr int kRounds = 3;
constexpr double kMinSurvivingShare = 0.5;

Keyframe toKeyframe(const InitialMap::View& view) {
  Keyframe keyframe;
  keyframe.id = view.id;
  keyframe.t_ns = view.t_ns;
  keyframe.T_cam_world = view.T_cam_world;
  keyframe.features = view.features;
  return keyframe;
}

void insertPair(const InitialMap& message, Map* map) {
  map->addKeyframe(toKeyframe(message.a));
  map->addKeyframe(toKeyframe(message.b));
  for (const InitialMap::Point& point : message.points) {
    const LandmarkId id = map->addLandmark(point.p_world, message.a.id);
    const bool in_a = map->addObservation(id, {message.a.id, point.feature_a});
    const bool in_b = map->addObservation(id, {message.b.id, point.feature_b});
    if (!in_a || !in_b) map->removeLandmark(id);  // a feature was used twice
  }
  map->refreshChanged();
}

void scaleAbout(const Vec3d& center, double factor, Map* map) {
  for (const auto& [id, keyframe] : map->keyframes()) {
    SE3d T_world_cam = keyframe.T_cam_world.inverse();
    T_world_cam.t = center + factor * (T_world_cam.t - center);
    map->setPose(id, T_world_cam.inverse());
  }
  for (const LandmarkId id : map->landmarkIds()) {
    map->setPosition(id, center + factor * (map->landmark(id)->p_world - center));
    map->refreshGeometry(id);
  }
}

}  // namespace

bool startMap(MapperState* state, const InitialMap& message) {
  state->map.clear();
  state->bearings.clear();
  insertPair(message, &state->map);

  BundleOptions options;
  options.max_iterations = kIterations;
  options.rounds = kRounds;
  adjustWindow(state, windowAround(state->map, message.b.id, 2), options);

  const Keyframe& first = *state->map.keyframe(message.a.id);
  const double depth = medianDepth(state->map, first);
  const auto survivors = static_cast<double>(state->map.landmarkCount());
  if (depth <= 0.0 || survivors < kMinSurvivingShare * state->config.initialization.min_landmarks) {
    state->map.clear();
    return false;
  }
  scaleAbout(first.T_cam_world.inverse().t,
             state->config.initialization.median_depth / depth,
             &state->map);
  return true;
}

}  // namespace glide
