#pragma once

#include "feature/feature_set.h"

#include <span>
#include <vector>

namespace glide {

/// Feature `a` of the first set corresponds to feature `b` of the second.
struct Match {
  int a = 0;
  int b = 0;
  int distance = 0;  ///< bits
};

struct MatchOptions {
  int max_distance = 64;  ///< bits
  double ratio = 0.8;     ///< best must be below ratio * second best
  bool check_orientation =
      true;  ///< keep only matches that agree on the rotation between the images
};

/// Something that is expected at a pixel: a projected landmark.
struct ProjectedTarget {
  int id = 0;  ///< caller's index
  Vec2f uv;    ///< px
  float radius_px = 0.0F;
  int min_level = 0, max_level = 0;
  Descriptor descriptor{};
};

/// For each target the best feature in its window; a feature is given to at most one target (the
/// closer descriptor wins). `a` = target.id, `b` = feature index. `taken[b]` true excludes a
/// feature; empty means none is excluded. The ratio test applies only between features of the same
/// level.
std::vector<Match> matchByProjection(std::span<const ProjectedTarget> targets,
                                     const FeatureSet& features,
                                     const std::vector<bool>& taken,
                                     const MatchOptions& options);

/// Features of `a` (all levels <= max_level) to features of `b` within `radius_px` of
/// `guess_uv[i]`: initialisation. Mutual best.
struct WindowOptions {
  MatchOptions match;
  float radius_px = 100.0F;
  int max_level = 0;
};
std::vector<Match> matchInWindow(const FeatureSet& a,
                                 std::span<const Vec2f> guess_uv,
                                 const FeatureSet& b,
                                 const WindowOptions& options);

/// Mutual best over subsets of indices without geometry (recovery); empty subset means all.
std::vector<Match> matchBruteForce(const FeatureSet& a,
                                   std::span<const int> subset_a,
                                   const FeatureSet& b,
                                   const MatchOptions& options);

}  // namespace glide
