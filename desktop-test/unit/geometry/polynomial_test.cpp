#include "geometry/polynomial.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace glide {
namespace {

using ::testing::DoubleNear;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

TEST(Polynomial, FindsTheRootsOfAQuarticInOrder) {
  // (x - 3)(x - 1)(x - 7)(x + 2)
  const Quartic quartic{-42.0, 41.0, 9.0, -9.0, 1.0};
  EXPECT_THAT(rootsBetween(quartic, 0.0, 10.0),
              ElementsAre(DoubleNear(1.0, 1e-13), DoubleNear(3.0, 1e-13), DoubleNear(7.0, 1e-13)));
}

TEST(Polynomial, LooksOnlyBetweenTheBounds) {
  const Quartic quartic{-42.0, 41.0, 9.0, -9.0, 1.0};
  EXPECT_THAT(rootsBetween(quartic, 1.5, 6.5), ElementsAre(DoubleNear(3.0, 1e-13)));
  EXPECT_THAT(rootsBetween(quartic, -3.0, 0.0), ElementsAre(DoubleNear(-2.0, 1e-13)));
}

TEST(Polynomial, TakesZeroLeadingCoefficients) {
  EXPECT_THAT(rootsBetween({1.0, -0.5, 0.0, 0.0, 0.0}, 0.0, 10.0),
              ElementsAre(DoubleNear(2.0, 1e-14)));
}

TEST(Polynomial, FindsNoRootWhereThereIsNone) {
  EXPECT_THAT(rootsBetween({1.0, 0.0, 0.0, 0.0, 0.0}, 0.0, 10.0), IsEmpty());
  EXPECT_THAT(rootsBetween({1.0, -0.5, 0.0, 0.0, 0.0}, 0.0, 1.9), IsEmpty());
  EXPECT_THAT(rootsBetween({1.0, 0.0, 1.0, 0.0, 0.0}, 0.0, 10.0), IsEmpty());
}

}  // namespace
}  // namespace glide
