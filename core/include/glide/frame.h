#pragma once

#include "glide/types.h"

#include <cstddef>
#include <cstdint>
#include <optional>

namespace glide {

/// An 8-bit gray image that the caller owns; read only during Session::update.
struct Luma {
  const std::uint8_t* pixels = nullptr;
  int width = 0;              ///< px
  int height = 0;             ///< px
  std::ptrdiff_t stride = 0;  ///< bytes from one row to the next, at least width
};

/// One camera frame.
struct FrameInput {
  std::int64_t t_ns = 0;  ///< nanoseconds in the camera's clock, strictly increasing
  Luma image;
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
  int visible = 0;   ///< landmarks of the tracker that lie in the image
  int inliers = 0;   ///< of these, the ones that agree with the pose
  double rms = 0.0;  ///< direct: robust patch error, grey levels; indirect: reprojection error, px
  bool keyframe = false;  ///< this frame was handed to the mapper
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
  Pose T_world_cam;      ///< camera in world, scene units; the last known pose when not valid
  bool valid = false;    ///< the pose is worth using
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
  double confidence = 0.0;  ///< 0..1, share of agreeing landmarks, 0 unless tracking
  std::uint64_t map_revision = 0;
  std::optional<WorldCorrection> correction;  ///< since the frame before
  InitializationProgress initialization;
  FrameStats stats;
};

}  // namespace glide
