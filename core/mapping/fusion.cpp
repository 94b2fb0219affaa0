#include "mapping/fusion.h"

#include "feature/matcher.h"

#include "geometry/robust.h"

#include <algorithm>
#include <optional>
#include <vector>

namespace glide {
namespace {

// Neighbours of each neighbour that take part too.
constexpr std::size_t kSecondNeighbors = 5;
// Search window in px of the expected level; the chi2 gate then decides.
constexpr double kRadiusPx = 3.0;
// A wrong fusion moves two landmarks: as strict as for new landmarks.
constexpr int kMaxDescriptorDistance = 50;
// Outside of this share of the scale range detection is unlikely (levels are quantised).
constexpr double kRangeSlack = 1.2;
// Viewing directions further apart look different.
constexpr double kMinViewingCosine = 0.5;
// Of what one landmark saw, explained by the other one's position: the gate alone refuses 5 %.
constexpr double kMinExplainedShare = 0.75;

std::vector<KeyframeId> keyframesAround(const MapperState& state,
                                        KeyframeId id,
                                        std::size_t second_count) {
  const int min_weight = state.config.mapping.min_covisibility;
  const auto wanted = static_cast<std::size_t>(state.config.mapping.neighbors);
  const Covisibility& covisibility = state.map.covisibility();
  std::vector<CovisibleKeyframe> neighbors = covisibility.neighbors(id, min_weight);
  if (neighbors.size() > wanted) neighbors.resize(wanted);
  std::vector<KeyframeId> result;
  for (const CovisibleKeyframe& neighbor : neighbors) {
    result.push_back(neighbor.id);
    std::vector<CovisibleKeyframe> second = covisibility.neighbors(neighbor.id, min_weight);
    if (second.size() > second_count) second.resize(second_count);
    for (const CovisibleKeyframe& keyframe : second) result.push_back(keyframe.id);
  }
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  result.erase(std::remove(result.begin(), result.end(), id), result.end());
  return result;
}

void appendLandmarks(const Keyframe& keyframe, std::vector<LandmarkId>* out) {
  for (const LandmarkId id : keyframe.landmarks) {
    if (id != kNoLandmark) out->push_back(id);
  }
}

bool isSeenBy(const Landmark& landmark, KeyframeId id) {
  for (const Observation& observation : landmark.observations) {
    if (observation.keyframe == id) return true;
  }
  return false;
}

// Where the keyframe should see the landmark; nothing when it should not.
std::optional<ProjectedTarget> expect(const MapperState& state,
                                      const Keyframe& keyframe,
                                      const Landmark& landmark) {
  const Vec3d p_cam = keyframe.T_cam_world * landmark.p_world;
  const double distance = p_cam.norm();
  if (distance > landmark.max_distance * kRangeSlack) return std::nullopt;
  if (distance < landmark.min_distance / kRangeSlack) return std::nullopt;
  const Vec3d normal_cam = keyframe.T_cam_world.q * landmark.normal;
  if (normal_cam.dot(p_cam) < kMinViewingCosine * distance) return std::nullopt;
  const std::optional<Vec2d> uv = state.camera.project(p_cam);
  if (!uv || !state.camera.isInImage(*uv, 0.0)) return std::nullopt;

  const int level = predictedLevel(state.map.levels(), landmark.max_distance, distance);
  ProjectedTarget target;
  target.uv = uv->cast<float>();
  target.radius_px = static_cast<float>(kRadiusPx * state.map.levels().scale(level));
  target.min_level = std::max(0, level - 1);
  target.max_level = level;
  target.descriptor = landmark.descriptor;
  return target;
}

// Two features of one image are two corners, or one corner on two levels: two landmarks either way.
bool areSeenTogether(const Landmark& a, const Landmark& b) {
  for (const Observation& seen_a : a.observations) {
    for (const Observation& seen_b : b.observations) {
      if (seen_a.keyframe == seen_b.keyframe) return true;
    }
  }
  return false;
}

// Whether the point reprojects onto the observed feature.
bool fits(const MapperState& state, const Vec3d& p_world, const Observation& observation) {
  const Keyframe& keyframe = *state.map.keyframe(observation.keyframe);
  const Feature& corner = keyframe.features->feature(static_cast<std::size_t>(observation.feature));
  const std::optional<Vec2d> uv = state.camera.project(keyframe.T_cam_world * p_world);
  const double inv_sigma = inverseSigma(state.map.levels(), corner.level);
  return uv && (*uv - corner.uv.cast<double>()).squaredNorm() * inv_sigma * inv_sigma < kChi2_2;
}

bool explains(const MapperState& state, const Vec3d& p_world, const Landmark& landmark) {
  std::size_t explained = 0;
  for (const Observation& observation : landmark.observations) {
    explained += fits(state, p_world, observation) ? 1U : 0U;
  }
  return static_cast<double>(explained) >=
         kMinExplainedShare * static_cast<double>(landmark.observations.size());
}

// The landmark with more observations survives, the older one among equals; its position must
// explain what the other one saw.
void merge(MapperState* state, LandmarkId id_a, LandmarkId id_b) {
  const Landmark& a = *state->map.landmark(id_a);
  const Landmark& b = *state->map.landmark(id_b);
  if (areSeenTogether(a, b)) return;
  const bool keep_a = a.observations.size() != b.observations.size()
                          ? a.observations.size() > b.observations.size()
                          : id_a < id_b;
  const Landmark& keeper = keep_a ? a : b;
  const Landmark& other = keep_a ? b : a;
  if (!explains(*state, keeper.p_world, other)) return;
  const LandmarkId gone = other.id;
  state->map.replaceLandmark(gone, keeper.id);
}

void associate(MapperState* state, KeyframeId keyframe_id, LandmarkId landmark_id, int feature) {
  const Landmark* landmark = state->map.landmark(landmark_id);
  if (landmark == nullptr || isSeenBy(*landmark, keyframe_id)) return;  // fused meanwhile
  const Observation observation{keyframe_id, feature};
  if (!fits(*state, landmark->p_world, observation)) return;

  const Keyframe& keyframe = *state->map.keyframe(keyframe_id);
  const LandmarkId holder = keyframe.landmarks[static_cast<std::size_t>(feature)];
  if (holder == kNoLandmark) {
    state->map.addObservation(landmark_id, observation);
  } else {
    merge(state, landmark_id, holder);
  }
}

// `landmarks` into the keyframe.
void fuseInto(MapperState* state, KeyframeId id, const std::vector<LandmarkId>& landmarks) {
  const Keyframe& keyframe = *state->map.keyframe(id);
  std::vector<ProjectedTarget> targets;
  for (std::size_t i = 0; i < landmarks.size(); ++i) {
    const Landmark* landmark = state->map.landmark(landmarks[i]);
    if (landmark == nullptr || isSeenBy(*landmark, id)) continue;
    std::optional<ProjectedTarget> target = expect(*state, keyframe, *landmark);
    if (!target) continue;
    target->id = static_cast<int>(i);
    targets.push_back(*target);
  }
  MatchOptions options;
  options.max_distance = kMaxDescriptorDistance;
  options.ratio = 1.0;  // the window is a few pixels: the best there is meant
  options.check_orientation = false;
  for (const Match& match : matchByProjection(targets, *keyframe.features, {}, options)) {
    associate(state, id, landmarks[static_cast<std::size_t>(match.a)], match.b);
  }
}

}  // namespace

void fuseAround(MapperState* state, KeyframeId id, const std::atomic<bool>* interrupt) {
  const bool is_hurried = interrupt != nullptr && interrupt->load();
  const std::vector<KeyframeId> around =
      keyframesAround(*state, id, is_hurried ? 0 : kSecondNeighbors);
  std::vector<LandmarkId> theirs;
  for (const KeyframeId neighbor : around) appendLandmarks(*state->map.keyframe(neighbor), &theirs);
  std::sort(theirs.begin(), theirs.end());
  theirs.erase(std::unique(theirs.begin(), theirs.end()), theirs.end());
  fuseInto(state, id, theirs);

  std::vector<LandmarkId> own;  // with what was just found
  appendLandmarks(*state->map.keyframe(id), &own);
  for (const KeyframeId neighbor : around) fuseInto(state, neighbor, own);
  state->map.refreshChanged();
}

}  // namespace glide
