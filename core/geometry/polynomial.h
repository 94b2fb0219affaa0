#pragma once

#include <array>
#include <optional>

namespace glide {

/// c0 + c1 x + c2 x^2 + c3 x^3 + c4 x^4.
using Quartic = std::array<double, 5>;

/// Smallest root of the polynomial in (0, upper] at which it changes sign; nothing when there is
/// none. Leading coefficients may be zero.
std::optional<double> smallestRoot(const Quartic& polynomial, double upper);

}  // namespace glide
