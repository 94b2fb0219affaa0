#include "synthetic/ray_caster.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace glide::synthetic {

bool isInEllipse(const Surface& surface, float u, float v) {
  const float x = 2.0F * u / surface.width - 1.0F, y = 2.0F * v / surface.height - 1.0F;
  return x * x + y * y <= 1.0F;
}

void RayCaster::moveTo(const Vec3f& center_world) {
  for (Target& target : targets_) {
    const Vec3f offset = center_world - target.surface->origin;
    target.height = target.surface->normal.dot(offset);
    target.u = target.surface->axis_u.dot(offset);
    target.v = target.surface->axis_v.dot(offset);
  }
}

Hit RayCaster::trace(const Vec3f& d_world) const {
  Hit hit;
  float nearest = std::numeric_limits<float>::infinity();
  for (std::size_t i = 0; i < targets_.size(); ++i) {
    const Target& target = targets_[i];
    const Surface& surface = *target.surface;
    const float descent = -surface.normal.dot(d_world);
    if (target.height <= 0.0F || descent <= 0.0F || target.height >= nearest * descent) continue;
    const float range = target.height / descent;
    const float u = target.u + range * surface.axis_u.dot(d_world);
    const float v = target.v + range * surface.axis_v.dot(d_world);
    if (u < 0.0F || v < 0.0F || u >= surface.width || v >= surface.height) continue;
    if (surface.is_round && !isInEllipse(surface, u, v)) continue;
    nearest = range;
    hit.index = static_cast<int>(i);
  }
  if (hit.index >= 0) hit.range = nearest;
  return hit;
}

template <class Value>
Value RayCaster::shade(const Hit& hit, const Vec3f& d_world, float pixel_angle) const {
  if (hit.index < 0) return black<Value>();
  constexpr float kMaxTaps =
      8.0F;  // beyond 83 degrees of slope the texture is blurred a little more
  const Target& target = targets_[static_cast<std::size_t>(hit.index)];
  const Surface& surface = *target.surface;
  const float du = surface.axis_u.dot(d_world), dv = surface.axis_v.dot(d_world);
  const float texels = surface.texels_per_m;
  const float u = (target.u + hit.range * du) * texels, v = (target.v + hit.range * dv) * texels;
  // A pixel's cone cuts the plane in an ellipse, longer by 1 / cos of the slope along the ray's
  // foot.
  const float minor = hit.range * pixel_angle * texels;
  const float stretch = hit.range / target.height;
  const float taps = std::clamp(std::round(stretch), 1.0F, kMaxTaps);
  if (taps == 1.0F) return surface.texture.sample<Value>(u, v, minor);
  const float footprint = minor * std::max(1.0F, stretch / taps);
  const float step = minor * stretch / (taps * std::max(1e-6F, std::hypot(du, dv)));
  Value sum = black<Value>();
  for (float tap = 0.5F - 0.5F * taps; tap < 0.5F * taps; tap += 1.0F) {
    sum += surface.texture.sample<Value>(u + tap * step * du, v + tap * step * dv, footprint);
  }
  return sum / taps;
}

template float RayCaster::shade<float>(const Hit&, const Vec3f&, float) const;
template Vec3f RayCaster::shade<Vec3f>(const Hit&, const Vec3f&, float) const;

}  // namespace glide::synthetic
