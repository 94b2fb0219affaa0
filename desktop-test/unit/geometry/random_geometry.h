#pragma once

#include "geometry/lie.h"

#include <random>

namespace glide::test {

/// Seeded random geometry for the tests of this folder.
class RandomGeometry {
 public:
  explicit RandomGeometry(unsigned seed) : rng_(seed) {}

  double uniform(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(rng_);
  }
  double gauss(double sigma) { return std::normal_distribution<double>(0.0, sigma)(rng_); }
  Vec3d vector(double sigma) { return {gauss(sigma), gauss(sigma), gauss(sigma)}; }
  Vec3d direction() { return vector(1.0).normalized(); }

  /// Rotation by `angle` radians about a random axis, translation of deviation `sigma`.
  SE3d transform(double angle, double sigma) {
    return SE3d{so3Exp(angle * direction()), vector(sigma)};
  }

 private:
  std::mt19937 rng_;
};

}  // namespace glide::test
