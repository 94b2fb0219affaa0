#include "loop/loop_detector.h"

#include <algorithm>
#include <map>
#include <utility>

namespace glide {
namespace {

// Chains of covisible keyframes up to this long are no loop: local mapping looks after them.
constexpr int kConnectedSteps = 2;
// Of the score of the covisible keyframe that looks most like the new one: places seen again from
// elsewhere score this much, unrelated ones a tenth of it.
constexpr double kMinScoreShare = 0.1;
// Keyframes in a row that must lead to a place, and how many of them may fail to.
constexpr int kMinAgreeing = 3;
constexpr int kMaxMissed = 1;
// Places that are looked into: the best, and rivals that show whether it is the only one.
constexpr std::size_t kMaxPlaces = 3;
// Covisible keyframes that make up a place and add their scores to it.
constexpr std::size_t kPlaceNeighbors = 10;

bool overlap(const std::set<KeyframeId>& a, const std::set<KeyframeId>& b) {
  return std::any_of(a.begin(), a.end(), [&](KeyframeId id) { return b.count(id) > 0; });
}

/// Best score among keyframes that share landmarks with this one.
double covisibleScore(const MapSnapshot::KeyframeEntry& keyframe,
                      const std::vector<PlaceMatch>& matches) {
  std::set<KeyframeId> neighbors;
  for (const CovisibleKeyframe& neighbor : keyframe.neighbors) neighbors.insert(neighbor.id);
  double best = 0.0;
  for (const PlaceMatch& match : matches) {
    if (neighbors.count(match.keyframe) > 0) best = std::max(best, match.score);
  }
  return best;
}

}  // namespace

std::vector<KeyframeId> LoopDetector::detect(const MapSnapshot::KeyframeEntry& keyframe,
                                             const MapSnapshot& map,
                                             const KeyframeGraph& graph,
                                             const PlaceIndex& index) {
  std::vector<PlaceMatch> matches = index.query(*keyframe.features, static_cast<int>(index.size()));
  const double min_score = kMinScoreShare * covisibleScore(keyframe, matches);
  const std::set<KeyframeId> connected = graph.within(keyframe.id, kConnectedSteps);
  const auto isUnfit = [&](const PlaceMatch& match) {
    return match.score < min_score || connected.count(match.keyframe) > 0 ||
           keyframe.id < match.keyframe || map.keyframe(match.keyframe) == nullptr;
  };
  matches.erase(std::remove_if(matches.begin(), matches.end(), isUnfit), matches.end());
  carryOn(groupsOf(matches, map));

  std::vector<KeyframeId> trusted;
  for (const Group& group : groups_) {
    if (group.missed > 0 || group.agreeing < kMinAgreeing) continue;
    if (trusted.size() < kMaxPlaces) trusted.push_back(group.best);
  }
  return trusted;
}

std::vector<LoopDetector::Group> LoopDetector::groupsOf(const std::vector<PlaceMatch>& matches,
                                                        const MapSnapshot& map) {
  std::map<KeyframeId, double> scores;
  for (const PlaceMatch& match : matches) scores[match.keyframe] = match.score;
  std::set<KeyframeId> taken;
  std::vector<Group> groups;
  for (const PlaceMatch& match : matches) {  // best first
    if (taken.count(match.keyframe) > 0) continue;
    Group group;
    group.best = match.keyframe;
    const std::vector<KeyframeId> place =
        placeOf(*map.keyframe(match.keyframe), 1 + kPlaceNeighbors);
    group.keyframes = {place.begin(), place.end()};
    for (const KeyframeId id : group.keyframes) {
      const auto score = scores.find(id);
      if (score != scores.end() && taken.insert(id).second) group.score += score->second;
    }
    groups.push_back(std::move(group));
  }
  std::stable_sort(groups.begin(), groups.end(), [](const Group& a, const Group& b) {
    return a.score > b.score;
  });
  return groups;
}

void LoopDetector::carryOn(std::vector<Group> found) {
  for (Group& group : found) {
    for (const Group& before : groups_) {
      if (!overlap(before.keyframes, group.keyframes)) continue;
      group.agreeing = std::max(group.agreeing, before.agreeing + 1);
    }
  }
  for (Group& before : groups_) {
    const bool goes_on = std::any_of(found.begin(), found.end(), [&](const Group& group) {
      return overlap(before.keyframes, group.keyframes);
    });
    if (goes_on || ++before.missed > kMaxMissed) continue;
    found.push_back(std::move(before));
  }
  groups_ = std::move(found);
}

}  // namespace glide
