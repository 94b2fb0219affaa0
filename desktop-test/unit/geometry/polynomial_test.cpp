#include "geometry/polynomial.h"

#include <gtest/gtest.h>

namespace glide {
namespace {

TEST(Polynomial, FindsTheSmallestOfSeveralRoots) {
  // (x - 3)(x - 1)(x - 7)(x + 2) = x^4 - 9 x^3 + 9 x^2 + 41 x - 42
  const std::optional<double> root = smallestRoot({-42.0, 41.0, 9.0, -9.0, 1.0}, 10.0);
  ASSERT_TRUE(root);
  EXPECT_NEAR(*root, 1.0, 1e-13);
}

TEST(Polynomial, TakesZeroLeadingCoefficients) {
  const std::optional<double> root = smallestRoot({1.0, -0.5, 0.0, 0.0, 0.0}, 10.0);
  ASSERT_TRUE(root);
  EXPECT_NEAR(*root, 2.0, 1e-14);
}

TEST(Polynomial, FindsNoRootOfAConstantOrBeyondTheEnd) {
  EXPECT_FALSE(smallestRoot({1.0, 0.0, 0.0, 0.0, 0.0}, 10.0));
  EXPECT_FALSE(smallestRoot({1.0, -0.5, 0.0, 0.0, 0.0}, 1.9));
  EXPECT_FALSE(smallestRoot({1.0, 0.0, 1.0, 0.0, 0.0}, 10.0));
}

}  // namespace
}  // namespace glide
