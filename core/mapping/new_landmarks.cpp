#include "mapping/new_landmarks.h"

#include "mapping/epipolar_search.h"
#include "mapping/witnesses.h"

#include "map/feature_refinement.h"

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

bool reprojects(const MapperState& state, const Vec2d& uv_seen, int level, const Vec3d& p_cam) {
  const std::optional<Vec2d> uv = state.camera.project(p_cam);
  if (!uv) return false;
  const double inv_sigma = inverseSigma(state.map.levels(), level);
  return (*uv - uv_seen).squaredNorm() * inv_sigma * inv_sigma < kChi2_2;
}

// A pair of keyframes with the way between them.
struct Pair {
  const Keyframe& a;
  const Keyframe& b;
  SE3d T_b_a;
};

// Point in camera a, when both features agree on it.
std::optional<Vec3d> locate(MapperState* state,
                            const Pair& pair,
                            const Match& match,
                            const Vec2d& uv_a) {
  const Feature& feature_a = pair.a.features->feature(static_cast<std::size_t>(match.a));
  const auto j = static_cast<std::size_t>(match.b);
  const Feature& feature_b = pair.b.features->feature(j);
  const std::optional<Vec3d> bearing_a = state->camera.unproject(uv_a);
  if (!bearing_a) return std::nullopt;
  std::optional<Vec3d> p_a = triangulate(pair.T_b_a, *bearing_a, state->bearings.of(pair.b)[j]);
  if (!p_a || !p_a->allFinite()) return std::nullopt;
  if (!reprojects(*state, uv_a, feature_a.level, *p_a)) return std::nullopt;
  const Vec2d uv_b = feature_b.uv.cast<double>();
  if (!reprojects(*state, uv_b, feature_b.level, pair.T_b_a * *p_a)) return std::nullopt;
  return p_a;
}

struct Located {
  Vec3d p_a;
  std::optional<FeatureMove> move;  // of a's feature
};

// Point in camera a from the corners as found, then with a's corner aligned to b's patch: depth
// from a short baseline needs both to be the same spot to a tenth of a pixel.
std::optional<Located> locateAligned(MapperState* state, const Pair& pair, const Match& match) {
  const auto i = static_cast<std::size_t>(match.a);
  const Vec2d uv_a = pair.a.features->feature(i).uv.cast<double>();
  const std::optional<Vec3d> p_a = locate(state, pair, match, uv_a);
  if (!p_a) return std::nullopt;
  const std::optional<FeatureMove> move =
      refineFeature({&state->camera, &state->map.levels()},
                    {pair.b.features.get(), match.b, pair.b.T_cam_world},
                    {pair.a.features.get(), match.a, pair.a.T_cam_world},
                    pair.a.T_cam_world.inverse() * *p_a);
  if (!move) return Located{*p_a, std::nullopt};
  const std::optional<Vec3d> p_aligned = locate(state, pair, match, move->uv.cast<double>());
  if (!p_aligned) return std::nullopt;
  return Located{*p_aligned, move};
}

struct Creation {
  std::vector<LandmarkId> landmarks;
  std::vector<FeatureMove> moves;  // of the new keyframe's features
};

void createWithNeighbor(MapperState* state, KeyframeId id_a, KeyframeId id_b, Creation* creation) {
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
  const Witnesses witnesses(*state, a, b);
  for (const Match& match : matches) {
    const std::optional<Located> located = locateAligned(state, {a, b, T_b_a}, match);
    if (!located) continue;
    const Vec3d p_world = T_world_a * located->p_a;
    if (!witnesses.agree(p_world, match.a)) continue;
    if (located->move) creation->moves.push_back(*located->move);
    const LandmarkId landmark = state->map.addLandmark(p_world, id_a);
    state->map.addObservation(landmark, {id_a, match.a});
    state->map.addObservation(landmark, {id_b, match.b});
    creation->landmarks.push_back(landmark);
  }
}

}  // namespace

std::vector<LandmarkId> createLandmarks(MapperState* state,
                                        KeyframeId id,
                                        const std::atomic<bool>* interrupt) {
  Creation creation;
  std::vector<CovisibleKeyframe> neighbors =
      state->map.covisibility().neighbors(id, state->config.mapping.min_covisibility);
  const auto wanted = static_cast<std::size_t>(state->config.mapping.neighbors);
  if (neighbors.size() > wanted) neighbors.resize(wanted);
  for (std::size_t i = 0; i < neighbors.size(); ++i) {
    const bool is_hurried = interrupt != nullptr && interrupt->load();
    if (is_hurried && i >= kNeighborsWhenInterrupted) break;
    createWithNeighbor(state, id, neighbors[i].id, &creation);
  }
  state->map.moveFeatures(id, creation.moves);
  state->bearings.forget(id);
  state->map.refreshChanged();
  return creation.landmarks;
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
