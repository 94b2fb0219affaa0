#include "render/camera_points.h"

#include <algorithm>
#include <cmath>

namespace glide {
namespace {

// Ends of the scale: Config::Direct::max_rms, and half the search radius of the indirect tracker.
constexpr float kDirectScale = 25.0F;   // grey levels
constexpr float kIndirectScale = 3.0F;  // px

constexpr Color kGood{0.196F, 0.804F, 0.255F, 1.0F};
constexpr Color kFair{1.0F, 0.843F, 0.118F, 1.0F};
constexpr Color kBad{0.922F, 0.157F, 0.118F, 1.0F};
// Around points, so that they stand out on any picture.
constexpr Color kShade{0.0F, 0.0F, 0.0F, 0.55F};
constexpr float kShadePx = 1.0F;

constexpr float kRadius = 1.0F / 150.0F;  // of the picture's height
constexpr float kMinRadiusPx = 2.0F;
constexpr float kRingRadius = 1.5F;   // of an outlier over that of a point: its hole is seen
constexpr float kRingWidth = 0.6F;    // over the radius of a point
constexpr float kTrail = 0.4F;        // radius of a trail over that of its point
constexpr float kTrailAlpha = 0.85F;  // where it meets the point; 0 at its end

Color mixed(const Color& a, const Color& b, float share) {
  Color color{};
  for (std::size_t i = 0; i < color.size(); ++i) color[i] = a[i] + share * (b[i] - a[i]);
  return color;
}

float trailAlpha(std::size_t back) {
  return kTrailAlpha * (1.0F - static_cast<float>(back) / static_cast<float>(PointTrails::kLength));
}

}  // namespace

Color pointColor(float residual, TrackerKind tracker) {
  const float scale = tracker == TrackerKind::direct ? kDirectScale : kIndirectScale;
  const float share = std::clamp(2.0F * residual / scale, 0.0F, 2.0F);
  return share < 1.0F ? mixed(kGood, kFair, share) : mixed(kFair, kBad, share - 1.0F);
}

float PointInk::radius() const {
  return std::max(kMinRadiusPx, kRadius * static_cast<float>(layout.area.height));
}

void PointInk::append(std::span<const TrackedPoint> points,
                      const PointTrails& trails,
                      std::vector<InkShape>* shapes) const {
  for (const TrackedPoint& point : points) appendTrail(point, trails, shapes);
  for (const TrackedPoint& point : points) appendPoint(point, shapes);
}

void PointInk::appendTrail(const TrackedPoint& point,
                           const PointTrails& trails,
                           std::vector<InkShape>* shapes) const {
  const PointTrails::Trail trail = trails.of(point.landmark);
  const PackedColor color = packColor(pointColor(point.residual, tracker));
  for (std::size_t i = 1; i < trail.count; ++i) {
    const auto& newer = trail.uv[i - 1];
    const auto& older = trail.uv[i];
    shapes->push_back(inkLine({layout.place({newer[0], newer[1]}, camera),
                               layout.place({older[0], older[1]}, camera),
                               kTrail * radius()},
                              withAlpha(color, trailAlpha(i - 1)),
                              withAlpha(color, trailAlpha(i))));
  }
}

void PointInk::appendPoint(const TrackedPoint& point, std::vector<InkShape>* shapes) const {
  const PointPx at = layout.place({point.u, point.v}, camera);
  const PackedColor color = packColor(pointColor(point.residual, tracker));
  if (point.inlier) {
    shapes->push_back(inkDisc(at, radius() + kShadePx, packColor(kShade)));
    shapes->push_back(inkDisc(at, radius(), color));
    return;
  }
  const float outer = kRingRadius * radius();
  const float width = kRingWidth * radius();
  shapes->push_back(inkRing(at, outer + kShadePx, width + kShadePx, packColor(kShade)));
  shapes->push_back(inkRing(at, outer, width, color));
}

}  // namespace glide
