#include "map/map_correction.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <optional>
#include <unordered_map>
#include <vector>

namespace glide {
namespace {

/// S_new_old of the world around living keyframes.
using Moves = std::map<KeyframeId, Sim3d>;

Moves movesOfLiving(const std::vector<KeyframeMove>& keyframes, const Map& map) {
  Moves moves;
  for (const KeyframeMove& move : keyframes) {
    if (map.keyframe(move.id) != nullptr) moves.emplace(move.id, move.S_new_old);
  }
  return moves;
}

/// The move of the best covisible keyframe that has one.
std::optional<Sim3d> covisibleMove(const Map& map, KeyframeId id, const Moves& moves) {
  for (const CovisibleKeyframe& neighbor : map.covisibility().neighbors(id, 1)) {
    const auto found = moves.find(neighbor.id);
    if (found != moves.end()) return found->second;
  }
  return std::nullopt;
}

/// The move of the keyframe next to `id` in time, the older one first. `moves` is not empty.
Sim3d adjacentMove(KeyframeId id, const Moves& moves) {
  const auto after = moves.lower_bound(id);
  return after != moves.begin() ? std::prev(after)->second : after->second;
}

/// Gives every living keyframe a move: that of its covisible keyframes, whose moves may themselves
/// be handed on, else of its neighbour in time.
void spread(const Map& map, Moves* moves) {
  if (moves->empty()) return;
  std::size_t known = 0;
  while (known != moves->size()) {  // until nothing more is reached
    known = moves->size();
    for (const auto& [id, keyframe] : map.keyframes()) {
      if (moves->count(id) > 0) continue;
      if (const auto move = covisibleMove(map, id, *moves)) moves->emplace(id, *move);
    }
  }
  for (const auto& [id, keyframe] : map.keyframes()) {
    if (moves->count(id) == 0) moves->emplace(id, adjacentMove(id, *moves));
  }
}

void moveKeyframes(const Moves& moves, Map* map) {
  for (const auto& [id, S_new_old] : moves) map->moveKeyframe({id, S_new_old});
}

/// A landmark goes where the first keyframe goes that sees it.
void moveLandmark(LandmarkId id, const Moves& moves, Map* map) {
  const Landmark& landmark = *map->landmark(id);
  for (const Observation& observation : landmark.observations) {
    const auto move = moves.find(observation.keyframe);
    if (move == moves.end()) continue;
    map->setPosition(id, move->second * landmark.p_world);
    return;
  }
}

void refreshAll(Map* map) {
  map->refreshChanged();
  for (const LandmarkId id : map->landmarkIds()) map->refreshGeometry(id);
}

/// Which landmark one has become part of; landmarks without an entry are themselves.
using Successors = std::unordered_map<LandmarkId, LandmarkId>;

LandmarkId lastOf(const Successors& successors, LandmarkId id) {
  for (auto next = successors.find(id); next != successors.end(); next = successors.find(id)) {
    id = next->second;
  }
  return id;
}

Successors chain(const std::vector<LoopCorrection::SamePoint>& same) {
  Successors successors;
  for (const LoopCorrection::SamePoint& pair : same) {
    const LandmarkId gone = lastOf(successors, pair.gone);
    const LandmarkId kept = lastOf(successors, pair.kept);
    if (gone != kept) successors.emplace(gone, kept);
  }
  return successors;
}

/// Fuses each chain of landmarks into its last one, or when that has been removed meanwhile, into
/// the first that lives.
void fuse(const std::vector<LoopCorrection::SamePoint>& same, Map* map) {
  const Successors successors = chain(same);
  Successors keepers;  // by the last landmark of the chain
  for (const LoopCorrection::SamePoint& pair : same) {
    for (const LandmarkId id : {pair.kept, pair.gone}) {
      if (map->landmark(id) == nullptr) continue;
      const LandmarkId last = lastOf(successors, id);
      const LandmarkId candidate = map->landmark(last) != nullptr ? last : id;
      map->replaceLandmark(id, keepers.emplace(last, candidate).first->second);
    }
  }
}

/// The keyframe itself or the one that stands for it.
std::optional<KeyframeId> living(const Map& map, KeyframeId id) {
  if (map.keyframe(id) != nullptr) return id;
  const auto retired = map.retired().find(id);
  if (retired == map.retired().end()) return std::nullopt;
  return retired->second.parent;
}

void rememberEdge(const LoopEdge& edge, Map* map) {
  const std::optional<KeyframeId> newer = living(*map, edge.newer);
  const std::optional<KeyframeId> older = living(*map, edge.older);
  if (newer && older && *newer != *older) map->addLoopEdge({*newer, *older});
}

}  // namespace

void applyCorrection(const LoopCorrection& correction, Map* map) {
  Moves moves = movesOfLiving(correction.keyframes, *map);
  spread(*map, &moves);
  moveKeyframes(moves, map);
  for (const LandmarkId id : map->landmarkIds()) moveLandmark(id, moves, map);
  fuse(correction.same, map);
  rememberEdge(correction.edge, map);
  refreshAll(map);
}

void applyAdjustment(const GlobalAdjustment& adjustment, Map* map) {
  std::unordered_map<LandmarkId, Vec3d> shifted;
  for (const GlobalAdjustment::LandmarkShift& known : adjustment.landmarks) {
    const Landmark* landmark = map->landmark(known.id);
    if (landmark != nullptr) shifted[known.id] = landmark->p_world + known.shift;
  }
  Moves moves = movesOfLiving(adjustment.keyframes, *map);
  spread(*map, &moves);
  moveKeyframes(moves, map);
  for (const LandmarkId id : map->landmarkIds()) {
    const auto known = shifted.find(id);
    if (known != shifted.end()) {
      map->setPosition(id, known->second);
    } else {
      moveLandmark(id, moves, map);
    }
  }
  refreshAll(map);
}

}  // namespace glide
