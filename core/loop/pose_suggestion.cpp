#include "loop/pose_suggestion.h"

#include "feature/matcher.h"

#include "geometry/pnp.h"
#include "geometry/sampling.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <optional>
#include <utility>

namespace glide {
namespace {

// Strict, because nothing but the descriptors decides.
constexpr MatchOptions kMatch{64, 0.8, true};

// Corners of all levels: those of the coarsest have a standard deviation of 3.6 px. 300 samples
// find a pose that 31 % of the matches agree on with a probability of 99.99 %.
constexpr PnpOptions kPnp{5.0, 300, 12, 1};

// A second pose matters when it explains this share of what the first does.
constexpr double kSecondShare = 0.3;
constexpr std::size_t kPnpSample = 3;  // P3P

// Of a keyframe: enough for a pose; matching them with 1000 features takes 1.3 ms.
constexpr std::size_t kMaxLandmarks = 400;

/// Landmarks and the pixels at which they seem to be.
struct Correspondences {
  std::vector<PointPixel> points;
  std::vector<LandmarkId> ids;

  /// Keeps those that a pose does not explain; the others are its suggestion.
  PoseSuggestion take(const PnpResult& pnp) {
    PoseSuggestion suggestion{pnp.T_cam_world, {}};
    std::size_t kept = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (pnp.inlier[i]) {
        suggestion.seen.push_back(ids[i]);
        continue;
      }
      points[kept] = points[i];
      ids[kept++] = ids[i];
    }
    points.resize(kept);
    ids.resize(kept);
    return suggestion;
  }
};

/// A feature of the frame and the landmark that it seems to be.
struct Pair {
  const MapSnapshot::LandmarkEntry* landmark = nullptr;
  int distance = std::numeric_limits<int>::max();  // bits
};

/// Features of the keyframe that have a landmark; of many those whose landmarks most keyframes see.
std::vector<int> bestFeatures(const MapSnapshot& map, const MapSnapshot::KeyframeEntry& keyframe) {
  std::vector<std::pair<std::size_t, int>> ranked;  // observations, feature
  for (std::size_t i = 0; i < keyframe.landmarks.size(); ++i) {
    const MapSnapshot::LandmarkEntry* landmark = map.landmark(keyframe.landmarks[i]);
    if (landmark != nullptr)
      ranked.emplace_back(landmark->observations.size(), static_cast<int>(i));
  }
  std::sort(ranked.begin(), ranked.end(), std::greater<>());
  if (ranked.size() > kMaxLandmarks) ranked.resize(kMaxLandmarks);
  std::vector<int> features;
  for (const auto& entry : ranked) features.push_back(entry.second);
  return features;
}

/// Pairs of each feature with the landmark of the most similar corner in one of the keyframes.
std::vector<Pair> pairUp(const MapSnapshot& map,
                         const PlaceGroup& group,
                         const FeatureSet& features) {
  std::vector<Pair> pairs(features.size());
  for (const MapSnapshot::KeyframeEntry* keyframe : group.keyframes) {
    const std::vector<int> subset = bestFeatures(map, *keyframe);
    if (subset.empty()) continue;  // would mean all
    for (const Match& match : matchBruteForce(*keyframe->features, subset, features, kMatch)) {
      Pair& pair = pairs[static_cast<std::size_t>(match.b)];
      if (match.distance >= pair.distance) continue;
      const LandmarkId id = keyframe->landmarks[static_cast<std::size_t>(match.a)];
      pair = {map.landmark(id), match.distance};
    }
  }
  return pairs;
}

Correspondences correspondencesOf(const MapSnapshot& map,
                                  const PlaceGroup& group,
                                  const FeatureSet& features) {
  Correspondences result;
  const std::vector<Pair> pairs = pairUp(map, group, features);
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    if (pairs[i].landmark == nullptr) continue;
    result.points.push_back({pairs[i].landmark->p_world, features.feature(i).uv.cast<double>()});
    result.ids.push_back(pairs[i].landmark->id);
  }
  return result;
}

/// As many samples as a second pose that matters needs among what the first one left.
PnpOptions optionsForSecond(const PnpResult& first, std::size_t left) {
  PnpOptions options = kPnp;
  options.min_inliers = std::max(kPnp.min_inliers, static_cast<int>(kSecondShare * first.inliers));
  const double share = options.min_inliers / std::max(static_cast<double>(left), 1.0);
  options.iterations = std::min(kPnp.iterations, samplesNeeded(share, kPnpSample));
  return options;
}

}  // namespace

std::vector<PoseSuggestion> suggestPoses(const CameraModel& camera,
                                         const MapSnapshot& map,
                                         const PlaceGroup& group,
                                         const FeatureSet& features) {
  Correspondences seen = correspondencesOf(map, group, features);
  std::vector<PoseSuggestion> suggestions;
  const std::optional<PnpResult> first = solvePnp(camera, seen.points, kPnp);
  if (!first) return suggestions;
  suggestions.push_back(seen.take(*first));
  const std::optional<PnpResult> second =
      solvePnp(camera, seen.points, optionsForSecond(*first, seen.points.size()));
  if (second) suggestions.push_back(seen.take(*second));
  return suggestions;
}

}  // namespace glide
