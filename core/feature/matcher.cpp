#include "feature/matcher.h"

#include "feature/descriptor.h"
#include "feature/orientation_filter.h"

#include <algorithm>
#include <cstddef>
#include <limits>

namespace glide {
namespace {

constexpr int kFar = std::numeric_limits<int>::max();

/// The nearest of some candidates, and the second nearest of the same level.
struct Nearest {
  int index = -1;
  int distance = kFar;
  int rival_distance = kFar;

  bool passes(const MatchOptions& options) const {
    return index >= 0 && distance <= options.max_distance &&
           (rival_distance == kFar || distance < options.ratio * rival_distance);
  }
};

/// Distances from one descriptor to candidates, with reused buffers.
class Search {
 public:
  explicit Search(const FeatureSet& features) : features_(features) {}

  std::vector<int>& candidates() { return candidates_; }
  std::span<const int> distances() const { return distances_; }

  Nearest run(const Descriptor& descriptor) {
    distances_.resize(candidates_.size());
    descriptorDistances(descriptor, features_.descriptors(), candidates_, distances_);
    Nearest nearest;
    for (std::size_t k = 0; k < candidates_.size(); ++k) {
      if (distances_[k] < nearest.distance) nearest = {candidates_[k], distances_[k], kFar};
    }
    if (nearest.index < 0) return nearest;
    const int level = levelOf(nearest.index);
    for (std::size_t k = 0; k < candidates_.size(); ++k) {
      if (candidates_[k] == nearest.index || levelOf(candidates_[k]) != level) continue;
      nearest.rival_distance = std::min(nearest.rival_distance, distances_[k]);
    }
    return nearest;
  }

 private:
  int levelOf(int index) const { return features_.feature(static_cast<std::size_t>(index)).level; }

  const FeatureSet& features_;
  std::vector<int> candidates_, distances_;
};

/// For each feature the closest of those that asked for it.
class Claims {
 public:
  explicit Claims(std::size_t features) : owner_(features, {-1, kFar}) {}

  void claim(int feature, int by, int distance) {
    Owner& owner = owner_[static_cast<std::size_t>(feature)];
    if (distance < owner.distance) owner = {by, distance};
  }
  bool holds(int feature, int by) const {
    return owner_[static_cast<std::size_t>(feature)].by == by;
  }

 private:
  struct Owner {
    int by, distance;
  };
  std::vector<Owner> owner_;
};

/// Nearest neighbours of features of `a` among those candidates of `b` that `fill` offers, kept
/// where they are mutual.
template <class Fill>
std::vector<Match> mutualBest(const FeatureSet& a,
                              std::span<const int> indices_a,
                              const FeatureSet& b,
                              const MatchOptions& options,
                              const Fill& fill) {
  std::vector<Match> matches;
  Claims claims(b.size());
  Search search(b);
  for (const int i : indices_a) {
    fill(i, &search.candidates());
    const Nearest nearest = search.run(a.descriptor(static_cast<std::size_t>(i)));
    for (std::size_t k = 0; k < search.candidates().size(); ++k) {
      claims.claim(search.candidates()[k], i, search.distances()[k]);
    }
    if (nearest.passes(options)) matches.push_back({i, nearest.index, nearest.distance});
  }
  const auto lost = [&](const Match& m) { return !claims.holds(m.b, m.a); };
  matches.erase(std::remove_if(matches.begin(), matches.end(), lost), matches.end());
  if (options.check_orientation) keepConsistentRotation(a, b, &matches);
  return matches;
}

}  // namespace

std::vector<Match> matchByProjection(std::span<const ProjectedTarget> targets,
                                     const FeatureSet& features,
                                     const std::vector<bool>& taken,
                                     const MatchOptions& options) {
  std::vector<Match> matches;
  std::vector<int> target_of_match;
  Claims claims(features.size());
  Search search(features);
  const auto isTaken = [&](int i) { return !taken.empty() && taken[static_cast<std::size_t>(i)]; };
  for (std::size_t t = 0; t < targets.size(); ++t) {
    const ProjectedTarget& target = targets[t];
    std::vector<int>& found = search.candidates();
    features.query({target.uv, target.radius_px, target.min_level, target.max_level}, &found);
    found.erase(std::remove_if(found.begin(), found.end(), isTaken), found.end());
    const Nearest nearest = search.run(target.descriptor);
    if (!nearest.passes(options)) continue;
    claims.claim(nearest.index, static_cast<int>(t), nearest.distance);
    matches.push_back({target.id, nearest.index, nearest.distance});
    target_of_match.push_back(static_cast<int>(t));
  }
  std::vector<Match> kept;
  for (std::size_t m = 0; m < matches.size(); ++m) {
    if (claims.holds(matches[m].b, target_of_match[m])) kept.push_back(matches[m]);
  }
  return kept;
}

std::vector<Match> matchInWindow(const FeatureSet& a,
                                 std::span<const Vec2f> guess_uv,
                                 const FeatureSet& b,
                                 const WindowOptions& options) {
  std::vector<int> indices_a;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (a.feature(i).level <= options.max_level) indices_a.push_back(static_cast<int>(i));
  }
  const auto window = [&](int i, std::vector<int>* found) {
    const std::size_t index = static_cast<std::size_t>(i);
    const int level = a.feature(index).level;
    const int coarsest = std::min(level + 1, options.max_level);
    b.query({guess_uv[index], options.radius_px, level - 1, coarsest}, found);
  };
  return mutualBest(a, indices_a, b, options.match, window);
}

std::vector<Match> matchBruteForce(const FeatureSet& a,
                                   std::span<const int> subset_a,
                                   const FeatureSet& b,
                                   const MatchOptions& options) {
  std::vector<int> indices_a(subset_a.begin(), subset_a.end());
  if (indices_a.empty()) {
    for (std::size_t i = 0; i < a.size(); ++i) indices_a.push_back(static_cast<int>(i));
  }
  const auto everything = [&](int, std::vector<int>* found) {
    if (found->size() == b.size()) return;
    found->clear();
    for (std::size_t i = 0; i < b.size(); ++i) found->push_back(static_cast<int>(i));
  };
  return mutualBest(a, indices_a, b, options, everything);
}

}  // namespace glide
