#include "optimize/radial_calibration.h"

#include "support/bundle_case.h"

#include <gmock/gmock.h>

#include <atomic>
#include <cmath>
#include <cstdint>
#include <vector>

namespace glide {
namespace {

using testing::DoubleNear;

constexpr BundleOptions kOptions{.max_iterations = 20};

/// What cameras behind `lens` saw, up to its edges; only the first is fixed, so that the scale is
/// free.
BundleProblem bundleSeenBy(const CameraModel& lens, double noise_px, std::uint64_t seed) {
  test::SyntheticOptions options{.cameras = 8, .points = 150, .arc_radius = 2.5};
  options.noise_px = noise_px;
  options.seed = seed;
  BundleProblem problem = test::makeBundleCase(lens, options).problem;
  problem.cameras[1].fixed = false;
  return problem;
}

double rms(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value * value;
  return std::sqrt(sum / static_cast<double>(values.size()));
}

class RadialCalibration : public testing::TestWithParam<DistortionModel> {
 protected:
  const CameraModel lens = test::syntheticCamera(GetParam());
};

TEST_P(RadialCalibration, FindsWhatTheCalibrationLacks) {
  const BundleProblem problem = bundleSeenBy(lens, 0.0, 1);
  for (const double error : {-0.01, 0.01}) {
    const auto found = estimateRadial(withRadial(lens, -error), kOptions, problem);
    ASSERT_TRUE(found.has_value());
    EXPECT_THAT(found->dk1, DoubleNear(error, 0.01 * std::abs(error)));
    EXPECT_GT(found->shift_px, 0.2);
  }
}

TEST_P(RadialCalibration, FindsNothingWhereTheCalibrationIsRight) {
  const auto found = estimateRadial(lens, kOptions, bundleSeenBy(lens, 0.0, 1));
  ASSERT_TRUE(found.has_value());
  EXPECT_THAT(found->dk1, DoubleNear(0.0, 1e-6));
  EXPECT_THAT(found->shift_px, DoubleNear(0.0, 1e-4));
}

TEST_P(RadialCalibration, IsAsUncertainAsItSays) {
  std::vector<double> sigmas_off;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    const auto found = estimateRadial(lens, kOptions, bundleSeenBy(lens, 1.0, seed));
    if (found) sigmas_off.push_back(found->dk1 / found->sigma);
  }
  // It may say nothing: for one of 180 bundles the two last slopes were too inexact to go on.
  ASSERT_GE(sigmas_off.size(), 11U);
  EXPECT_THAT(rms(sigmas_off), DoubleNear(1.0, 0.5));
}

TEST_P(RadialCalibration, AddsACubeOfTheAngleToTheRadius) {
  const CameraModel changed = withRadial(lens, 0.01);
  const Vec3d p_cam(0.12, -0.16, 1.0);
  const bool is_fisheye = GetParam() == DistortionModel::kannala_brandt4;
  const double radius = is_fisheye ? std::atan(0.2) : 0.2;
  const Vec2d moved = *changed.project(p_cam) - *lens.project(p_cam);
  const double expected = 0.01 * std::pow(radius, 3);
  EXPECT_THAT(std::hypot(moved.x() / lens.fx(), moved.y() / lens.fy()),
              DoubleNear(expected, 1e-12));
}

TEST_P(RadialCalibration, SaysNothingWhenItIsCancelled) {
  const std::atomic<bool> cancel{true};
  BundleOptions options = kOptions;
  options.cancel = &cancel;
  EXPECT_FALSE(estimateRadial(lens, options, bundleSeenBy(lens, 0.0, 1)).has_value());
}

INSTANTIATE_TEST_SUITE_P(Lenses,
                         RadialCalibration,
                         testing::Values(DistortionModel::none,
                                         DistortionModel::radial_tangential,
                                         DistortionModel::kannala_brandt4));

TEST(RadialCalibrationOfNothing, IsNothing) {
  const CameraModel lens = test::syntheticCamera(DistortionModel::none);
  EXPECT_FALSE(estimateRadial(lens, kOptions, BundleProblem()).has_value());
}

}  // namespace
}  // namespace glide
