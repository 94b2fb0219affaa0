#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace glide {

/// A rigid transform. Named `T_a_b` where it is used: it maps points of frame b into frame a.
/// The unit of length is arbitrary (monocular scale) unless stated otherwise.
struct Pose {
  std::array<double, 3> t_xyz{0.0, 0.0, 0.0};
  std::array<double, 4> q_xyzw{0.0, 0.0, 0.0, 1.0};
};

/// Lens models. Pixel (0,0) is the centre of the first pixel; camera axes are x right, y down, z
/// forward.
enum class DistortionModel {
  none,               ///< Pinhole; no coefficients.
  radial_tangential,  ///< Brown-Conrady as in OpenCV: k1, k2, p1, p2[, k3].
  kannala_brandt4,    ///< Equidistant fisheye as in OpenCV: k1, k2, k3, k4.
};

/// Calibration of the camera at the resolution of the frames given to Session::update.
struct CameraIntrinsics {
  int width = 0;                                  ///< px
  int height = 0;                                 ///< px
  double fx = 0.0, fy = 0.0, cx = 0.0, cy = 0.0;  ///< px
  DistortionModel distortion = DistortionModel::none;
  std::vector<double> coefficients;  ///< Unitless; count as the model says (0, 4 or 5).
};

/// Life of a session.
enum class TrackingState {
  initializing,  ///< No map yet; FrameResult::initialization says why not.
  tracking,      ///< The pose of this frame is known.
  lost,          ///< There is a map, but this frame could not be placed in it.
  paused,        ///< Session::pause was called; frames are not looked at.
};

/// Who made the pose of a frame.
enum class TrackerKind { none, direct, indirect };

/// What the direct tracker's stage times mean.
enum class StageTimer {
  cpu,    ///< Wall clock of CPU work.
  sync,   ///< Wall clock of GL calls; the alignment ends with its fence.
  query,  ///< The GPU's own clock (GL_EXT_disjoint_timer_query).
};

/// Why a frame's pose came from the indirect tracker (or from none). ALGORITHMS section 2.
enum class SwitchReason {
  none,               ///< The direct tracker's pose was accepted.
  no_reference,       ///< There was no reference to track against yet.
  solve_failed,       ///< The photometric solve was not finite or not positive definite.
  too_few_visible,    ///< Too small a share of the reference's points is still in view.
  photometric_error,  ///< The robust patch error exceeds the switching threshold.
  baseline,           ///< Translation relative to the scene depth exceeds its threshold.
  rotation,           ///< Rotation since the reference exceeds its threshold.
  max_direct_frames,  ///< The reference has served for its maximum number of frames.
  disabled,           ///< The session runs with TrackerMode::indirect.
};

/// Why there is no map yet.
enum class InitializationStatus {
  done,               ///< A map exists.
  waiting_for_image,  ///< Fewer features than needed: dark, blurred or blank image.
  too_few_matches,    ///< The view changed too much or too fast since the first image.
  too_little_motion,  ///< Move the camera sideways.
  pure_rotation,      ///< The camera turned but did not move: move it sideways.
  ambiguous,          ///< Two explanations fit equally well; keep moving.
};

}  // namespace glide
