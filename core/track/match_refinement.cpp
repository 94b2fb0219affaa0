#include "track/match_refinement.h"

#include <optional>
#include <unordered_map>

namespace glide {
namespace {

// The oldest view that still looks alike serves as template, so that errors do not add up from view
// to view: cos(25 degrees).
constexpr double kSimilarCosine = 0.9;
constexpr double kMaxScaleChange = 1.6;

/// Camera centres of the snapshot's keyframes, looked up once per frame.
class Centers {
 public:
  explicit Centers(const MapSnapshot& map) : map_(map) {}

  const Vec3d* of(KeyframeId id) {
    const auto known = centers_.find(id);
    if (known != centers_.end()) return &known->second;
    const MapSnapshot::KeyframeEntry* keyframe = map_.keyframe(id);
    if (keyframe == nullptr) return nullptr;
    return &centers_.emplace(id, keyframe->T_cam_world.inverse().t).first->second;
  }

 private:
  const MapSnapshot& map_;
  std::unordered_map<KeyframeId, Vec3d> centers_;
};

const Observation* chooseTemplate(const MapSnapshot::LandmarkEntry& landmark,
                                  const Vec3d& center_world,
                                  Centers* centers) {
  const Vec3d view = center_world - landmark.p_world;
  const Observation* best = nullptr;
  double best_cosine = 0.0;
  for (const Observation& observation : landmark.observations) {
    const Vec3d* center = centers->of(observation.keyframe);
    if (center == nullptr) continue;
    const Vec3d other = *center - landmark.p_world;
    const double ratio = other.norm() / view.norm();
    if (ratio > kMaxScaleChange || ratio < 1.0 / kMaxScaleChange) continue;
    const double cosine = view.dot(other) / (view.norm() * other.norm());
    if (cosine > kSimilarCosine) return &observation;
    if (cosine <= best_cosine) continue;
    best = &observation;
    best_cosine = cosine;
  }
  return best;
}

}  // namespace

std::vector<FeatureMove> refineMatches(const RefinementContext& context,
                                       const MapSnapshot& map,
                                       const SE3d& T_cam_world,
                                       const FeatureSet& features,
                                       const LandmarkMatches& matches) {
  std::vector<FeatureMove> moves;
  Centers centers(map);
  const Vec3d center_world = T_cam_world.inverse().t;
  for (std::size_t i = 0; i < matches.of_feature.size(); ++i) {
    const MapSnapshot::LandmarkEntry* landmark = matches.of_feature[i];
    if (landmark == nullptr) continue;
    const Observation* source = chooseTemplate(*landmark, center_world, &centers);
    if (source == nullptr) continue;
    const MapSnapshot::KeyframeEntry& keyframe = *map.keyframe(source->keyframe);
    const std::optional<FeatureMove> move =
        refineFeature(context,
                      {keyframe.features.get(), source->feature, keyframe.T_cam_world},
                      {&features, static_cast<int>(i), T_cam_world},
                      landmark->p_world);
    if (move) moves.push_back(*move);
  }
  return moves;
}

}  // namespace glide
