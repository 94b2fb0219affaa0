#include "map/map_snapshot.h"

#include <algorithm>
#include <cassert>
#include <utility>

namespace glide {
namespace {

template <class Entry>
bool ascends(const std::vector<Entry>& entries) {
  return std::is_sorted(
      entries.begin(), entries.end(), [](const Entry& a, const Entry& b) { return a.id < b.id; });
}

template <class Entry>
const Entry* findById(const std::vector<Entry>& entries, KeyframeId id) {
  const auto found = std::lower_bound(
      entries.begin(), entries.end(), id, [](const Entry& e, KeyframeId i) { return e.id < i; });
  return found != entries.end() && found->id == id ? &*found : nullptr;
}

}  // namespace

MapSnapshot::MapSnapshot(Parts parts) : parts_(std::move(parts)) {
  const std::vector<LandmarkEntry>& landmarks = parts_.landmarks;
  assert(ascends(parts_.keyframes) && ascends(landmarks) && ascends(parts_.retired));
  landmark_index_.reserve(landmarks.size());
  for (std::size_t i = 0; i < landmarks.size(); ++i) landmark_index_.emplace(landmarks[i].id, i);
}

const MapSnapshot::KeyframeEntry* MapSnapshot::keyframe(KeyframeId id) const {
  return findById(parts_.keyframes, id);
}

const MapSnapshot::LandmarkEntry* MapSnapshot::landmark(LandmarkId id) const {
  const auto found = landmark_index_.find(id);
  return found != landmark_index_.end() ? &parts_.landmarks[found->second] : nullptr;
}

std::optional<SE3d> MapSnapshot::T_cam_world(KeyframeId id) const {
  if (const KeyframeEntry* living = keyframe(id)) return living->T_cam_world;
  if (const RetiredEntry* gone = findById(parts_.retired, id)) return gone->T_cam_world;
  return std::nullopt;
}

std::optional<double> MapSnapshot::scale(KeyframeId id) const {
  if (const KeyframeEntry* living = keyframe(id)) return living->scale;
  if (const RetiredEntry* gone = findById(parts_.retired, id)) return gone->scale;
  return std::nullopt;
}

}  // namespace glide
