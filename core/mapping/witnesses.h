#pragma once

#include "mapping/mapper_state.h"

#include "map/keyframe.h"

#include <vector>

namespace glide {

/// The keyframes that were taken between two others, asked whether they see a point, too. Repeated
/// structure that is matched one repetition further, because the camera moved by about one, gives a
/// point that fits both views; from between it would be seen where nothing like it is.
/// Borrows the map: use it before the map changes.
class Witnesses {
 public:
  /// Of the pair `a`, `b`: neighbours of `a` whose ids lie between.
  Witnesses(const MapperState& state, const Keyframe& a, const Keyframe& b);

  /// At least half of the witnesses that should see the point, which feature `feature` of `a` is an
  /// image of, have a feature like it there. True when none should see it.
  bool agree(const Vec3d& p_world, int feature) const;

 private:
  bool sees(const Keyframe& witness, const Vec3d& p_world, const Descriptor& descriptor) const;

  const MapperState& state_;
  const Keyframe& a_;
  std::vector<const Keyframe*> between_;
};

}  // namespace glide
