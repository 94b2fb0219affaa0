#include "feature/level_quota.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

namespace glide {

std::vector<int> levelQuotas(int count, double scale_factor, std::span<const int> found) {
  std::vector<int> quotas(found.size(), 0);
  int missing = std::min(count, std::accumulate(found.begin(), found.end(), 0));
  // Each round either gives everything away or exhausts a level.
  while (missing > 0) {
    double weights = 0.0;
    for (std::size_t l = 0; l < found.size(); ++l) {
      if (quotas[l] < found[l]) weights += std::pow(scale_factor, -static_cast<double>(l));
    }
    const double unit = missing / weights;
    for (std::size_t l = 0; l < found.size() && missing > 0; ++l) {
      if (quotas[l] == found[l]) continue;
      const double share = unit * std::pow(scale_factor, -static_cast<double>(l));
      const int wanted = std::min(missing, static_cast<int>(std::ceil(share)));
      const int given = std::min(wanted, found[l] - quotas[l]);
      quotas[l] += given;
      missing -= given;
    }
  }
  return quotas;
}

}  // namespace glide
