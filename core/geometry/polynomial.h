#pragma once

#include <array>
#include <vector>

namespace glide {

/// c0 + c1 x + c2 x^2 + c3 x^3 + c4 x^4.
using Quartic = std::array<double, 5>;

/// Roots of the polynomial in [lower, upper] at which it changes sign, rising. Leading coefficients
/// may be zero.
std::vector<double> rootsBetween(const Quartic& polynomial, double lower, double upper);

}  // namespace glide
