#include "synthetic/furnishing.h"

#include <cmath>

namespace glide::synthetic {

namespace {

constexpr float kTexels = 200.0F;  // per metre: a texel is smaller than a pixel from 1.3 m on

}  // namespace

void furnish(const WallRun& run,
             std::span<const Furniture> kinds,
             const Gaps& gaps,
             Random* random,
             Scene* scene) {
  const Vec3f along = run.normal.cross(Vec3f::UnitY());
  const float half = 0.5F * run.length;
  float place = -half + gaps.ends;
  while (true) {
    const Furniture& kind =
        kinds[static_cast<std::size_t>(random->below(static_cast<int>(kinds.size())))];
    const float width = random->uniform(kind.min_width, kind.max_width);
    if (place + width > half - gaps.ends) return;
    Box box;
    box.size = {width, kind.height * random->uniform(0.85F, 1.1F), kind.depth};
    box.center = run.foot + (place + 0.5F * width) * along + 0.5F * kind.depth * run.normal -
                 (kind.above_floor + 0.5F * box.size.y()) * Vec3f::UnitY();
    box.yaw = std::atan2(-run.normal.x(), -run.normal.z());
    box.front = kind.front;
    box.side = kind.side;
    box.top = kind.top;
    addBox(box, kTexels, scene);
    place += width + random->uniform(gaps.least, gaps.most);
  }
}

void addWall(const WallRun& run, float height, const Surface& look, Scene* scene) {
  const Vec3f along = run.length * run.normal.cross(Vec3f::UnitY());
  const Vec3f top = run.foot - height * Vec3f::UnitY();
  addSurface(top - 0.5F * along, along, height * Vec3f::UnitY(), look, scene);
}

}  // namespace glide::synthetic
