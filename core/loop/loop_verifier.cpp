#include "loop/loop_verifier.h"

#include "loop/keyframe_graph.h"
#include "loop/projected_search.h"

#include "optimize/sim3_optimizer.h"

#include "geometry/sim3_ransac.h"

#include <algorithm>
#include <array>
#include <bitset>
#include <cstddef>
#include <unordered_map>

namespace glide {
namespace {

using KeyframeEntry = MapSnapshot::KeyframeEntry;
using LandmarkEntry = MapSnapshot::LandmarkEntry;

// Keyframes whose landmarks make up a place.
constexpr std::size_t kPlaceKeyframes = 12;
// Landmarks are less certain than the pixels of one image: twice the sigma of the 99 % quantile.
constexpr double kRansacError2 = 4.0 * 9.21;
constexpr int kRansacIterations = 300;
constexpr int kMinRansacInliers = 12;
// Gate of the refinement, sigma^2, and search windows of its rounds, px.
constexpr double kRefineError2 = 9.21;
constexpr std::array<double, 3> kWindowsPx{10.0, 6.0, 4.0};
// What is returned at all; isBeyondDoubt() asks for more.
constexpr int kMinPairs = 15;

// A loop that bends the map needs this much.
constexpr int kMinSurePairs = 25;
constexpr int kMinSureMatches = 40;
constexpr int kMinSureCells = 6;
constexpr double kMinSureShare = 0.1;
// Of the matches by look, true loops explain two thirds and more; where structure repeats, each
// repetition takes its part, and the best one gets a fifth.
constexpr double kMinAgreeingShare = 0.4;

constexpr std::size_t kGrid = 4;  // cells per side of the image

/// A keyframe with the landmarks around it.
struct Place {
  const KeyframeEntry& keyframe;
  std::vector<const LandmarkEntry*> landmarks;
  std::unordered_map<LandmarkId, int> features;  ///< of the keyframe, by landmark
};

Sim3d toSim3(const SE3d& T_a_b) { return {T_a_b.q, T_a_b.t, 1.0}; }

/// The place around `keyframe`, without what `other` sees: that says nothing about a loop.
Place placeAround(const KeyframeEntry& keyframe,
                  const KeyframeEntry& other,
                  const MapSnapshot& map) {
  Place place{keyframe, landmarksOf(map, placeOf(keyframe, kPlaceKeyframes)), {}};
  std::vector<LandmarkId> known = other.landmarks;
  std::sort(known.begin(), known.end());
  const auto isKnown = [&](const LandmarkEntry* landmark) {
    return std::binary_search(known.begin(), known.end(), landmark->id);
  };
  place.landmarks.erase(std::remove_if(place.landmarks.begin(), place.landmarks.end(), isKnown),
                        place.landmarks.end());
  for (std::size_t i = 0; i < keyframe.landmarks.size(); ++i) {
    if (keyframe.landmarks[i] != kNoLandmark) {
      place.features[keyframe.landmarks[i]] = static_cast<int>(i);
    }
  }
  return place;
}

/// Both sides of one loop.
struct Sides {
  const CameraModel& camera;
  const ScaleLevels& levels;
  const MapSnapshot& map;
  Place newer, older;
};

/// How the older keyframe sees a landmark of its place; where it does not, where it should.
bool seenByOlder(const Sides& sides, const LandmarkEntry& landmark, Sim3Pair* pair) {
  const KeyframeEntry& older = sides.older.keyframe;
  pair->p_b = older.T_cam_world * landmark.p_world;
  const auto seen = sides.older.features.find(landmark.id);
  if (seen != sides.older.features.end()) {
    const Feature& feature = older.features->feature(static_cast<std::size_t>(seen->second));
    pair->uv_b = feature.uv.cast<double>();
    pair->inv_sigma_b = 1.0 / sides.levels.scale(feature.level);
    return true;
  }
  const auto uv = sides.camera.project(pair->p_b);
  if (!uv) return false;
  const int level = predictedLevel(sides.levels, landmark.max_distance, pair->p_b.norm());
  pair->uv_b = *uv;
  pair->inv_sigma_b = 1.0 / sides.levels.scale(level);
  return true;
}

/// Matches whose feature has a landmark of its own, as pairs of points.
std::vector<Sim3Pair> pairsOf(const Sides& sides, std::span<const LandmarkMatch> matches) {
  const KeyframeEntry& newer = sides.newer.keyframe;
  std::vector<Sim3Pair> pairs;
  for (const LandmarkMatch& match : matches) {
    const auto index = static_cast<std::size_t>(match.feature);
    const LandmarkEntry* own = sides.map.landmark(newer.landmarks[index]);
    Sim3Pair pair;
    if (own == nullptr || !seenByOlder(sides, *match.landmark, &pair)) continue;
    const Feature& feature = newer.features->feature(index);
    pair.p_a = newer.T_cam_world * own->p_world;
    pair.uv_a = feature.uv.cast<double>();
    pair.inv_sigma_a = 1.0 / sides.levels.scale(feature.level);
    pairs.push_back(pair);
  }
  return pairs;
}

ProjectedSearch searchNewer(const Sides& sides, const Sim3d& S_newer_older, double radius_px) {
  const AssumedView view{*sides.newer.keyframe.features,
                         S_newer_older * toSim3(sides.older.keyframe.T_cam_world)};
  const ProjectedSearchOptions options{.radius_px = radius_px};
  return searchProjected(sides.camera, sides.levels, view, sides.older.landmarks, options);
}

ProjectedSearch searchOlder(const Sides& sides, const Sim3d& S_newer_older, double radius_px) {
  const AssumedView view{*sides.older.keyframe.features,
                         S_newer_older.inverse() * toSim3(sides.newer.keyframe.T_cam_world)};
  const ProjectedSearchOptions options{.radius_px = radius_px};
  return searchProjected(sides.camera, sides.levels, view, sides.newer.landmarks, options);
}

struct FirstGuess {
  Sim3d S_newer_older;
  double agreeing_share = 0.0;
};

std::optional<FirstGuess> guessByLook(const Sides& sides) {
  const auto matches = matchByLook(sides.newer.keyframe, sides.map, sides.older.landmarks);
  Sim3RansacOptions options;
  options.max_error2 = kRansacError2;
  options.iterations = kRansacIterations;
  options.min_inliers = kMinRansacInliers;
  options.seed = sides.newer.keyframe.id.value + 1;
  const std::vector<Sim3Pair> pairs = pairsOf(sides, matches);
  const auto found = solveSim3(sides.camera, pairs, options);
  if (!found) return std::nullopt;
  return FirstGuess{found->S_a_b, found->inliers / static_cast<double>(pairs.size())};
}

/// Rounds of guided matches and refinement; the pairs that agree in the end.
std::optional<Sim3Estimate> refine(const Sides& sides, const Sim3d& S_newer_older_guess) {
  Sim3Estimate estimate;
  estimate.S_a_b = S_newer_older_guess;
  for (const double radius_px : kWindowsPx) {
    const ProjectedSearch found = searchNewer(sides, estimate.S_a_b, radius_px);
    const std::vector<Sim3Pair> pairs = pairsOf(sides, found.matches);
    estimate = optimizeSim3(sides.camera, pairs, estimate.S_a_b, kRefineError2);
    if (!estimate.valid || estimate.inliers < kMinPairs) return std::nullopt;
  }
  return estimate;
}

int occupiedCells(const CameraModel& camera,
                  const FeatureSet& features,
                  std::span<const LandmarkMatch> matches) {
  const auto cellOf = [](float position, int size) {
    const float share = std::max(position, 0.0F) / static_cast<float>(size);
    return std::min(static_cast<std::size_t>(share * static_cast<float>(kGrid)), kGrid - 1);
  };
  std::bitset<kGrid * kGrid> occupied;
  for (const LandmarkMatch& match : matches) {
    const Vec2f& uv = features.feature(static_cast<std::size_t>(match.feature)).uv;
    occupied.set(cellOf(uv.y(), camera.height()) * kGrid + cellOf(uv.x(), camera.width()));
  }
  return static_cast<int>(occupied.count());
}

double shareOf(const ProjectedSearch& search) {
  return search.expected > 0
             ? static_cast<double>(search.matches.size()) / static_cast<double>(search.expected)
             : 0.0;
}

}  // namespace

std::optional<LoopGeometry> LoopVerifier::verify(const KeyframeEntry& newer,
                                                 const KeyframeEntry& older,
                                                 const MapSnapshot& map) const {
  const Sides sides{
      camera_, levels_, map, placeAround(newer, older, map), placeAround(older, newer, map)};
  const std::optional<FirstGuess> guess = guessByLook(sides);
  if (!guess) return std::nullopt;
  const std::optional<Sim3Estimate> estimate = refine(sides, guess->S_newer_older);
  if (!estimate) return std::nullopt;

  const ProjectedSearch in_newer = searchNewer(sides, estimate->S_a_b, kWindowsPx.back());
  const ProjectedSearch in_older = searchOlder(sides, estimate->S_a_b, kWindowsPx.back());
  LoopGeometry geometry;
  geometry.newer = newer.id;
  geometry.older = older.id;
  geometry.S_newer_older = estimate->S_a_b;
  geometry.matches = in_newer.matches;
  geometry.agreeing_share = guess->agreeing_share;
  geometry.pairs = estimate->inliers;
  geometry.cells = occupiedCells(camera_, *newer.features, in_newer.matches);
  geometry.share_newer = shareOf(in_newer);
  geometry.share_older = shareOf(in_older);
  return geometry;
}

bool isBeyondDoubt(const LoopGeometry& geometry) {
  return geometry.agreeing_share >= kMinAgreeingShare && geometry.pairs >= kMinSurePairs &&
         geometry.cells >= kMinSureCells &&
         static_cast<int>(geometry.matches.size()) >= kMinSureMatches &&
         geometry.share_newer >= kMinSureShare && geometry.share_older >= kMinSureShare;
}

}  // namespace glide
