#pragma once

#include "feature/feature_set.h"

#include "base/ids.h"

#include <cstddef>
#include <memory>
#include <vector>

namespace glide {

/// A keyframe that resembles the image asked about.
struct PlaceMatch {
  KeyframeId keyframe;
  int votes = 0;       ///< features of the query that resemble one of the keyframe's
  double score = 0.0;  ///< 0..1, share of the query's features that voted, weighted by rarity
};

/// Finds keyframes by what they look like, without a vocabulary: an index over the descriptors of
/// all keyframes that grows and shrinks with the map. Owned by one thread.
class PlaceIndex {
 public:
  PlaceIndex();
  ~PlaceIndex();
  PlaceIndex(PlaceIndex&&) noexcept;
  PlaceIndex& operator=(PlaceIndex&&) noexcept;

  /// Ignored when the keyframe is there already.
  void add(KeyframeId id, const FeatureSet& features);
  /// Ignored when the keyframe is not there.
  void remove(KeyframeId id);
  void clear();

  bool contains(KeyframeId id) const;
  std::size_t size() const;  ///< keyframes

  /// At most `max_results` keyframes, best score first; ties by older id.
  std::vector<PlaceMatch> query(const FeatureSet& features, int max_results) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace glide
