#include "synthetic/lighting.h"

#include <algorithm>
#include <cmath>

namespace glide::synthetic {

namespace {

constexpr float kGridSpacing =
    0.08F;                       // metres between light samples: finer than any soft shadow here
constexpr int kMaxNodes = 64;    // per side: large surfaces are lit by far lamps
constexpr int kLampSamples = 3;  // per side of the lamp
constexpr float kClearance =
    1e-3F;  // metres (and share of the way) next to the ends of a shadow ray

/// Whether something stands between two points.
bool isBlocked(const Scene& scene, const Vec3f& from, const Vec3f& to) {
  const Vec3f way = to - from;
  return std::any_of(scene.surfaces.begin(), scene.surfaces.end(), [&](const Surface& surface) {
    const float slope = surface.normal.dot(way);
    if (slope == 0.0F) return false;
    const float share = surface.normal.dot(surface.origin - from) / slope;
    if (share < kClearance || share > 1.0F - kClearance) return false;
    const Vec3f hit = from + share * way - surface.origin;
    const float u = hit.dot(surface.axis_u), v = hit.dot(surface.axis_v);
    return u > 0.0F && v > 0.0F && u < surface.width && v < surface.height;
  });
}

float fromLampPoint(const Lamp& lamp, const Vec3f& source, const Vec3f& p, const Vec3f& normal) {
  const Vec3f way = source - p;
  const float r = way.norm();
  const float cosine = std::max(0.0F, way.dot(normal) / r);
  const float near = r / lamp.reach;
  return lamp.power * cosine * 2.0F / (1.0F + near * near);
}

float irradianceAt(const Lighting& lighting,
                   const Scene& scene,
                   const Vec3f& p,
                   const Vec3f& normal) {
  float sum = lighting.ambient;
  for (const Lamp& lamp : lighting.lamps) {
    for (int k = 0; k < kLampSamples * kLampSamples; ++k) {
      const float a = (static_cast<float>(k % kLampSamples) + 0.5F) / kLampSamples - 0.5F;
      const float b = (static_cast<float>(k / kLampSamples) + 0.5F) / kLampSamples - 0.5F;
      const Vec3f source = lamp.center + lamp.size * Vec3f(a, 0.0F, b);
      const float light = fromLampPoint(lamp, source, p, normal) / (kLampSamples * kLampSamples);
      if (light > 0.0F && !isBlocked(scene, p, source)) sum += light;
    }
  }
  return sum;
}

}  // namespace

float LightMap::at(float u, float v) const {
  const float x = u / spacing_texels, y = v / spacing_texels;
  const int x0 = std::clamp(static_cast<int>(x), 0, irradiance.width() - 2);
  const int y0 = std::clamp(static_cast<int>(y), 0, irradiance.height() - 2);
  const float fx = x - static_cast<float>(x0), fy = y - static_cast<float>(y0);
  const float* top = irradiance.row(y0) + x0;
  const float* bottom = irradiance.row(y0 + 1) + x0;
  return (1 - fy) * ((1 - fx) * top[0] + fx * top[1]) +
         fy * ((1 - fx) * bottom[0] + fx * bottom[1]);
}

LightMap computeLight(const Lighting& lighting, const Scene& scene, const Surface& surface) {
  const float longer = std::max(surface.width, surface.height);
  const float spacing = std::max(kGridSpacing, longer / kMaxNodes);
  LightMap map;
  map.spacing_texels = spacing * surface.texels_per_m;
  map.irradiance.resize(static_cast<int>(surface.width / spacing) + 2,
                        static_cast<int>(surface.height / spacing) + 2);
  const float inset = kClearance;
  for (int y = 0; y < map.irradiance.height(); ++y) {
    for (int x = 0; x < map.irradiance.width(); ++x) {
      const float u = std::clamp(static_cast<float>(x) * spacing, inset, surface.width - inset);
      const float v = std::clamp(static_cast<float>(y) * spacing, inset, surface.height - inset);
      const Vec3f p =
          surface.origin + u * surface.axis_u + v * surface.axis_v + kClearance * surface.normal;
      map.irradiance.row(y)[x] = irradianceAt(lighting, scene, p, surface.normal);
    }
  }
  return map;
}

}  // namespace glide::synthetic
