#include "map/map.h"

#include "map/landmark_summary.h"

#include <algorithm>
#include <cassert>
#include <iterator>
#include <utility>

namespace glide {
namespace {

// One view does not locate a point.
constexpr std::size_t kMinObservations = 2;
// The newest views show what the next one will; the medoid's cost is quadratic.
constexpr std::size_t kMaxDescriptors = 10;

bool precedes(const Observation& observation, KeyframeId id) { return observation.keyframe < id; }

}  // namespace

std::vector<LandmarkId> Map::landmarkIds() const {
  std::vector<LandmarkId> ids;
  ids.reserve(landmarks_.size());
  for (const LandmarkId id : created_) {
    if (landmarks_.count(id) > 0) ids.push_back(id);
  }
  return ids;
}

const Keyframe* Map::keyframe(KeyframeId id) const {
  const auto found = keyframes_.find(id);
  return found != keyframes_.end() ? &found->second : nullptr;
}

const Landmark* Map::landmark(LandmarkId id) const {
  const auto found = landmarks_.find(id);
  return found != landmarks_.end() ? &found->second : nullptr;
}

Landmark* Map::find(LandmarkId id) {
  const auto found = landmarks_.find(id);
  return found != landmarks_.end() ? &found->second : nullptr;
}

std::optional<SE3d> Map::T_cam_world(KeyframeId id) const {
  if (const Keyframe* living = keyframe(id)) return living->T_cam_world;
  const auto gone = retired_.find(id);
  if (gone == retired_.end()) return std::nullopt;
  return gone->second.T_cam_parent * keyframes_.at(gone->second.parent).T_cam_world;
}

std::optional<double> Map::scale(KeyframeId id) const {
  if (const Keyframe* living = keyframe(id)) return living->scale;
  const auto gone = retired_.find(id);
  if (gone == retired_.end()) return std::nullopt;
  return gone->second.scale;
}

bool Map::addKeyframe(Keyframe keyframe) {
  if (keyframes_.count(keyframe.id) > 0 || retired_.count(keyframe.id) > 0) return false;
  keyframe.landmarks.assign(keyframe.features->size(), kNoLandmark);
  const KeyframeId id = keyframe.id;
  keyframes_.emplace(id, std::move(keyframe));
  return true;
}

LandmarkId Map::addLandmark(const Vec3d& p_world, KeyframeId first_keyframe) {
  Landmark landmark;
  landmark.id = next_landmark_;
  landmark.p_world = p_world;
  landmark.first_keyframe = first_keyframe;
  ++next_landmark_.value;
  created_.push_back(landmark.id);
  const LandmarkId id = landmark.id;
  landmarks_.emplace(id, std::move(landmark));
  return id;
}

bool Map::addObservation(LandmarkId id, const Observation& observation) {
  Landmark* landmark = find(id);
  const auto keyframe = keyframes_.find(observation.keyframe);
  if (landmark == nullptr || keyframe == keyframes_.end()) return false;
  std::vector<LandmarkId>& slots = keyframe->second.landmarks;
  const auto slot = static_cast<std::size_t>(observation.feature);
  if (observation.feature < 0 || slot >= slots.size() || slots[slot] != kNoLandmark) return false;
  std::vector<Observation>& seen = landmark->observations;
  const auto place = std::lower_bound(seen.begin(), seen.end(), observation.keyframe, precedes);
  if (place != seen.end() && place->keyframe == observation.keyframe) return false;

  for (const Observation& other : seen) {
    covisibility_.change(observation.keyframe, other.keyframe, 1);
  }
  const std::uint8_t level = keyframe->second.features->feature(slot).level;
  seen.insert(place, {observation.keyframe, observation.feature, level});
  slots[slot] = id;
  changed_.push_back(id);
  return true;
}

bool Map::restoreLandmark(Landmark landmark) {
  const LandmarkId id = landmark.id;
  if (id == kNoLandmark || (!created_.empty() && !(created_.back() < id))) return false;
  const std::vector<Observation> observations = std::move(landmark.observations);
  landmark.observations.clear();
  const std::size_t unchanged = changed_.size();
  landmarks_.emplace(id, std::move(landmark));
  bool is_possible = true;
  for (const Observation& observation : observations) {
    is_possible = is_possible && addObservation(id, observation);
  }
  if (!is_possible) removeLandmark(id);
  changed_.resize(unchanged);  // the summary is that of the observations
  if (!is_possible) return false;
  created_.push_back(id);
  next_landmark_.value = std::max(next_landmark_.value, id.value + 1);
  return true;
}

bool Map::restoreRetired(const RetiredKeyframe& keyframe) {
  if (keyframes_.count(keyframe.id) > 0 || keyframes_.count(keyframe.parent) == 0) return false;
  return retired_.emplace(keyframe.id, keyframe).second;
}

void Map::detach(Landmark* landmark, std::vector<Observation>::iterator observation) {
  const Observation gone = *observation;
  landmark->observations.erase(observation);
  for (const Observation& other : landmark->observations) {
    covisibility_.change(gone.keyframe, other.keyframe, -1);
  }
  keyframes_.at(gone.keyframe).landmarks[static_cast<std::size_t>(gone.feature)] = kNoLandmark;
  changed_.push_back(landmark->id);
}

void Map::removeObservation(LandmarkId id, KeyframeId keyframe) {
  Landmark* landmark = find(id);
  if (landmark == nullptr) return;
  std::vector<Observation>& seen = landmark->observations;
  const auto place = std::lower_bound(seen.begin(), seen.end(), keyframe, precedes);
  if (place == seen.end() || place->keyframe != keyframe) return;
  detach(landmark, place);
  if (seen.size() < kMinObservations) removeLandmark(id);
}

void Map::removeLandmark(LandmarkId id) {
  Landmark* landmark = find(id);
  if (landmark == nullptr) return;
  while (!landmark->observations.empty()) {
    detach(landmark, std::prev(landmark->observations.end()));
  }
  landmarks_.erase(id);
}

void Map::replaceLandmark(LandmarkId id, LandmarkId by) {
  const Landmark* old = landmark(id);
  Landmark* keeper = find(by);
  if (old == nullptr || keeper == nullptr || id == by) return;
  const std::vector<Observation> observations = old->observations;
  keeper->visible_count += old->visible_count;
  keeper->found_count += old->found_count;
  removeLandmark(id);
  for (const Observation& observation : observations) addObservation(by, observation);
}

KeyframeId Map::parentFor(KeyframeId id) const {
  const std::vector<CovisibleKeyframe> best = covisibility_.neighbors(id, 1);
  if (!best.empty()) return best.front().id;
  const auto place = keyframes_.find(id);
  return place == keyframes_.begin() ? std::next(place)->first : std::prev(place)->first;
}

bool Map::retireKeyframe(KeyframeId id) {
  const Keyframe* leaving = keyframe(id);
  if (leaving == nullptr || keyframes_.size() < 2) return false;
  const KeyframeId parent = parentFor(id);
  const SE3d T_cam_parent = leaving->T_cam_world * keyframes_.at(parent).T_cam_world.inverse();
  const std::vector<LandmarkId> landmarks = leaving->landmarks;
  for (const LandmarkId landmark : landmarks) {
    if (landmark != kNoLandmark) removeObservation(landmark, id);
  }
  for (auto& [child_id, child] : retired_) {  // so that parents are always living
    if (child.parent != id) continue;
    child.parent = parent;
    child.T_cam_parent = child.T_cam_parent * T_cam_parent;
  }
  for (LoopEdge& edge : loops_) {
    if (edge.newer == id) edge.newer = parent;
    if (edge.older == id) edge.older = parent;
  }
  retired_.emplace(id, RetiredKeyframe{id, leaving->t_ns, parent, T_cam_parent, leaving->scale});
  keyframes_.erase(id);
  return true;
}

void Map::clear() {
  keyframes_.clear();
  retired_.clear();
  landmarks_.clear();
  created_.clear();
  changed_.clear();
  covisibility_ = Covisibility{};
  loops_.clear();
}

void Map::setPose(KeyframeId id, const SE3d& T_cam_world) {
  const auto keyframe = keyframes_.find(id);
  if (keyframe != keyframes_.end()) keyframe->second.T_cam_world = T_cam_world;
}

void Map::moveKeyframe(const KeyframeMove& move) {
  const auto found = keyframes_.find(move.id);
  if (found == keyframes_.end()) return;
  Keyframe& keyframe = found->second;
  const SE3d& old = keyframe.T_cam_world;
  const Sim3d S_old_new = move.S_new_old.inverse();
  const double grown = move.S_new_old.s;
  // Old world to camera, from the new world, in the camera's new unit.
  keyframe.T_cam_world = {old.q * S_old_new.q, grown * (old.q * S_old_new.t + old.t)};
  keyframe.scale *= grown;
  for (auto& [id, child] : retired_) {
    if (child.parent != move.id) continue;
    child.T_cam_parent.t *= grown;
    child.scale *= grown;
  }
}

void Map::moveFeatures(KeyframeId id, std::span<const FeatureMove> moves) {
  const auto keyframe = keyframes_.find(id);
  if (keyframe == keyframes_.end() || moves.empty()) return;
  keyframe->second.features =
      std::make_shared<const FeatureSet>(keyframe->second.features->withMoved(moves));
}

void Map::setPosition(LandmarkId id, const Vec3d& p_world) {
  if (Landmark* landmark = find(id)) landmark->p_world = p_world;
}

void Map::countSighting(const LandmarkSighting& sighting) {
  Landmark* landmark = find(sighting.id);
  if (landmark == nullptr) return;
  landmark->visible_count += sighting.visible;
  landmark->found_count += sighting.found;
}

void Map::refreshGeometry(LandmarkId id) {
  Landmark* landmark = find(id);
  if (landmark == nullptr || landmark->observations.empty()) return;
  std::vector<LandmarkSight> sights;
  sights.reserve(landmark->observations.size());
  for (const Observation& observation : landmark->observations) {
    const SE3d& T_cam_world = keyframes_.at(observation.keyframe).T_cam_world;
    sights.push_back({T_cam_world.inverse().t, observation.level});
  }
  const ViewingRange range = viewingRange(landmark->p_world, sights, levels_);
  landmark->normal = range.normal;
  landmark->min_distance = range.min_distance;
  landmark->max_distance = range.max_distance;
}

void Map::refreshDescriptor(Landmark* landmark) const {
  const std::vector<Observation>& seen = landmark->observations;
  const std::size_t first = seen.size() - std::min(seen.size(), kMaxDescriptors);
  std::vector<const Descriptor*> descriptors;
  descriptors.reserve(seen.size() - first);
  for (std::size_t i = first; i < seen.size(); ++i) {
    const Observation& observation = seen[i];
    const FeatureSet& features = *keyframes_.at(observation.keyframe).features;
    descriptors.push_back(&features.descriptor(static_cast<std::size_t>(observation.feature)));
  }
  if (!descriptors.empty()) landmark->descriptor = *descriptors[medoid(descriptors)];
}

void Map::refreshChanged() {
  std::sort(changed_.begin(), changed_.end());
  changed_.erase(std::unique(changed_.begin(), changed_.end()), changed_.end());
  for (const LandmarkId id : changed_) {
    Landmark* landmark = find(id);
    if (landmark == nullptr) continue;
    refreshDescriptor(landmark);
    refreshGeometry(id);
  }
  changed_.clear();
  // Ids of the dead are not needed any more.
  created_.erase(std::remove_if(created_.begin(),
                                created_.end(),
                                [this](LandmarkId id) { return landmarks_.count(id) == 0; }),
                 created_.end());
}

}  // namespace glide
