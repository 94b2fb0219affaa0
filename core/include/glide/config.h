#pragma once

#include "glide/result.h"
#include "glide/types.h"
#include "glide/version.h"

#include <string>

namespace glide {

/// Where the direct tracker runs.
enum class Backend {
  automatic,  ///< gles when a hardware ES 3.1 context is current, else cpu. Never a software GL.
  gles,       ///< OpenGL ES 3.1 compute in the context that is current in Session::update.
  cpu,        ///< Vectorised CPU code.
};

enum class TrackerMode {
  hybrid,    ///< Direct tracker first, indirect tracker when it is refused.
  indirect,  ///< Every frame by the indirect tracker (for comparison).
};

enum class Execution {
  threaded,  ///< Mapping runs on its own thread.
  inline_,   ///< Mapping runs inside update(): slower frames, the same bytes on every run.
};

enum class PhotometricModel {
  none,       ///< Brightness constancy.
  gain_bias,  ///< One gain and one bias per frame, estimated with the pose.
};

enum class HessianMode {
  robust,    ///< H is reduced anew with each iteration's weights and visibility.
  constant,  ///< The paper's: H is computed once per reference.
};

/// What a session does with its map.
enum class SessionMode {
  slam,               ///< Extends and corrects it.
  localization_only,  ///< Only finds the camera in it; needs a map from Session::loadMap.
};

enum class LoopClosing {
  on,   ///< Places seen again correct the map.
  off,  ///< Visual odometry with relocalisation (for comparison).
};

/// Whether the calibration of the lens is only a start.
enum class CalibrationRefinement {
  on,   ///< The map corrects k1 when it is sure that the calibration is off
        ///< (MapView::corrected_camera).
  off,  ///< The calibration is used as given.
};

/// Whether Session::trackedPoints is filled.
enum class ReportPoints {
  off,       ///< It stays empty and costs nothing.
  indirect,  ///< On indirect frames: microseconds.
  on,        ///< Always: each direct frame is compared with its reference once more, on the CPU.
};

/// What a call does to the GL state of the app's context (docs/gl-contract.md).
enum class GlStatePolicy {
  preserve,  ///< Every piece of state is put back as it was found.
  reset,     ///< What was touched is put to the initial values of OpenGL ES.
  none,      ///< What was touched stays as the last kernel left it.
};

/// When a session makes its GL objects.
enum class GlCreation {
  at_create,        ///< In Session::create, which needs the context and says what it lacks.
  at_first_update,  ///< In the first update(); create() needs no context.
};

/// How the direct tracker's kernels are cut into commands.
enum class GpuPlanChoice {
  automatic,  ///< What is fastest on the device (Config::Gl::autotune).
  fused,      ///< Few commands: fused reductions, coarse levels inside one workgroup.
  paper,      ///< The structure of the paper's section III (for comparison).
};

/// Whether group sizes and kernels are tried on the device at creation (docs/gpu-tuning.md).
enum class GpuAutotune {
  on,   ///< Once per device, driver, image size and patch: up to 300 ms; then from gl.cache_dir.
        ///< Without a cache_dir, and with Execution::inline_: as off.
  off,  ///< What the cache knows of the device, else the defaults.
};

/// Everything that can be tuned. Each field has its unit and range beside it; config_fields.h lists
/// the same fields by name, and validate() checks them. Plain data: copy and edit.
struct Config {
  CameraIntrinsics camera;
  Backend backend = Backend::automatic;
  TrackerMode tracker = TrackerMode::hybrid;
  Execution execution = Execution::threaded;
  SessionMode mode = SessionMode::slam;
  ReportPoints tracked_points = ReportPoints::off;

  /// The photometric tracker of tween frames.
  struct Direct {
    int patch_size = 11;      ///< px, odd, 5..15
    int levels = 6;           ///< pyramid levels, 1..8
    int max_iterations = 10;  ///< per level, 1..50
    PhotometricModel photometric = PhotometricModel::gain_bias;
    HessianMode hessian = HessianMode::robust;
    double huber_factor = 1.5;      ///< Huber threshold over the mean patch RMS, 0.5..10
    double huber_floor = 3.0;       ///< grey levels; the threshold is never lower, 0.1..100
    double convergence = 1e-5;      ///< norm of the twist (scene units, radians), 1e-9..1e-1
    int min_points = 15;            ///< fewer visible points make a solve invalid, 6..1000
    int max_points = 400;           ///< points per reference, 15..4096
    int max_direct_frames = 12;     ///< frames per reference, 1..1000
    double max_rms = 25.0;          ///< grey levels, switching threshold of the patch error, 1..255
    double max_rms_contrast = 1.0;  ///< patch error over the reference's own contrast, 0.05..10
    double max_rms_growth = 2.5;    ///< patch error over that of the frame before, 1.1..100
    double max_baseline = 0.12;     ///< translation over median depth, 0.001..10
    double max_rotation_deg = 15.0;  ///< degrees, 0.1..180
    double min_visible_ratio = 0.6;  ///< share of the reference's points, 0..1
    double min_inlier_ratio = 0.5;   ///< share of the visible points within Huber, 0..1
  } direct;

  /// FAST corners with steered binary descriptors.
  struct Features {
    int count = 1000;                 ///< features per frame while tracking, 100..10000
    int initialization_count = 2000;  ///< features per frame while initialising, 100..10000
    int levels = 8;                   ///< scale levels, 1..12
    double scale_factor = 1.2;        ///< between levels, 1.05..2
    int fast_threshold = 20;          ///< grey levels, first try per cell, 2..255
    int fast_threshold_low = 7;       ///< grey levels, second try per cell, 1..255
  } features;

  /// Two-view start.
  struct Initialization {
    int min_matches = 100;          ///< between the two views, 20..10000
    int min_landmarks = 50;         ///< triangulated with parallax, 10..10000
    double min_parallax_deg = 1.5;  ///< degrees, 0.1..30
    double sigma_px = 0.6;          ///< px, noise of aligned corners, 0.1..10
    double median_depth = 1.0;   ///< scene units given to the first map's median depth, 1e-3..1e3
    int max_reference_age = 60;  ///< frames before the first view is replaced, 2..10000
  } initialization;

  /// Feature tracking against the map.
  struct Indirect {
    int min_inliers = 25;              ///< fewer matched landmarks make the frame lost, 6..1000
    double search_radius_px = 7.0;     ///< px at level 0, 1..100
    int max_descriptor_distance = 64;  ///< bits of 256, 1..256
    double ratio = 0.85;               ///< best over second-best descriptor distance, 0.1..1
    int max_local_landmarks = 2500;    ///< landmarks projected per frame, 100..100000
  } indirect;

  /// When an indirect frame becomes a keyframe.
  struct Keyframes {
    int min_interval = 3;            ///< frames since the last keyframe, 0..1000
    int max_interval = 30;           ///< frames; then any useful frame is taken, 1..100000
    double min_tracked_ratio = 0.8;  ///< matched landmarks over the reference keyframe's, 0..1
    double min_baseline = 0.04;      ///< translation over median depth, 0..10
    int min_tracked = 50;  ///< matched landmarks; below this a keyframe is urgent, 0..10000
  } keyframes;

  /// Map maintenance.
  struct Mapping {
    int neighbors = 12;         ///< covisible keyframes searched for new landmarks, 1..100
    int local_keyframes = 20;   ///< keyframes optimised by local BA, 2..200
    int min_covisibility = 15;  ///< shared landmarks that make two keyframes neighbours, 1..1000
    double min_parallax_deg = 1.0;  ///< degrees, for a new landmark, 0.05..30
    double redundant_ratio =
        0.9;                 ///< share of landmarks seen elsewhere that culls a keyframe, 0.1..1
    int ba_iterations = 10;  ///< per local BA, 1..200
    int queue_capacity = 3;  ///< keyframes waiting for the mapper, 1..100
  } mapping;

  /// The lens.
  struct Calibration {
    CalibrationRefinement refinement = CalibrationRefinement::on;
  } calibration;

  /// Places seen again.
  struct Loop {
    LoopClosing closing = LoopClosing::on;
  } loop;

  /// The OpenGL ES backend.
  struct Gl {
    GlStatePolicy state = GlStatePolicy::preserve;
    GlCreation creation = GlCreation::at_create;
    GpuPlanChoice plan = GpuPlanChoice::automatic;
    GpuAutotune autotune = GpuAutotune::on;
    /// Folder of program binaries and of what the autotuner chose; made when it is missing. Empty:
    /// nothing is kept. On Android an app gives its cache folder.
    std::string cache_dir;
  } gl;
};

/// Ok, or an invalid_argument error that names the first field out of its range.
GLIDE_API Status validate(const Config& config);

}  // namespace glide
