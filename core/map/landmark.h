#pragma once

#include "feature/feature_set.h"

#include "base/ids.h"
#include "geometry/eigen_types.h"

#include <array>
#include <cstdint>
#include <vector>

namespace glide {

/// Feature `feature` of keyframe `keyframe` sees the landmark.
struct Observation {
  KeyframeId keyframe;
  int feature = 0;
  std::uint8_t level = 0;  ///< of the feature; Map fills it in
};

/// A map point. Owned by Map.
///
/// Scale rule. A corner of physical size z is detected at level l from the distance d when
/// z ~ d * factor^l, hence d * factor^l is the same for all its observations. Their geometric mean
/// is `max_distance`, where the corner would be found at level 0; `min_distance` is where it would
/// be found at the coarsest level: max_distance / factor^(count - 1). predictedLevel() inverts the
/// rule.
struct Landmark {
  LandmarkId id;
  Vec3d p_world = Vec3d::Zero();
  Vec3d normal = Vec3d::Zero();  ///< mean unit direction from the observing cameras to the point
  Descriptor descriptor{};       ///< of the observation closest to all others
  double min_distance = 0.0,
         max_distance = 0.0;              ///< where scale-space detection can find it, scene units
  std::vector<Observation> observations;  ///< at most one per keyframe, ascending keyframe
  KeyframeId first_keyframe;
  int visible_count = 1;  ///< frames that expected to see it
  int found_count = 1;    ///< frames that matched it
};

/// The extractor's scale levels. A feature of level l has the size and the standard deviation of
/// factor^l level-0 pixels.
class ScaleLevels {
 public:
  static constexpr int kMaxLevels = 12;  ///< what Config::Features::levels allows

  /// `factor` > 1, 1 <= `count` <= kMaxLevels.
  ScaleLevels(double factor, int count);

  double factor() const { return factor_; }
  int count() const { return count_; }

  /// factor^level; levels outside of the pyramid count as the nearest inside.
  double scale(int level) const;

 private:
  double factor_ = 1.2;
  int count_ = 8;
  std::array<double, kMaxLevels> scale_{};
};

/// Level at which a landmark with this `max_distance` is expected from `distance`:
/// ceil(log(max_distance / distance) / log(factor)), clamped to the pyramid. Detection finds it at
/// this level or the one below (finer).
int predictedLevel(const ScaleLevels& levels, double max_distance, double distance);

}  // namespace glide
