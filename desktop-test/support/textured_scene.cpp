#include "support/textured_scene.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>

namespace glide::test {
namespace {

constexpr double kMidGrey = 128.0;
constexpr double kMaxGrey = 255.0;

/// Octaves of the texture. At 1.5 units and 460 px focal length the finest cell is eight pixels and
/// the coarsest eight pixels of pyramid level 5: every level has contrast, and no level aliases.
struct Octave {
  double cell;       ///< scene units
  double amplitude;  ///< grey levels
};
constexpr Octave kOctaves[] = {
    {0.8, 6.0}, {0.4, 8.0}, {0.2, 12.0}, {0.1, 16.0}, {0.05, 20.0}, {0.025, 24.0}};

/// A well-mixed value in -1..1 of a lattice node.
double latticeValue(std::int32_t x, std::int32_t y, std::uint32_t seed) {
  std::uint32_t h = seed * 0x9E3779B9u + static_cast<std::uint32_t>(x) * 0x85EBCA6Bu +
                    static_cast<std::uint32_t>(y) * 0xC2B2AE35u;
  for (int round = 0; round < 2; ++round) {
    h ^= h >> 16;
    h *= 0x7FEB352Du;
    h ^= h >> 15;
  }
  return static_cast<double>(h) / 2147483647.5 - 1.0;
}

/// Interpolation weight with zero first and second derivative at the nodes.
double fade(double t) { return t * t * t * (t * (6.0 * t - 15.0) + 10.0); }

double valueNoise(double x, double y, std::uint32_t seed) {
  const double x0 = std::floor(x);
  const double y0 = std::floor(y);
  const auto ix = static_cast<std::int32_t>(x0);
  const auto iy = static_cast<std::int32_t>(y0);
  const double wx = fade(x - x0);
  const double wy = fade(y - y0);
  const double top = (1.0 - wx) * latticeValue(ix, iy, seed) + wx * latticeValue(ix + 1, iy, seed);
  const double bottom =
      (1.0 - wx) * latticeValue(ix, iy + 1, seed) + wx * latticeValue(ix + 1, iy + 1, seed);
  return (1.0 - wy) * top + wy * bottom;
}

double texture(double x, double y, std::uint32_t seed) {
  double grey = kMidGrey;
  std::uint32_t octave_seed = seed * 16u;
  for (const Octave& octave : kOctaves) {
    grey += octave.amplitude * valueNoise(x / octave.cell, y / octave.cell, octave_seed++);
  }
  return grey;
}

}  // namespace

TexturedScene::TexturedScene(std::vector<TexturedRectangle> rectangles)
    : rectangles_(std::move(rectangles)) {}

TexturedScene TexturedScene::wallWithPanels() {
  const Vec3d along_x(12.0, 0.0, 2.4);
  const Vec3d along_y(0.0, 12.0, 0.0);
  return TexturedScene({{Vec3d(0.0, 0.0, 1.6), along_x, along_y, 1},
                        {Vec3d(-0.45, 0.15, 1.0), Vec3d(0.18, 0.0, 0.0), Vec3d(0.0, 0.22, 0.08), 2},
                        {Vec3d(0.4, -0.2, 1.2), Vec3d(0.25, 0.0, 0.1), Vec3d(0.0, 0.2, 0.0), 3}});
}

std::optional<TexturedScene::Hit> TexturedScene::cast(const Vec3d& origin_world,
                                                      const Vec3d& direction_world) const {
  std::optional<Hit> nearest;
  for (const TexturedRectangle& rectangle : rectangles_) {
    const Vec3d normal = rectangle.half_x_world.cross(rectangle.half_y_world);
    const double slope = normal.dot(direction_world);
    const double distance = normal.dot(rectangle.center_world - origin_world) / slope;
    if (!(distance > 0.0) || !std::isfinite(distance)) continue;
    if (nearest && nearest->distance <= distance) continue;
    const Vec3d offset = origin_world + distance * direction_world - rectangle.center_world;
    const double half_x = rectangle.half_x_world.norm();
    const double half_y = rectangle.half_y_world.norm();
    const double x = offset.dot(rectangle.half_x_world) / half_x;
    const double y = offset.dot(rectangle.half_y_world) / half_y;
    if (std::abs(x) > half_x || std::abs(y) > half_y) continue;
    nearest = Hit{distance, texture(x, y, rectangle.seed)};
  }
  return nearest;
}

ImageU8 TexturedScene::render(const CameraModel& camera,
                              const SE3d& T_world_cam,
                              const Exposure& exposure) const {
  const Mat3d R_world_cam = T_world_cam.rotation();
  ImageU8 image(camera.width(), camera.height());
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      const std::optional<Vec3d> bearing = camera.unproject(Vec2d(x, y));
      const std::optional<Hit> hit =
          bearing ? cast(T_world_cam.t, R_world_cam * *bearing) : std::nullopt;
      const double grey = exposure.gain * (hit ? hit->grey : kMidGrey) + exposure.bias;
      image.at(x, y) = static_cast<std::uint8_t>(std::clamp(std::round(grey), 0.0, kMaxGrey));
    }
  }
  return image;
}

std::optional<Vec3d> TexturedScene::pointAt(const CameraModel& camera,
                                            const SE3d& T_world_cam,
                                            const Vec2d& uv) const {
  const std::optional<Vec3d> bearing = camera.unproject(uv);
  if (!bearing) return std::nullopt;
  const Vec3d direction_world = T_world_cam.rotation() * *bearing;
  const std::optional<Hit> hit = cast(T_world_cam.t, direction_world);
  if (!hit) return std::nullopt;
  return Vec3d(T_world_cam.t + hit->distance * direction_world);
}

std::vector<Vec3d> TexturedScene::samplePoints(const CameraModel& camera,
                                               const SE3d& T_world_cam,
                                               int count,
                                               std::uint32_t seed) const {
  constexpr int kTriesPerPoint = 20;  // a scene that fills less of the image gives fewer points
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> along_x(0.0, camera.width() - 1.0);
  std::uniform_real_distribution<double> along_y(0.0, camera.height() - 1.0);
  const SE3d T_cam_world = T_world_cam.inverse();
  std::vector<Vec3d> points_cam;
  for (int i = 0; i < kTriesPerPoint * count && static_cast<int>(points_cam.size()) < count; ++i) {
    const double u = along_x(random);
    const double v = along_y(random);
    const std::optional<Vec3d> p_world = pointAt(camera, T_world_cam, Vec2d(u, v));
    if (p_world) points_cam.push_back(T_cam_world * *p_world);
  }
  return points_cam;
}

}  // namespace glide::test
