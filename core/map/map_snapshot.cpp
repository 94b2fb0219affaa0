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

MapSnapshot::MapSnapshot(std::uint64_t revision,
                         std::vector<KeyframeEntry> keyframes,
                         std::vector<LandmarkEntry> landmarks,
                         std::vector<RetiredEntry> retired,
                         std::vector<LoopEdge> loops)
    : revision_(revision),
      keyframes_(std::move(keyframes)),
      landmarks_(std::move(landmarks)),
      retired_(std::move(retired)),
      loops_(std::move(loops)) {
  assert(ascends(keyframes_) && ascends(landmarks_) && ascends(retired_));
  landmark_index_.reserve(landmarks_.size());
  for (std::size_t i = 0; i < landmarks_.size(); ++i) landmark_index_.emplace(landmarks_[i].id, i);
}

const MapSnapshot::KeyframeEntry* MapSnapshot::keyframe(KeyframeId id) const {
  return findById(keyframes_, id);
}

const MapSnapshot::LandmarkEntry* MapSnapshot::landmark(LandmarkId id) const {
  const auto found = landmark_index_.find(id);
  return found != landmark_index_.end() ? &landmarks_[found->second] : nullptr;
}

std::optional<SE3d> MapSnapshot::T_cam_world(KeyframeId id) const {
  if (const KeyframeEntry* living = keyframe(id)) return living->T_cam_world;
  if (const RetiredEntry* gone = findById(retired_, id)) return gone->T_cam_world;
  return std::nullopt;
}

std::optional<double> MapSnapshot::scale(KeyframeId id) const {
  if (const KeyframeEntry* living = keyframe(id)) return living->scale;
  if (const RetiredEntry* gone = findById(retired_, id)) return gone->scale;
  return std::nullopt;
}

}  // namespace glide
