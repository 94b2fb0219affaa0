#include "optimize/residuals.h"

#include "support/synthetic_problem.h"

#include <gmock/gmock.h>

#include <functional>

namespace glide {
namespace {

constexpr double kStep = 1e-6;       // of the central differences
constexpr double kTolerance = 1e-5;  // px per unit, relative to entries of some hundreds
const Vec2d kPixel(300.0, 200.0);
constexpr double kInvSigma = 0.7;

class ReprojectionResidual : public testing::TestWithParam<DistortionModel> {
 protected:
  /// Central differences of the residual by a tangent vector.
  template <int N>
  Eigen::Matrix<double, 2, N> differentiate(
      const std::function<Vec3d(const Eigen::Matrix<double, N, 1>&)>& p_cam_of) const {
    Eigen::Matrix<double, 2, N> J;
    for (int i = 0; i < N; ++i) {
      const Eigen::Matrix<double, N, 1> delta = kStep * Eigen::Matrix<double, N, 1>::Unit(i);
      J.col(i) = (residual(p_cam_of(delta)) - residual(p_cam_of(-delta))) / (2.0 * kStep);
    }
    return J;
  }
  Vec2d residual(const Vec3d& p_cam) const {
    return reprojectionResidual(lens, p_cam, kPixel, kInvSigma).value();
  }

  const CameraModel lens = test::syntheticCamera(GetParam());
  const SE3d T_cam_world = SE3d::exp((Vec6d() << 0.3, -0.2, 0.5, 0.1, 0.4, -0.3).finished());
  const std::vector<Vec3d> points_cam = {
      {0.0, 0.0, 2.0}, {0.9, -0.6, 2.0}, {-1.1, 0.8, 1.7}, {0.2, 1.0, 9.0}};
};

TEST_P(ReprojectionResidual, IsThePixelErrorInSigmas) {
  for (const Vec3d& p_cam : points_cam) {
    const Vec2d expected = kInvSigma * (lens.project(p_cam).value() - kPixel);
    EXPECT_LT((residual(p_cam) - expected).norm(), 1e-12);
    EXPECT_EQ(linearizeReprojection(lens, p_cam, kPixel, kInvSigma)->r, residual(p_cam));
  }
}

TEST_P(ReprojectionResidual, DiffersByTheCameraPointAsCentralDifferencesDo) {
  for (const Vec3d& p_cam : points_cam) {
    const auto lin = linearizeReprojection(lens, p_cam, kPixel, kInvSigma).value();
    const Mat23d numeric = differentiate<3>([&](const Vec3d& d) -> Vec3d { return p_cam + d; });
    EXPECT_LT((lin.J_r_point - numeric).norm(), kTolerance);
  }
}

TEST_P(ReprojectionResidual, DiffersByThePoseAsCentralDifferencesOfALeftPerturbationDo) {
  for (const Vec3d& p_cam : points_cam) {
    const Vec3d p_world = T_cam_world.inverse() * p_cam;
    const auto lin = linearizeReprojection(lens, p_cam, kPixel, kInvSigma).value();
    const Mat26d numeric = differentiate<6>(
        [&](const Vec6d& d) -> Vec3d { return SE3d::exp(d) * T_cam_world * p_world; });
    EXPECT_LT((leftPoseJacobian(lin.J_r_point, p_cam) - numeric).norm(), kTolerance);
  }
}

TEST_P(ReprojectionResidual, IsNothingBehindTheCameraOrForNumbersThatAreNotFinite) {
  const Vec3d behind(0.1, 0.1, -1.0);
  const Vec3d visible(0.1, 0.1, 1.0);
  const Vec2d nan(NAN, 0.0);
  EXPECT_FALSE(reprojectionResidual(lens, behind, kPixel, 1.0));
  EXPECT_FALSE(linearizeReprojection(lens, behind, kPixel, 1.0));
  EXPECT_FALSE(reprojectionResidual(lens, visible, nan, 1.0));
  EXPECT_FALSE(linearizeReprojection(lens, visible, nan, 1.0));
}

INSTANTIATE_TEST_SUITE_P(AllCameraModels,
                         ReprojectionResidual,
                         testing::Values(DistortionModel::none,
                                         DistortionModel::radial_tangential,
                                         DistortionModel::kannala_brandt4));

}  // namespace
}  // namespace glide
