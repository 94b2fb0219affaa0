#pragma once

#include "glide/types.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <variant>

struct AHardwareBuffer;  // of the Android NDK, <android/hardware_buffer.h>

namespace glide {

/// An 8-bit gray image that the caller owns; read only during Session::update.
struct Luma {
  const std::uint8_t* pixels = nullptr;
  int width = 0;              ///< px
  int height = 0;             ///< px
  std::ptrdiff_t stride = 0;  ///< bytes from one row to the next, at least width
};

/// Where in a texture the image lies: an affine 4x4 matrix, column-major, that maps (s, t, 0, 1) to
/// texture coordinates. s runs from 0 to 1 to the right and t from 0 to 1 upwards, from the lower
/// left corner of the image. What SurfaceTexture.getTransformMatrix gives.
using TextureTransform = std::array<float, 16>;

/// The first row of the texture's memory is the uppermost of the image, as in camera buffers and
/// after glTexSubImage2D of an image: (s, t) -> (s, 1 - t).
inline constexpr TextureTransform kUpperRowFirst{1.0F,
                                                 0.0F,
                                                 0.0F,
                                                 0.0F,
                                                 0.0F,
                                                 -1.0F,
                                                 0.0F,
                                                 0.0F,
                                                 0.0F,
                                                 0.0F,
                                                 1.0F,
                                                 0.0F,
                                                 0.0F,
                                                 1.0F,
                                                 0.0F,
                                                 1.0F};
/// The first row is the lowest: what was rendered into the texture with OpenGL.
inline constexpr TextureTransform kLowerRowFirst{
    1.0F, 0.0F, 0.0F, 0.0F, 0.0F, 1.0F, 0.0F, 0.0F, 0.0F, 0.0F, 1.0F, 0.0F, 0.0F, 0.0F, 0.0F, 1.0F};

/// A texture of the OpenGL ES 3.1 context that is current in Session::update, read only during the
/// call; when it returns, the GPU has read it. The frame has the size of the camera, whatever that
/// of the texture is. docs/inputs.md: formats, colours, orientation, cost.
struct Texture {
  std::uint32_t name = 0;    ///< of glGenTextures
  std::uint32_t target = 0;  ///< GL_TEXTURE_2D or GL_TEXTURE_EXTERNAL_OES
  int width = 0;             ///< texels of a row of its memory
  int height = 0;            ///< rows of its memory
  TextureTransform transform = kUpperRowFirst;
};

/// A buffer of Android's camera or media codecs (AImage_getHardwareBuffer) whose acquire fence has
/// signalled; the same rules as for a Texture. Usable as a GPU texture
/// (AHARDWAREBUFFER_USAGE_GPU_SAMPLED_IMAGE). Android only, elsewhere unsupported.
struct HardwareBuffer {
  AHardwareBuffer* buffer = nullptr;
  TextureTransform transform = kUpperRowFirst;
};

/// One camera frame.
struct FrameInput {
  std::int64_t t_ns = 0;  ///< nanoseconds in the camera's clock, strictly increasing
  std::variant<Luma, Texture, HardwareBuffer> image;
  std::int64_t exposure_ns = 0;              ///< 0: unknown. Not used yet.
  std::int64_t rolling_shutter_skew_ns = 0;  ///< first to last row; 0: none, or unknown. Not used.
};

/// How far the start of a map has come.
struct InitializationProgress {
  InitializationStatus status = InitializationStatus::waiting_for_image;
  int matches = 0;            ///< with the first view
  double parallax_deg = 0.0;  ///< median parallax of the matches, degrees
  int landmarks = 0;          ///< that the best two-view solution would triangulate
};

/// What a frame cost and saw. Times are wall clock milliseconds; zero where a stage did not run.
struct FrameStats {
  double update_ms = 0.0;   ///< the tracking call alone
  double mapping_ms = 0.0;  ///< mapping done inside update() (Execution::inline_ only)
  double pyramid_ms = 0.0, precompute_ms = 0.0, align_ms = 0.0;  ///< direct tracker
  double features_ms = 0.0, match_ms = 0.0, pose_ms = 0.0;       ///< indirect tracker
  double readback_ms = 0.0;  ///< bringing a texture's pixels to the CPU; zero when none were needed
  int visible = 0;           ///< landmarks of the tracker that lie in the image
  int inliers = 0;           ///< of these, the ones that agree with the pose
  double rms = 0.0;  ///< direct: robust patch error, grey levels; indirect: reprojection error, px
  bool keyframe = false;  ///< this frame was handed to the mapper
};

/// A landmark as the last frame saw it (Session::trackedPoints).
struct TrackedPoint {
  std::uint64_t landmark = 0;  ///< MapView::Landmark::id
  float u = 0.0F, v = 0.0F;    ///< px in the frame
  /// Direct frames: RMS difference of the patch after gain and bias, grey levels. Indirect frames:
  /// distance between the feature and the projected landmark, px.
  float residual = 0.0F;
  bool inlier = false;  ///< it agreed with the pose
};

/// The map was corrected (a loop was closed, the whole map adjusted, or the lens): how far that
/// moved the camera in the world. Content that was placed relative to keyframes moves along; what
/// was placed at world coordinates does not.
struct WorldCorrection {
  double translation = 0.0;   ///< distance between the camera before and after, scene units
  double rotation_deg = 0.0;  ///< degrees
  double scale = 1.0;         ///< lengths around the camera after over before
};

/// Where the camera was or will be at a time, from Session::locate.
struct LocatedCamera {
  std::int64_t t_ns = 0;
  Pose T_world_cam;  ///< camera in world, scene units; the last known pose when not valid
  std::uint64_t map_generation = 0;  ///< MapView::generation of that world
  bool valid = false;                ///< the pose is worth using
  bool tracked = false;  ///< it rests on tracked frames around t_ns, not on a guess of the motion
};

/// The answer to one frame.
struct FrameResult {
  std::int64_t t_ns = 0;
  TrackingState state = TrackingState::initializing;
  TrackerKind tracker = TrackerKind::none;
  SwitchReason switch_reason = SwitchReason::none;
  /// Camera in world. Meaningful while state is tracking; else the last known pose. The world is
  /// the first keyframe's camera frame (x right, y down, z forward), its unit arbitrary.
  Pose T_world_cam;
  /// The same pose relative to a keyframe of the map: it stays right when the map is corrected.
  std::uint64_t reference_keyframe = 0;
  Pose T_ref_cam;
  /// MapView::Keyframe::scale of the keyframe when T_ref_cam was measured. When it is another one
  /// now, T_ref_cam's translation is to be multiplied by (scale now / reference_scale).
  double reference_scale = 1.0;
  double confidence = 0.0;           ///< 0..1, share of agreeing landmarks, 0 unless tracking
  std::uint64_t map_revision = 0;    ///< of Session::frameMap()
  std::uint64_t map_generation = 0;  ///< MapView::generation of the pose's world
  std::optional<WorldCorrection> correction;  ///< since the frame before
  InitializationProgress initialization;
  FrameStats stats;
};

}  // namespace glide
