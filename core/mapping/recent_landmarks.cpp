#include "mapping/recent_landmarks.h"

#include <utility>

namespace glide {
namespace {

constexpr double kMinFoundRatio = 0.25;
constexpr int kProvenAge = 2;                // keyframes by which others must see it
constexpr int kReleaseAge = 3;               // keyframes
constexpr std::size_t kTooFewKeyframes = 2;  // what creation gives for free

bool fails(const Landmark& landmark, int age) {
  if (landmark.found_count < kMinFoundRatio * landmark.visible_count) return true;
  return age >= kProvenAge && landmark.observations.size() <= kTooFewKeyframes;
}

}  // namespace

void RecentLandmarks::add(const std::vector<LandmarkId>& created) {
  for (const LandmarkId id : created) entries_.push_back({id, 0});
}

void RecentLandmarks::cull(Map* map) {
  std::vector<Entry> kept;
  for (Entry entry : entries_) {
    const Landmark* landmark = map->landmark(entry.id);
    if (landmark == nullptr) continue;
    ++entry.age;
    if (fails(*landmark, entry.age)) {
      map->removeLandmark(entry.id);
    } else if (entry.age < kReleaseAge) {
      kept.push_back(entry);
    }
  }
  entries_ = std::move(kept);
}

}  // namespace glide
