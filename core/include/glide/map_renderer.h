#pragma once

#include "glide/config.h"
#include "glide/frame.h"
#include "glide/map_view.h"
#include "glide/render_types.h"
#include "glide/result.h"
#include "glide/version.h"

#include <cstdint>
#include <memory>
#include <span>

namespace glide {

/// What a landmark's colour tells.
enum class LandmarkColoring {
  height,   ///< along the world's up axis: low blue, high red
  recency,  ///< id, that is age: old gray, new green
};

/// What MapRenderer draws, and how. Sizes in px of the framebuffer, lengths in scene units.
struct MapStyle {
  LandmarkColoring coloring = LandmarkColoring::height;
  float landmark_px = 4.0F;  ///< of a landmark with many observations; others are smaller
  /// Depth of a keyframe's frustum; the current camera's is twice that. The first map's median
  /// depth is 1.
  float frustum_size = 0.045F;
  float line_px = 1.5F;  ///< of the trajectory; edges and frusta are thinner
  bool landmarks = true;
  bool keyframes = true;
  bool trajectory = true;
  bool frame_frusta = false;  ///< a small frustum for every frame, not only the keyframes
  bool covisibility = true;
  bool loops = true;
  int covisible_neighbors = 3;  ///< edges per keyframe
  /// What the mini map lies on, with a thin frame; alpha 0: on what is there.
  Color mini_map_ground{1.0F, 1.0F, 1.0F, 0.92F};
};

/// Draws a map and the camera's way through it in 3-D: landmarks as points (size and alpha by
/// observations), keyframes and frames as frusta (orange: tracked directly; dark blue:
/// indirectly), the trajectory, covisibility and loop edges. No text. OpenGL ES 3.1; every call but
/// the setters is made on the thread of the context, which is current; what that means for its
/// state is docs/gl-contract.md. A map of 20 000 landmarks takes less than ten draw calls.
class GLIDE_API MapRenderer {
 public:
  /// Checks the current context: unsupported when it is no OpenGL ES 3.1. Objects are made by the
  /// first draw.
  static Result<MapRenderer> create(GlStatePolicy policy);

  MapRenderer(MapRenderer&&) noexcept;
  MapRenderer& operator=(MapRenderer&&) noexcept;
  ~MapRenderer();  ///< Frees in the current context; after abandonGl() without a GL call.

  void setStyle(const MapStyle& style);
  /// The map that is drawn from now on; uploaded by the next draw. Never null. Frames are placed by
  /// its keyframes, so that a loop closure moves the trajectory, too. A map of another
  /// MapView::generation forgets the frames.
  void setMap(std::shared_ptr<const MapView> map);
  /// The camera whose frusta are drawn.
  void setIntrinsics(const CameraIntrinsics& camera);
  /// Appends a tracked frame to the trajectory and makes it the current camera; others are ignored.
  void addFrame(const FrameResult& frame);
  /// A second trajectory, drawn in green: camera positions in the map's world. Empty: none.
  void setTruth(std::span<const Pose> T_world_cam);

  /// Draws the scene into the framebuffer that is bound, with a depth test when it has a depth
  /// buffer (whose values in the viewport are cleared). unsupported when the context is no longer
  /// one that can (the error names it); invalid_argument for an empty viewport.
  Status draw(const ViewCamera& camera, const Viewport& viewport);
  /// The same from straight above, the world's z axis up, x to the right: an inset. All keyframes
  /// are in it, and the landmarks around them; those far away fall off its edge.
  Status drawMiniMap(const Viewport& viewport);

  /// Draw calls of the last draw.
  int drawCalls() const;

  /// As Session::releaseGl and abandonGl: the next draw makes the objects anew.
  void releaseGl();
  void abandonGl();

 private:
  class Impl;
  explicit MapRenderer(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace glide
