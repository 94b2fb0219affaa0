#include "replay/render/frame_pacer.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace glide::replay {
namespace {

constexpr double kSlowest = 1.0, kFastest = 240.0;  // frames per second
constexpr double kTolerance = 1.0;                  // steps: jitter is no reason to repeat or drop
constexpr double kLongestGap = 10.0;                // s

}  // namespace

double frameRate(std::span<const std::int64_t> times_ns) {
  std::vector<std::int64_t> intervals;
  for (std::size_t i = 1; i < times_ns.size(); ++i) {
    intervals.push_back(times_ns[i] - times_ns[i - 1]);
  }
  const auto middle = intervals.begin() + static_cast<std::ptrdiff_t>(intervals.size() / 2);
  std::nth_element(intervals.begin(), middle, intervals.end());
  return std::clamp(1e9 / static_cast<double>(*middle), kSlowest, kFastest);
}

int FramePacer::steps(std::int64_t t_ns) {
  const double due = (static_cast<double>(t_ns - first_ns_) * 1e-9 - cut_s_) * rate_;
  const double behind = due - static_cast<double>(written_);
  int steps = 1;
  if (behind < -kTolerance) steps = 0;
  if (behind > kTolerance) {
    const double longest = kLongestGap * rate_;
    cut_s_ += std::max(0.0, behind - longest) / rate_;
    steps += static_cast<int>(std::lround(std::min(behind, longest)));
  }
  written_ += steps;
  return steps;
}

}  // namespace glide::replay
