#include "map/place_index.h"

#include "map/descriptor_tree.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace glide {
namespace {

using Owner = DescriptorTree::Owner;

// Looks of one corner in two views differ by 20 to 50 bits; of one million strange ones the nearest
// differs by more than 40. Below both, because a missed vote costs less than a wrong one.
constexpr int kMaxDistance = 36;

constexpr KeyframeId kFree{~std::uint64_t{0}};

}  // namespace

struct PlaceIndex::Impl {
  DescriptorTree tree;
  std::map<KeyframeId, Owner> owner_of;
  std::vector<KeyframeId> keyframe_of;  // by owner; kFree where none
  std::vector<Owner> free;              // owners to be used again

  Owner makeOwner(KeyframeId id) {
    if (free.empty()) {
      keyframe_of.push_back(id);
      return static_cast<Owner>(keyframe_of.size() - 1);
    }
    const Owner owner = free.back();
    free.pop_back();
    keyframe_of[owner] = id;
    return owner;
  }

  /// How much a feature says that looks like one in `keyframes` keyframes (an inverse document
  /// frequency): nothing found counts like one, so that new things in view lower the score.
  double rarity(std::size_t keyframes) const {
    const double n = static_cast<double>(std::max<std::size_t>(keyframes, 1));
    return std::log1p(static_cast<double>(owner_of.size()) / n);
  }
};

PlaceIndex::PlaceIndex() : impl_(std::make_unique<Impl>()) {}
PlaceIndex::~PlaceIndex() = default;
PlaceIndex::PlaceIndex(PlaceIndex&&) noexcept = default;
PlaceIndex& PlaceIndex::operator=(PlaceIndex&&) noexcept = default;

void PlaceIndex::add(KeyframeId id, const FeatureSet& features) {
  if (contains(id)) return;
  const Owner owner = impl_->makeOwner(id);
  impl_->owner_of[id] = owner;
  for (const Descriptor& descriptor : features.descriptors()) impl_->tree.insert(descriptor, owner);
}

void PlaceIndex::remove(KeyframeId id) {
  const auto found = impl_->owner_of.find(id);
  if (found == impl_->owner_of.end()) return;
  impl_->tree.remove(found->second);
  impl_->keyframe_of[found->second] = kFree;
  impl_->free.push_back(found->second);
  impl_->owner_of.erase(found);
}

void PlaceIndex::clear() { *impl_ = Impl(); }

bool PlaceIndex::contains(KeyframeId id) const { return impl_->owner_of.count(id) > 0; }

std::size_t PlaceIndex::size() const { return impl_->owner_of.size(); }

std::vector<PlaceMatch> PlaceIndex::query(const FeatureSet& features, int max_results) const {
  std::vector<PlaceMatch> by_owner;
  for (const KeyframeId id : impl_->keyframe_of) by_owner.push_back({id, 0, 0.0});
  std::vector<Owner> voted;
  double total = 0.0;
  for (const Descriptor& descriptor : features.descriptors()) {
    voted.clear();
    impl_->tree.search(descriptor, kMaxDistance, &voted);
    std::sort(voted.begin(), voted.end());
    voted.erase(std::unique(voted.begin(), voted.end()), voted.end());
    const double weight = impl_->rarity(voted.size());
    total += weight;
    for (const Owner owner : voted) {
      ++by_owner[owner].votes;
      by_owner[owner].score += weight;
    }
  }
  const auto has_no_vote = [](const PlaceMatch& match) { return match.votes == 0; };
  by_owner.erase(std::remove_if(by_owner.begin(), by_owner.end(), has_no_vote), by_owner.end());
  for (PlaceMatch& match : by_owner) match.score /= total;
  std::sort(by_owner.begin(), by_owner.end(), [](const PlaceMatch& a, const PlaceMatch& b) {
    return a.score != b.score ? a.score > b.score : a.keyframe < b.keyframe;
  });
  const std::size_t wanted = static_cast<std::size_t>(std::max(max_results, 0));
  if (by_owner.size() > wanted) by_owner.resize(wanted);
  return by_owner;
}

}  // namespace glide
