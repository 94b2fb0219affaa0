#pragma once

#include "glide/config.h"
#include "glide/frame.h"
#include "glide/render_types.h"
#include "glide/result.h"
#include "glide/version.h"

#include <memory>
#include <span>

namespace glide {

/// Things of the world that are drawn over the camera's picture. Lengths in scene units.
struct ArContent {
  bool axes = true;  ///< of the map's world: x red, y green, z blue
  float axis_length = 0.2F;
  /// Cubes: T_world_cube has the centre of the bottom face, its y axis down (the world's).
  std::span<const Pose> cubes;
  float cube_edge = 0.1F;
};

/// Draws what the camera sees: its picture, the points that the tracker used (coloured by how well
/// they agree), and AR content. The picture keeps its aspect ratio: the largest centred rectangle
/// of the viewport; the rest is left as it was. Lenses are honoured: what is drawn over the picture
/// is distorted as it is. Threads, context and state as MapRenderer.
class GLIDE_API CameraRenderer {
 public:
  static Result<CameraRenderer> create(GlStatePolicy policy, const CameraIntrinsics& camera);

  CameraRenderer(CameraRenderer&&) noexcept;
  CameraRenderer& operator=(CameraRenderer&&) noexcept;
  ~CameraRenderer();

  /// The lens that AR content is drawn through from now on, such as MapView::corrected_camera.
  /// invalid_argument as create(); then the one before stays.
  Status setIntrinsics(const CameraIntrinsics& camera);

  /// The picture alone. invalid_argument when it has no pixels or the viewport none, for a texture
  /// that Session::update would not take, either, and without a complete framebuffer; unsupported
  /// for an external texture in a context without the extension.
  Status drawPicture(const Picture& picture, const Viewport& viewport);
  /// Points over the picture drawn last, in the same viewport: green where they agree, over yellow
  /// to red where they do not; the scale is the tracker's (direct: 0 to 25 grey levels, indirect: 0
  /// to 3 px). Outliers are hollow. A line leads from where the same landmark was in the draws
  /// before, up to ten; draws without points count.
  Status drawPoints(std::span<const TrackedPoint> points,
                    TrackerKind tracker,
                    const Viewport& viewport);
  /// AR content over the picture drawn last, seen from a camera at T_world_cam.
  Status drawAr(const ArContent& content, const Pose& T_world_cam, const Viewport& viewport);

  void releaseGl();
  void abandonGl();

 private:
  class Impl;
  explicit CameraRenderer(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace glide
