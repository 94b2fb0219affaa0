#include "mapping/self_calibration.h"

#include "mapping/window_adjustment.h"

#include "optimize/radial_calibration.h"

#include <cmath>
#include <optional>

namespace glide {
namespace {

// From one attempt to the next the map grows by a half: 8, 12, 18, 27, 40, 60 keyframes.
constexpr std::size_t nextSize(std::size_t size) { return size + size / 2; }
// What a map of this size has not told about the lens, a larger one tells no better.
constexpr std::size_t kLastSize = 60;
// Sigmas that a correction must be away from zero. A sigma counts on observations that are good to
// a pixel; aligned corners are four times better, which leaves room for errors of other kinds.
constexpr double kMinSigmas = 3.0;
// Corners must move by this much (RMS) for a correction to be worth it: three times what correct
// calibrations yield, a third of what spoils a map.
constexpr double kMinShiftPx = 0.75;
constexpr BundleOptions kOptions{.max_iterations = 20};

bool isWithinLimit(const CameraModel& camera, const CameraModel& given) {
  return std::abs(camera.coefficients()[0] - given.coefficients()[0]) <= kMaxRadialCorrection;
}

bool isWorthAdopting(const RadialCorrection& correction) {
  return std::abs(correction.dk1) >= kMinSigmas * correction.sigma &&
         correction.shift_px >= kMinShiftPx;
}

}  // namespace

bool SelfCalibration::update(MapperState* state) {
  const std::size_t size = state->map.keyframes().size();
  const bool is_wanted = state->config.calibration.refinement == CalibrationRefinement::on;
  if (!is_wanted || size < next_size_ || next_size_ > kLastSize) return false;
  next_size_ = nextSize(next_size_);

  const KeyframeId newest = state->map.keyframes().rbegin()->first;
  const AdjustmentWindow all = windowAround(state->map, newest, static_cast<int>(size));
  const std::optional<RadialCorrection> found =
      estimateRadial(state->camera, kOptions, bundleOf(state->map, all));
  if (!found || !isWorthAdopting(*found)) return false;
  const CameraModel corrected = withRadial(state->camera, found->dk1);
  if (!isWithinLimit(corrected, state->given_camera)) return false;
  state->useCamera(corrected);
  adjustWindow(state, all, kOptions);
  return true;
}

}  // namespace glide
