#include "mapping/new_landmarks.h"

#include "mapping/epipolar_search.h"

#include "base/median.h"
#include "geometry/robust.h"
#include "geometry/triangulate.h"

#include <optional>
#include <utility>

namespace glide {
namespace {

// A neighbour this close (relative to the scene) gives no depth, only noise.
constexpr double kMinBaselineOverDepth = 0.01;
// When another keyframe waits: the best neighbours carry most of the new landmarks.
constexpr std::size_t kNeighborsWhenInterrupted = 4;
// There is no position prior along the epipolar line: stricter than tracking.
constexpr int kMaxDescriptorDistance = 50;
constexpr double kDescriptorRatio = 0.8;
constexpr double kRadPerDeg = 3.14159265358979323846 / 180.0;

EpipolarView viewOf(const Keyframe& keyframe, BearingCache* bearings) {
  return {keyframe.features.get(), bearings->of(keyframe), keyframe.landmarks};
}

bool reprojects(const MapperState& state, const Feature& feature, const Vec3d& p_cam) {
  const std::optional<Vec2d> uv = state.camera.project(p_cam);
  if (!uv) return false;
  const double inv_sigma = inverseSigma(state.map.levels(), feature.level);
  return (*uv - feature.uv.cast<double>()).squaredNorm() * inv_sigma * inv_sigma < kChi2_2;
}

// Point in camera a, when both features agree on it.
std::optional<Vec3d> locate(MapperState* state,
                            const Keyframe& a,
                            const Keyframe& b,
                            const SE3d& T_b_a,
                            const Match& match) {
  const auto i = static_cast<std::size_t>(match.a);
  const auto j = static_cast<std::size_t>(match.b);
  std::optional<Vec3d> p_a = triangulate(T_b_a, state->bearings.of(a)[i], state->bearings.of(b)[j]);
  if (!p_a || !p_a->allFinite()) return std::nullopt;
  if (!reprojects(*state, a.features->feature(i), *p_a)) return std::nullopt;
  if (!reprojects(*state, b.features->feature(j), T_b_a * *p_a)) return std::nullopt;
  return p_a;
}

void createWithNeighbor(MapperState* state,
                        KeyframeId id_a,
                        KeyframeId id_b,
                        std::vector<LandmarkId>* created) {
  const Keyframe& a = *state->map.keyframe(id_a);
  const Keyframe& b = *state->map.keyframe(id_b);
  const SE3d T_world_a = a.T_cam_world.inverse();
  const SE3d T_b_a = b.T_cam_world * T_world_a;
  if (T_b_a.t.norm() < kMinBaselineOverDepth * medianDepth(state->map, b)) return;

  EpipolarOptions options;
  options.focal_px = focalPx(state->camera);
  options.min_parallax_rad = state->config.mapping.min_parallax_deg * kRadPerDeg;
  options.max_distance = kMaxDescriptorDistance;
  options.ratio = kDescriptorRatio;
  const std::vector<Match> matches = matchAlongEpipolarPlanes(viewOf(a, &state->bearings),
                                                              viewOf(b, &state->bearings),
                                                              T_b_a,
                                                              options,
                                                              state->map.levels());
  for (const Match& match : matches) {
    const std::optional<Vec3d> p_a = locate(state, a, b, T_b_a, match);
    if (!p_a) continue;
    const LandmarkId landmark = state->map.addLandmark(T_world_a * *p_a, id_a);
    state->map.addObservation(landmark, {id_a, match.a});
    state->map.addObservation(landmark, {id_b, match.b});
    created->push_back(landmark);
  }
}

}  // namespace

std::vector<LandmarkId> createLandmarks(MapperState* state,
                                        KeyframeId id,
                                        const std::atomic<bool>* interrupt) {
  std::vector<LandmarkId> created;
  std::vector<CovisibleKeyframe> neighbors =
      state->map.covisibility().neighbors(id, state->config.mapping.min_covisibility);
  const auto wanted = static_cast<std::size_t>(state->config.mapping.neighbors);
  if (neighbors.size() > wanted) neighbors.resize(wanted);
  for (std::size_t i = 0; i < neighbors.size(); ++i) {
    const bool is_hurried = interrupt != nullptr && interrupt->load();
    if (is_hurried && i >= kNeighborsWhenInterrupted) break;
    createWithNeighbor(state, id, neighbors[i].id, &created);
  }
  state->map.refreshChanged();
  return created;
}

double medianDepth(const Map& map, const Keyframe& keyframe) {
  std::vector<double> depths;
  for (const LandmarkId id : keyframe.landmarks) {
    const Landmark* landmark = id != kNoLandmark ? map.landmark(id) : nullptr;
    if (landmark == nullptr) continue;
    const double depth = (keyframe.T_cam_world * landmark->p_world).z();
    if (depth > 0.0) depths.push_back(depth);
  }
  return median(std::move(depths), 0.0);
}

}  // namespace glide
