#include "geometry/polynomial.h"

#include <vector>

namespace glide {
namespace {

double evaluate(const Quartic& c, double x) {
  return c[0] + x * (c[1] + x * (c[2] + x * (c[3] + x * c[4])));
}

/// Halves low..high, across which the sign changes, until no double lies between.
double bisect(const Quartic& c, double low, double high) {
  const bool rising = evaluate(c, low) < 0.0;
  for (;;) {
    const double middle = 0.5 * (low + high);
    if (middle <= low || middle >= high) return low;
    ((evaluate(c, middle) < 0.0) == rising ? low : high) = middle;
  }
}

}  // namespace

// Between two roots of the derivative there is at most one root, so the degree is peeled off by
// recursion.
std::vector<double> rootsBetween(const Quartic& polynomial, double lower, double upper) {
  const Quartic& c = polynomial;
  std::vector<double> ends;
  if (c[2] != 0.0 || c[3] != 0.0 || c[4] != 0.0) {
    ends = rootsBetween({c[1], 2.0 * c[2], 3.0 * c[3], 4.0 * c[4], 0.0}, lower, upper);
  }
  ends.push_back(upper);

  std::vector<double> roots;
  double low = lower;
  for (const double high : ends) {
    const bool crosses = (evaluate(c, low) < 0.0) != (evaluate(c, high) < 0.0);
    if (crosses) roots.push_back(bisect(c, low, high));
    low = high;
  }
  return roots;
}

}  // namespace glide
