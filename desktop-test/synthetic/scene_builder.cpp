#include "synthetic/scene_builder.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace glide::synthetic {

namespace {

/// One face of an axis-aligned box; directions are signed unit axes.
struct Face {
  Vec3f corner;  ///< -1..1 per axis
  Vec3f along_u, along_v;
};

const Vec3f kX = Vec3f::UnitX(), kY = Vec3f::UnitY(), kZ = Vec3f::UnitZ();

Surface lookOf(Material material, float texels_per_m) {
  Surface look;
  look.material = material;
  look.texels_per_m = texels_per_m;
  return look;
}

Canvas makeCanvas(const Surface& surface) {
  const auto texels = [&](float metres) {
    return std::max(2, static_cast<int>(std::lround(metres * surface.texels_per_m)));
  };
  Canvas canvas;
  canvas.texels_per_m = surface.texels_per_m;
  canvas.albedo.resize(texels(surface.width), texels(surface.height));
  return canvas;
}

/// Reflectance times irradiance to grey levels, in place.
void applyLight(const LightMap& light, Canvas* canvas) {
  constexpr float kWhite =
      235.0F;  // grey level of white paper under irradiance 1: head room for highlights
  for (int y = 0; y < canvas->height(); ++y) {
    float* row = canvas->albedo.row(y);
    for (int x = 0; x < canvas->width(); ++x) {
      const float irradiance = light.at(static_cast<float>(x) + 0.5F, static_cast<float>(y) + 0.5F);
      row[x] = std::max(0.0F, row[x]) * irradiance * kWhite;
    }
  }
}

/// The same for all surfaces that are to look alike.
std::uint64_t patternSeed(const Surface& surface, std::uint64_t seed) {
  const auto pattern = static_cast<std::uint64_t>(surface.pattern);
  return mixBits(mixBits(seed) ^ mixBits(pattern)) + static_cast<std::uint64_t>(surface.material);
}

}  // namespace

void addSurface(
    const Vec3f& origin, const Vec3f& along_u, const Vec3f& along_v, Surface look, Scene* scene) {
  look.origin = origin;
  look.width = along_u.norm();
  look.height = along_v.norm();
  look.axis_u = along_u / look.width;
  look.axis_v = along_v / look.height;
  look.normal = look.axis_v.cross(look.axis_u);
  scene->surfaces.push_back(std::move(look));
}

void addBox(const Box& box, float texels_per_m, Scene* scene) {
  const std::array<std::pair<Face, Material>, 5> faces{{
      {{{-1, -1, -1}, kX, kY}, box.front},
      {{{1, -1, 1}, -kX, kY}, box.front},
      {{{1, -1, -1}, kZ, kY}, box.side},
      {{{-1, -1, 1}, -kZ, kY}, box.side},
      {{{-1, -1, 1}, kX, -kZ}, box.top},
  }};
  const Eigen::Matrix3f R_world_box = Eigen::AngleAxisf(box.yaw, kY).toRotationMatrix();
  for (const auto& [face, material] : faces) {
    const Vec3f corner =
        box.center + R_world_box * Vec3f(0.5F * face.corner.cwiseProduct(box.size));
    const Vec3f along_u = R_world_box * face.along_u.cwiseProduct(box.size);
    const Vec3f along_v = R_world_box * face.along_v.cwiseProduct(box.size);
    Surface look = lookOf(material, texels_per_m);
    look.pattern = box.pattern;
    addSurface(corner, along_u, along_v, look, scene);
  }
}

void addInterior(const Interior& interior, float texels_per_m, Scene* scene) {
  const std::array<std::pair<Face, Material>, 6> faces{{
      {{{-1, -1, 1}, kX, kY}, interior.wall},
      {{{1, -1, -1}, -kX, kY}, interior.wall},
      {{{1, -1, 1}, -kZ, kY}, interior.wall},
      {{{-1, -1, -1}, kZ, kY}, interior.wall},
      {{{-1, 1, 1}, kX, -kZ}, interior.floor},
      {{{-1, -1, -1}, kX, kZ}, interior.ceiling},
  }};
  const Vec3f center = 0.5F * (interior.low + interior.high), size = interior.high - interior.low;
  for (const auto& [face, material] : faces) {
    addSurface(center + 0.5F * face.corner.cwiseProduct(size),
               face.along_u.cwiseProduct(size),
               face.along_v.cwiseProduct(size),
               lookOf(material, texels_per_m),
               scene);
  }
}

void addTable(const Table& table, float texels_per_m, Scene* scene) {
  constexpr float kThickness = 0.04F, kLeg = 0.06F;  // metres
  const Vec3f& size = table.size;
  addBox({table.top_center + 0.5F * kThickness * kY,
          {size.x(), kThickness, size.z()},
          table.yaw,
          Material::wood,
          Material::wood,
          Material::desk},
         texels_per_m,
         scene);
  const Eigen::Matrix3f R_world_table = Eigen::AngleAxisf(table.yaw, kY).toRotationMatrix();
  const float leg_height = size.y() - kThickness;
  for (const float side_x : {-0.5F, 0.5F}) {
    for (const float side_z : {-0.5F, 0.5F}) {
      const Vec3f offset(side_x * (size.x() - 2 * kLeg),
                         kThickness + 0.5F * leg_height,
                         side_z * (size.z() - 2 * kLeg));
      addBox({table.top_center + R_world_table * offset, {kLeg, leg_height, kLeg}, table.yaw},
             texels_per_m,
             scene);
    }
  }
}

void finishScene(const Lighting& lighting, std::uint64_t seed, Scene* scene) {
  std::uint64_t index = 0;
  for (Surface& surface : scene->surfaces) {
    const std::uint64_t own = mixBits(seed) + index++;
    Random random(surface.pattern == Surface::kUnique ? own : patternSeed(surface, seed));
    Canvas canvas = makeCanvas(surface);
    paint(surface.material, &canvas, &random);
    applyLight(computeLight(lighting, *scene, surface), &canvas);
    surface.texture = Texture(canvas.albedo);
  }
}

Scene makeScene(SceneKind kind, std::uint64_t seed) {
  switch (kind) {
    case SceneKind::room:
      return makeRoom(seed);
    case SceneKind::facade:
      return makeFacade(seed);
    case SceneKind::desk:
      return makeDesk(seed);
    case SceneKind::corridor:
      return makeCorridor(seed);
    case SceneKind::hall:
      return makeHall(seed);
    case SceneKind::arcade:
      return makeArcade(seed);
    case SceneKind::living_room:
      return makeLivingRoom(seed);
  }
  return {};
}

}  // namespace glide::synthetic
