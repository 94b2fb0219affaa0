#pragma once

#include "synthetic/ray_caster.h"
#include "synthetic/scene.h"

#include "geometry/camera_model.h"
#include "geometry/lie.h"
#include "image/image.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace glide::synthetic {

/// What a perfect camera sees.
struct Rendering {
  ImageF radiance;  ///< grey levels before exposure; of colours their luma
  ImageRgb color;   ///< empty when the scene is gray
  /// Metres along the unit bearing of the pixel's centre, p_cam = range * unproject(uv); 0 where
  /// nothing is seen.
  ImageF range;
};

/// Casts one ray per pixel, and sixteen where surfaces meet; textures are filtered by mip level
/// along and across the slope of the surface. Holds scratch memory: one thread per instance.
class Renderer {
 public:
  /// Precomputes the bearing of every pixel.
  explicit Renderer(const CameraModel& camera);

  /// One pose for the whole image, or one per row (rolling shutter). Reuses the buffers of `out`.
  void render(const Scene& scene, std::span<const SE3d> T_world_cam_rows, Rendering* out);

 private:
  /// A block of pixels and the cone of their rays.
  struct Tile {
    int x0 = 0, y0 = 0, x1 = 0, y1 = 0;  ///< x1 and y1 are one past the last
    Vec3f axis_cam = Vec3f::Zero();      ///< zero when no pixel has a bearing
    float sin_half_angle = 0.0F;
  };
  /// The pyramid from the camera's centre through the outline of a surface: inward normals of its
  /// sides.
  struct Outline {
    const Surface* surface;
    std::array<Vec3f, 4> sides;
  };
  /// A camera pose in floats.
  struct View {
    Eigen::Matrix3f R_world_cam;
    Vec3f center;
  };

  Tile makeTile(int x0, int y0) const;
  void prepareViews(std::span<const SE3d> T_world_cam_rows);
  void prepareOutlines(const Scene& scene);
  const View& viewOfRow(int y) const {
    return views_[views_.size() == 1 ? 0 : static_cast<std::size_t>(y)];
  }
  void selectSurfaces(const Tile& tile);
  template <class Value>
  void renderTiles(Image<Value>* radiance, ImageF* range);
  template <class Value>
  void renderTile(const Tile& tile, Image<Value>* radiance, ImageF* range);
  template <class Value>
  void smoothTile(const Tile& tile, Image<Value>* radiance);
  bool isEdge(int x, int y) const;
  template <class Value>
  Value supersample(int x, int y) const;
  std::size_t at(int x, int y) const { return static_cast<std::size_t>(y * width_ + x); }

  int width_, height_;
  std::vector<Vec3f> bearings_;      ///< per pixel, zero where the lens sees nothing
  std::vector<float> pixel_angles_;  ///< radians between neighbouring pixels
  std::vector<Tile> tiles_;
  std::vector<View> views_;
  std::vector<Outline> outlines_;
  std::vector<const Surface*> selected_;  ///< what the ray caster holds
  RayCaster caster_;
  std::vector<const Surface*> seen_;  ///< per pixel
};

}  // namespace glide::synthetic
