#include "replay/outputs/point_colors.h"

#include <cmath>
#include <cstddef>
#include <optional>

namespace glide::replay {
namespace {

std::optional<Rgb8> colorAt(const SourceFrame& frame, float u, float v) {
  const auto x = static_cast<int>(std::lround(u));
  const auto y = static_cast<int>(std::lround(v));
  if (x < 0 || y < 0 || x >= frame.image.width() || y >= frame.image.height()) return std::nullopt;
  if (frame.color.rgb.empty()) {
    const std::uint8_t gray = frame.image.at(x, y);
    return Rgb8{gray, gray, gray};
  }
  const std::uint8_t* pixel =
      frame.color.rgb.data() + 3 * (static_cast<std::ptrdiff_t>(y) * frame.color.width + x);
  return Rgb8{pixel[0], pixel[1], pixel[2]};
}

}  // namespace

void PointColors::add(std::uint64_t map_generation,
                      const SourceFrame& frame,
                      std::span<const TrackedPoint> points) {
  if (points.empty()) return;
  if (map_generation != map_generation_) sums_.clear();
  map_generation_ = map_generation;
  for (const TrackedPoint& point : points) {
    const std::optional<Rgb8> color = colorAt(frame, point.u, point.v);
    if (!color || !point.inlier) continue;
    Sum& sum = sums_[point.landmark];
    sum.red += color->red;
    sum.green += color->green;
    sum.blue += color->blue;
    ++sum.count;
  }
}

Rgb8 PointColors::of(std::uint64_t landmark) const {
  const auto found = sums_.find(landmark);
  if (found == sums_.end()) return kUnseenColor;
  const Sum& sum = found->second;
  const auto mean = [&](std::uint32_t total) {
    return static_cast<std::uint8_t>((total + sum.count / 2) / sum.count);
  };
  return {mean(sum.red), mean(sum.green), mean(sum.blue)};
}

}  // namespace glide::replay
