#include "capi/conversion.h"

#include "geometry/pose_conversion.h"

#include "glide/config_text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace glide {
namespace {

// glide/glide.h includes no GL header; these are GL_TEXTURE_2D and GL_TEXTURE_EXTERNAL_OES.
constexpr std::uint32_t kTexture2d = 0x0DE1;
constexpr std::uint32_t kTextureExternal = 0x8D65;

// OpenXR's tolerance of a quaternion's length.
constexpr double kQuaternionTolerance = 0.01;
// A landmark that so many keyframes see besides the two that made it is half as good as can be.
constexpr double kHalfConfidence = 2.0;
constexpr double kRadPerDeg = 3.14159265358979323846 / 180.0;

Error invalid(const std::string& what) { return {ErrorCode::invalid_argument, what}; }

/// The C number of an enum whose values stand in the C ABI's order, as asserted below.
template <class E>
constexpr std::int32_t numberOf(E value) {
  return static_cast<std::int32_t>(value);
}
static_assert(numberOf(DistortionModel::none) == GLIDE_DISTORTION_NONE);
static_assert(numberOf(DistortionModel::radial_tangential) == GLIDE_DISTORTION_RADTAN);
static_assert(numberOf(DistortionModel::kannala_brandt4) == GLIDE_DISTORTION_KANNALA_BRANDT4);
static_assert(numberOf(TrackingState::initializing) == GLIDE_STATE_INITIALIZING);
static_assert(numberOf(TrackingState::tracking) == GLIDE_STATE_TRACKING);
static_assert(numberOf(TrackingState::lost) == GLIDE_STATE_LOST);
static_assert(numberOf(TrackingState::paused) == GLIDE_STATE_PAUSED);
static_assert(numberOf(TrackerKind::none) == GLIDE_TRACKER_NONE);
static_assert(numberOf(TrackerKind::direct) == GLIDE_TRACKER_DIRECT);
static_assert(numberOf(TrackerKind::indirect) == GLIDE_TRACKER_INDIRECT);
static_assert(numberOf(SwitchReason::none) == GLIDE_SWITCH_NONE);
static_assert(numberOf(SwitchReason::no_reference) == GLIDE_SWITCH_NO_REFERENCE);
static_assert(numberOf(SwitchReason::solve_failed) == GLIDE_SWITCH_SOLVE_FAILED);
static_assert(numberOf(SwitchReason::too_few_visible) == GLIDE_SWITCH_TOO_FEW_VISIBLE);
static_assert(numberOf(SwitchReason::photometric_error) == GLIDE_SWITCH_PHOTOMETRIC_ERROR);
static_assert(numberOf(SwitchReason::baseline) == GLIDE_SWITCH_BASELINE);
static_assert(numberOf(SwitchReason::rotation) == GLIDE_SWITCH_ROTATION);
static_assert(numberOf(SwitchReason::max_direct_frames) == GLIDE_SWITCH_MAX_DIRECT_FRAMES);
static_assert(numberOf(SwitchReason::disabled) == GLIDE_SWITCH_DISABLED);

/// The enum's value for a C number; nothing beyond the last.
template <class E, std::size_t n>
std::optional<E> pick(const std::array<E, n>& values, std::int32_t number) {
  if (number < 0 || static_cast<std::size_t>(number) >= n) return std::nullopt;
  return values[static_cast<std::size_t>(number)];
}

Result<CameraIntrinsics> toIntrinsics(const glide_intrinsics& camera) {
  constexpr std::array kModels{
      DistortionModel::none, DistortionModel::radial_tangential, DistortionModel::kannala_brandt4};
  const std::optional<DistortionModel> model = pick(kModels, camera.distortion);
  if (!model) return invalid("camera.distortion is no GLIDE_DISTORTION_*");
  constexpr auto kMost = static_cast<std::int32_t>(std::size(glide_intrinsics{}.coefficients));
  if (camera.coefficient_count < 0 || camera.coefficient_count > kMost)
    return invalid("camera.coefficient_count is outside 0.." + std::to_string(kMost));
  CameraIntrinsics result;
  result.width = camera.width;
  result.height = camera.height;
  result.fx = camera.fx;
  result.fy = camera.fy;
  result.cx = camera.cx;
  result.cy = camera.cy;
  result.distortion = *model;
  result.coefficients.assign(camera.coefficients, camera.coefficients + camera.coefficient_count);
  return result;
}

Status applySettings(const glide_config& given, Config* config) {
  if (given.settings == nullptr && given.setting_count > 0)
    return invalid("settings is null, but setting_count is not zero");
  if (given.settings != nullptr && given.setting_count == 0)
    return invalid("settings is given, but setting_count is zero");
  for (std::uint32_t i = 0; i < given.setting_count; ++i) {
    if (given.settings[i] == nullptr) return invalid("settings[" + std::to_string(i) + "] is null");
    Status applied = applySetting(*config, given.settings[i]);
    if (!applied) return applied;
  }
  return Unit{};
}

TextureTransform transformOf(const glide_image& image) {
  TextureTransform transform{};
  std::copy_n(image.transform, transform.size(), transform.begin());
  const bool is_given =
      std::any_of(transform.begin(), transform.end(), [](float value) { return value != 0.0F; });
  return is_given ? transform : kUpperRowFirst;
}

std::int32_t reasonOf(const FrameResult& result) {
  if (result.state == TrackingState::lost) return GLIDE_REASON_RELOCALIZING;
  if (result.state != TrackingState::initializing) return GLIDE_REASON_NONE;
  switch (result.initialization.status) {
    case InitializationStatus::waiting_for_image:
      return GLIDE_REASON_INSUFFICIENT_FEATURES;
    case InitializationStatus::too_few_matches:
      return GLIDE_REASON_EXCESSIVE_MOTION;
    case InitializationStatus::too_little_motion:
    case InitializationStatus::pure_rotation:
      return GLIDE_REASON_INSUFFICIENT_PARALLAX;
    case InitializationStatus::ambiguous:
      return GLIDE_REASON_AMBIGUOUS;
    case InitializationStatus::done:
      break;
  }
  return GLIDE_REASON_NONE;
}

void copyCorrection(const WorldCorrection& correction, const AppWorld& world, glide_frame* frame) {
  frame->world_corrected = 1;
  frame->correction_distance = static_cast<float>(world.scale() * correction.translation);
  frame->correction_rotation = static_cast<float>(correction.rotation_deg * kRadPerDeg);
  frame->correction_scale = static_cast<float>(correction.scale);
}

}  // namespace

Result<Config> toConfig(const glide_config& given) {
  constexpr std::array kBackends{Backend::automatic, Backend::gles, Backend::cpu};
  constexpr std::array kModes{SessionMode::slam, SessionMode::localization_only};
  constexpr std::array kExecutions{Execution::threaded, Execution::inline_};
  const auto backend = pick(kBackends, given.backend);
  const auto mode = pick(kModes, given.mode);
  const auto execution = pick(kExecutions, given.execution);
  if (!backend) return invalid("backend is no GLIDE_BACKEND_*");
  if (!mode) return invalid("mode is no GLIDE_MODE_*");
  if (!execution) return invalid("execution is no GLIDE_EXECUTION_*");
  Config config;
  config.backend = *backend;
  config.mode = *mode;
  config.execution = *execution;
  config.gl.creation = GlCreation::at_first_update;
  Result<CameraIntrinsics> camera = toIntrinsics(given.camera);
  if (!camera) return camera.error();
  config.camera = *std::move(camera);
  const Status applied = applySettings(given, &config);
  if (!applied) return applied.error();
  return config;
}

Result<FrameInput> toFrameInput(const glide_image& image) {
  FrameInput input;
  input.t_ns = image.t_ns;
  input.exposure_ns = image.exposure_ns;
  input.rolling_shutter_skew_ns = image.rolling_shutter_skew_ns;
  switch (image.kind) {
    case GLIDE_IMAGE_LUMA8:
      input.image = Luma{
          image.pixels, image.width, image.height, static_cast<std::ptrdiff_t>(image.row_stride)};
      return input;
    case GLIDE_IMAGE_TEXTURE_2D:
    case GLIDE_IMAGE_TEXTURE_EXTERNAL:
      input.image = Texture{image.texture,
                            image.kind == GLIDE_IMAGE_TEXTURE_2D ? kTexture2d : kTextureExternal,
                            image.width,
                            image.height,
                            transformOf(image)};
      return input;
    case GLIDE_IMAGE_HARDWARE_BUFFER:
      input.image =
          HardwareBuffer{static_cast<AHardwareBuffer*>(image.hardware_buffer), transformOf(image)};
      return input;
    default:
      return invalid("image.kind is no GLIDE_IMAGE_*");
  }
}

glide_pose toC(const SE3d& T) {
  return {{T.q.x(), T.q.y(), T.q.z(), T.q.w()}, {T.t.x(), T.t.y(), T.t.z()}};
}

SE3d fromC(const glide_pose& pose) {
  const double* q = pose.q;
  return {Eigen::Quaterniond(q[3], q[0], q[1], q[2]).normalized(),
          Vec3d(pose.p[0], pose.p[1], pose.p[2])};
}

bool isSound(const glide_pose& pose) {
  double squared_length = 0.0;
  for (const double q : pose.q) squared_length += q * q;
  const bool is_finite =
      std::all_of(std::begin(pose.p), std::end(pose.p), [](double p) { return std::isfinite(p); });
  return is_finite && std::abs(std::sqrt(squared_length) - 1.0) <= kQuaternionTolerance;
}

glide_frame toC(const FrameResult& result, const AppWorld& world) {
  const auto f = [](double value) { return static_cast<float>(value); };
  glide_frame frame{};
  frame.state = numberOf(result.state);
  frame.reason = reasonOf(result);
  frame.tracker = numberOf(result.tracker);
  frame.t_ns = result.t_ns;
  frame.camera = toC(world.cameraToApp(fromPose(result.T_world_cam)));
  frame.confidence = f(result.confidence);
  frame.keyframe = result.stats.keyframe ? 1 : 0;
  frame.map_revision = result.map_revision;
  frame.map_generation = result.map_generation;
  frame.correction_scale = 1.0F;
  if (result.correction) copyCorrection(*result.correction, world, &frame);
  frame.visible = result.stats.visible;
  frame.inliers = result.stats.inliers;
  frame.update_ms = f(result.stats.update_ms);
  frame.pyramid_ms = f(result.stats.pyramid_ms);
  frame.precompute_ms = f(result.stats.precompute_ms);
  frame.align_ms = f(result.stats.align_ms);
  frame.features_ms = f(result.stats.features_ms);
  frame.match_ms = f(result.stats.match_ms);
  frame.pose_ms = f(result.stats.pose_ms);
  frame.mapping_ms = f(result.stats.mapping_ms);
  frame.readback_ms = f(result.stats.readback_ms);
  frame.rms = f(result.stats.rms);
  frame.switch_reason = numberOf(result.switch_reason);
  frame.start_matches = result.initialization.matches;
  frame.start_parallax_deg = f(result.initialization.parallax_deg);
  frame.start_landmarks = result.initialization.landmarks;
  return frame;
}

glide_location toC(const LocatedCamera& located, const AppWorld& world) {
  glide_location location{};
  if (located.valid) location.flags |= GLIDE_LOCATION_VALID;
  if (located.tracked) location.flags |= GLIDE_LOCATION_TRACKED;
  location.t_ns = located.t_ns;
  location.camera = toC(world.cameraToApp(fromPose(located.T_world_cam)));
  return location;
}

glide_intrinsics toC(const CameraIntrinsics& camera) {
  glide_intrinsics result{};
  result.width = camera.width;
  result.height = camera.height;
  result.fx = camera.fx;
  result.fy = camera.fy;
  result.cx = camera.cx;
  result.cy = camera.cy;
  result.distortion = numberOf(camera.distortion);
  const std::size_t count =
      std::min(camera.coefficients.size(), std::size(glide_intrinsics{}.coefficients));
  result.coefficient_count = static_cast<std::int32_t>(count);
  std::copy_n(camera.coefficients.begin(), count, result.coefficients);
  return result;
}

glide_keyframe toC(const MapView::Keyframe& keyframe, const AppWorld& world) {
  return {keyframe.id,
          keyframe.t_ns,
          toC(world.cameraToApp(fromPose(keyframe.T_world_cam))),
          keyframe.retired ? 1 : 0,
          0};
}

glide_point toC(const MapView::Landmark& landmark, const AppWorld& world) {
  const auto& p = landmark.p_world;
  const Vec3d p_app = world.pointToApp({p[0], p[1], p[2]});
  const double others = std::max(0, landmark.observations - 1);
  return {static_cast<float>(p_app.x()),
          static_cast<float>(p_app.y()),
          static_cast<float>(p_app.z()),
          static_cast<float>(others / (others + kHalfConfidence)),
          landmark.id};
}

glide_tracked_point toC(const TrackedPoint& point) {
  return {point.landmark, point.u, point.v, point.residual, point.inlier ? 1 : 0};
}

}  // namespace glide
