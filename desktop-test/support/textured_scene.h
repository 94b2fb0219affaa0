#pragma once

#include "geometry/camera_model.h"
#include "geometry/lie.h"
#include "image/image.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace glide::test {

/// A textured rectangle in space, visible from both sides.
struct TexturedRectangle {
  Vec3d center_world;
  Vec3d half_x_world;  ///< from the centre to the middle of one side
  Vec3d half_y_world;  ///< perpendicular to half_x_world
  std::uint32_t seed = 1;
};

/// What the sensor makes of the scene's grey levels: gain * grey + bias, rounded and clipped to
/// 0..255.
struct Exposure {
  double gain = 1.0;
  double bias = 0.0;
};

/// A tiny analytic scene: rectangles with smooth band-limited texture (value noise, grey
/// levels 42..214), ray cast through any camera model with exact geometry. Deterministic. For
/// anti-aliased scenes with noise and blur use desktop-test/synthetic instead.
class TexturedScene {
 public:
  explicit TexturedScene(std::vector<TexturedRectangle> rectangles);

  /// For a camera near the origin looking along +z: a large slanted wall at about 1.5 m, and two
  /// panels in front of it at 1.0 m and 1.2 m.
  static TexturedScene wallWithPanels();

  void add(const TexturedRectangle& rectangle) { rectangles_.push_back(rectangle); }

  /// The image that `camera` takes; rays that meet nothing give a mid grey.
  ImageU8 render(const CameraModel& camera,
                 const SE3d& T_world_cam,
                 const Exposure& exposure) const;

  /// The scene point that a pixel sees.
  std::optional<Vec3d> pointAt(const CameraModel& camera,
                               const SE3d& T_world_cam,
                               const Vec2d& uv) const;

  /// `count` scene points, in the camera frame, at random pixels of the image (seeded).
  std::vector<Vec3d> samplePoints(const CameraModel& camera,
                                  const SE3d& T_world_cam,
                                  int count,
                                  std::uint32_t seed) const;

 private:
  struct Hit {
    double distance = 0.0;  ///< along the ray, in units of its direction
    double grey = 0.0;
  };
  std::optional<Hit> cast(const Vec3d& origin_world, const Vec3d& direction_world) const;

  std::vector<TexturedRectangle> rectangles_;
};

}  // namespace glide::test
