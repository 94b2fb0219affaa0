#include "loop/landmark_matching.h"

#include "feature/descriptor.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <numeric>

namespace glide {
namespace {

constexpr int kMaxDistance = 64;  // bits; further apart look unrelated images' corners, too
constexpr double kRatio = 0.85;   // best over the best one elsewhere
// Twins of one corner lie this close to each other, as share of their distance from a camera.
constexpr double kSamePlace = 0.05;
constexpr int kFar = std::numeric_limits<int>::max();

using Landmarks = std::span<const MapSnapshot::LandmarkEntry* const>;

/// Landmarks that were found at about the same spot.
bool isNear(const MapSnapshot::LandmarkEntry& a, const MapSnapshot::LandmarkEntry& b) {
  const double distance = 0.5 * (a.min_distance + a.max_distance);
  return (a.p_world - b.p_world).norm() < kSamePlace * distance;
}

struct Best {
  std::size_t index = 0;
  int distance = kFar;
};

Best closest(std::span<const int> distances) {
  const auto found = std::min_element(distances.begin(), distances.end());
  if (found == distances.end()) return {};
  return {static_cast<std::size_t>(found - distances.begin()), *found};
}

/// Closest among those that lie elsewhere than the best.
int rivalDistance(std::span<const int> distances, Landmarks landmarks, const Best& best) {
  int rival = kFar;
  for (std::size_t i = 0; i < landmarks.size(); ++i) {
    if (distances[i] < rival && !isNear(*landmarks[best.index], *landmarks[i])) {
      rival = distances[i];
    }
  }
  return rival;
}

std::vector<Descriptor> descriptorsOf(Landmarks landmarks) {
  std::vector<Descriptor> descriptors;
  descriptors.reserve(landmarks.size());
  for (const MapSnapshot::LandmarkEntry* landmark : landmarks) {
    descriptors.push_back(landmark->descriptor);
  }
  return descriptors;
}

}  // namespace

std::vector<const MapSnapshot::LandmarkEntry*> landmarksOf(const MapSnapshot& map,
                                                           std::span<const KeyframeId> keyframes) {
  std::vector<LandmarkId> ids;
  for (const KeyframeId id : keyframes) {
    const MapSnapshot::KeyframeEntry* keyframe = map.keyframe(id);
    if (keyframe != nullptr) {
      ids.insert(ids.end(), keyframe->landmarks.begin(), keyframe->landmarks.end());
    }
  }
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  std::vector<const MapSnapshot::LandmarkEntry*> landmarks;
  for (const LandmarkId id : ids) {
    const MapSnapshot::LandmarkEntry* landmark = map.landmark(id);
    if (landmark != nullptr) landmarks.push_back(landmark);  // kNoLandmark is none
  }
  return landmarks;
}

std::vector<LandmarkMatch> matchByLook(const MapSnapshot::KeyframeEntry& keyframe,
                                       const MapSnapshot& map,
                                       Landmarks landmarks) {
  const std::vector<Descriptor> descriptors = descriptorsOf(landmarks);
  std::vector<int> all(landmarks.size()), distances(landmarks.size());
  std::iota(all.begin(), all.end(), 0);
  struct Claim {
    int feature = -1, distance = kFar;
  };
  std::vector<Claim> claims(landmarks.size());  // per landmark, the feature that looks most alike
  std::vector<std::size_t> wanted(keyframe.landmarks.size(), landmarks.size());
  for (std::size_t i = 0; i < keyframe.landmarks.size(); ++i) {
    if (map.landmark(keyframe.landmarks[i]) == nullptr) continue;
    descriptorDistances(keyframe.features->descriptor(i), descriptors, all, distances);
    for (std::size_t k = 0; k < claims.size(); ++k) {
      if (distances[k] < claims[k].distance) claims[k] = {static_cast<int>(i), distances[k]};
    }
    const Best best = closest(distances);
    if (best.distance > kMaxDistance) continue;
    const int rival = rivalDistance(distances, landmarks, best);
    if (rival == kFar || best.distance < kRatio * rival) wanted[i] = best.index;
  }
  std::vector<LandmarkMatch> matches;
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    const int feature = static_cast<int>(i);
    if (wanted[i] == landmarks.size() || claims[wanted[i]].feature != feature) continue;
    matches.push_back({feature, landmarks[wanted[i]]});
  }
  return matches;
}

}  // namespace glide
