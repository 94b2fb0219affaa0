#pragma once

#include "synthetic/canvas.h"
#include "synthetic/scene.h"

#include <vector>

namespace glide::synthetic {

/// A square lamp that shines down from a height, or the sun when it is large and far.
struct Lamp {
  Vec3f center = Vec3f::Zero();
  float size = 0.5F;   ///< side, metres: softness of the shadows
  float power = 1.0F;  ///< irradiance at `reach` under normal incidence, 1 = white paper is white
  float reach = 2.0F;  ///< metres; irradiance falls as 2 / (1 + (r / reach)^2)
};

struct Lighting {
  float ambient = 0.35F;  ///< irradiance from everywhere
  std::vector<Lamp> lamps;
};

/// Irradiance over a surface, with soft shadows, on a coarse grid; node (i, j) lies at texel
/// (i, j) * spacing.
struct LightMap {
  ImageF irradiance;
  float spacing_texels = 1.0F;
  float at(float u, float v) const;
};

LightMap computeLight(const Lighting& lighting, const Scene& scene, const Surface& surface);

}  // namespace glide::synthetic
