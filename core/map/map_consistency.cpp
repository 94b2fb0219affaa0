#include "map/map_consistency.h"

#include <map>
#include <utility>

namespace glide {
namespace {

std::string landmarkName(LandmarkId id) { return "landmark " + std::to_string(id.value); }

std::string keyframeName(KeyframeId id) { return "keyframe " + std::to_string(id.value); }

// Every slot of a keyframe names a landmark that lists the slot.
std::string checkSlots(const Map& map, const Keyframe& keyframe) {
  if (keyframe.landmarks.size() != keyframe.features->size()) {
    return keyframeName(keyframe.id) + " has another number of slots than features";
  }
  for (std::size_t i = 0; i < keyframe.landmarks.size(); ++i) {
    if (keyframe.landmarks[i] == kNoLandmark) continue;
    const Landmark* landmark = map.landmark(keyframe.landmarks[i]);
    if (landmark == nullptr) return keyframeName(keyframe.id) + " sees a landmark that is gone";
    bool listed = false;
    for (const Observation& observation : landmark->observations) {
      listed = listed ||
               (observation.keyframe == keyframe.id && observation.feature == static_cast<int>(i));
    }
    if (!listed) return landmarkName(landmark->id) + " does not list " + keyframeName(keyframe.id);
  }
  return {};
}

// Every observation of a landmark names a slot that holds the landmark.
std::string checkObservations(const Map& map, const Landmark& landmark) {
  if (landmark.observations.size() < 2)
    return landmarkName(landmark.id) + " has too few observations";
  const Observation* previous = nullptr;
  for (const Observation& observation : landmark.observations) {
    const Keyframe* keyframe = map.keyframe(observation.keyframe);
    if (keyframe == nullptr)
      return landmarkName(landmark.id) + " is seen by a keyframe that is gone";
    const auto slot = static_cast<std::size_t>(observation.feature);
    if (slot >= keyframe->landmarks.size() || keyframe->landmarks[slot] != landmark.id) {
      return keyframeName(keyframe->id) + " does not hold " + landmarkName(landmark.id);
    }
    if (previous != nullptr && !(previous->keyframe < observation.keyframe)) {
      return landmarkName(landmark.id) + " does not list its keyframes in order";
    }
    previous = &observation;
  }
  return {};
}

using Weights = std::map<std::pair<KeyframeId, KeyframeId>, int>;

void countPairs(const Landmark& landmark, Weights* weights) {
  for (const Observation& a : landmark.observations) {
    for (const Observation& b : landmark.observations) {
      if (a.keyframe != b.keyframe) ++(*weights)[{a.keyframe, b.keyframe}];
    }
  }
}

std::string checkCovisibility(const Map& map) {
  Weights weights;
  for (const LandmarkId id : map.landmarkIds()) countPairs(*map.landmark(id), &weights);
  std::size_t edges = 0;
  for (const auto& [id, keyframe] : map.keyframes()) {
    edges += map.covisibility().neighbors(id, 1).size();
  }
  if (edges != weights.size()) return "the covisibility has another number of edges";
  for (const auto& [pair, weight] : weights) {
    if (map.covisibility().weight(pair.first, pair.second) != weight) {
      return "wrong covisibility of " + keyframeName(pair.first) + " and " +
             keyframeName(pair.second);
    }
  }
  return {};
}

std::string checkRetired(const Map& map) {
  for (const auto& [id, retired] : map.retired()) {
    if (map.keyframe(id) != nullptr) return keyframeName(id) + " is living and retired";
    if (map.keyframe(retired.parent) == nullptr) return keyframeName(id) + " has no living parent";
  }
  return {};
}

}  // namespace

std::string checkConsistency(const Map& map) {
  for (const auto& [id, keyframe] : map.keyframes()) {
    if (std::string error = checkSlots(map, keyframe); !error.empty()) return error;
  }
  const std::vector<LandmarkId> ids = map.landmarkIds();
  if (ids.size() != map.landmarkCount()) return "the list of landmark ids is incomplete";
  for (const LandmarkId id : ids) {
    if (std::string error = checkObservations(map, *map.landmark(id)); !error.empty()) return error;
  }
  if (std::string error = checkCovisibility(map); !error.empty()) return error;
  return checkRetired(map);
}

}  // namespace glide
