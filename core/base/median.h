#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace glide {

/// The upper median, or `if_empty`. Takes the values by value because it reorders them.
inline double median(std::vector<double> values, double if_empty) {
  if (values.empty()) return if_empty;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace glide
