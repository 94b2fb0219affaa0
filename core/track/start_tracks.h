#pragma once

#include "feature/matcher.h"

#include "geometry/camera_model.h"

#include <memory>
#include <span>
#include <vector>

namespace glide {

/// The features of a first view, followed from frame to frame: each is looked for where the motion
/// of its surroundings takes it. Descriptors alone would hop to the next window or brick of a
/// facade as soon as the right one is missed once, and a map started from such matches fits them.
class StartTracks {
 public:
  explicit StartTracks(const CameraModel& camera);

  void start(std::shared_ptr<const FeatureSet> first);
  void reset() { first_.reset(); }

  /// Matches of the first view's features (`a`) in the next frame.
  std::vector<Match> follow(const FeatureSet& now);

 private:
  std::vector<Match> find(const FeatureSet& now, float window_px) const;
  /// Moves what is expected by the matches' motion, each feature with its surroundings.
  void moveAlong(const FeatureSet& now, std::span<const Match> matches);
  std::size_t cellOf(const Vec2f& uv) const;

  int width_, height_;  ///< px
  std::shared_ptr<const FeatureSet> first_;
  std::vector<Vec2f> expected_uv_;  ///< per feature of the first view, in the frame followed last
};

}  // namespace glide
