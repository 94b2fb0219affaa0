#include "optimize/reprojection_cost.h"

#include "support/synthetic_problem.h"

#include "optimize/residuals.h"

#include <gmock/gmock.h>

namespace glide {
namespace {

constexpr double kStep = 1e-6;
constexpr double kTolerance = 1e-5;

const SE3d& poseUnderTest() {
  static const SE3d T_cam_world = SE3d::exp((Vec6d() << 0.3, -0.2, 0.5, 0.1, 0.4, -0.3).finished());
  return T_cam_world;
}

TEST(PoseBlock, KeepsThePose) {
  const SE3d back = fromPoseBlock(toPoseBlock(poseUnderTest()).data());
  EXPECT_EQ(back.q.coeffs(), poseUnderTest().q.coeffs());
  EXPECT_EQ(back.t, poseUnderTest().t);
}

TEST(LeftPoseManifold, MovesFromTheLeftAndMinusUndoesPlus) {
  const LeftPoseManifold manifold{};
  const Vec6d delta = (Vec6d() << 0.05, 0.1, -0.2, 0.3, -0.1, 0.2).finished();
  const Vec7d x = toPoseBlock(poseUnderTest());
  Vec7d moved;
  ASSERT_TRUE(manifold.Plus(x.data(), delta.data(), moved.data()));
  const SE3d expected = SE3d::exp(delta) * poseUnderTest();
  EXPECT_LT((fromPoseBlock(moved.data()) * expected.inverse()).log().norm(), 1e-12);
  Vec6d back;
  ASSERT_TRUE(manifold.Minus(moved.data(), x.data(), back.data()));
  EXPECT_LT((back - delta).norm(), 1e-12);
}

TEST(LeftPoseManifold, RefusesAStepThatIsNotFinite) {
  const LeftPoseManifold manifold{};
  const Vec6d delta = Vec6d::Constant(NAN);
  const Vec7d x = toPoseBlock(poseUnderTest());
  Vec7d moved;
  EXPECT_FALSE(manifold.Plus(x.data(), delta.data(), moved.data()));
}

class ReprojectionCostTest : public testing::TestWithParam<DistortionModel> {
 protected:
  Vec2d residual(const Vec7d& pose, const Vec3d& point) const {
    const double* parameters[] = {pose.data(), point.data()};
    Vec2d r;
    EXPECT_TRUE(cost.Evaluate(parameters, r.data(), nullptr));
    return r;
  }
  Vec2d residualMoved(const Vec6d& delta) const {
    Vec7d moved;
    EXPECT_TRUE(manifold.Plus(pose_block.data(), delta.data(), moved.data()));
    return residual(moved, p_world);
  }

  const CameraModel lens = test::syntheticCamera(GetParam());
  const ReprojectionCost cost{lens, Vec2d(300.0, 200.0), 0.7};
  const LeftPoseManifold manifold{};
  const Vec7d pose_block = toPoseBlock(poseUnderTest());
  const Vec3d p_world = poseUnderTest().inverse() * Vec3d(0.9, -0.6, 2.0);
};

TEST_P(ReprojectionCostTest, HasTheDerivativesOfCentralDifferencesOnTheManifold) {
  Eigen::Matrix<double, 2, 7, Eigen::RowMajor> J_ambient;
  Eigen::Matrix<double, 7, 6, Eigen::RowMajor> plus;
  Eigen::Matrix<double, 2, 3, Eigen::RowMajor> J_point;
  const double* parameters[] = {pose_block.data(), p_world.data()};
  double* jacobians[] = {J_ambient.data(), J_point.data()};
  Vec2d r;
  ASSERT_TRUE(cost.Evaluate(parameters, r.data(), jacobians));
  ASSERT_TRUE(manifold.PlusJacobian(pose_block.data(), plus.data()));
  EXPECT_EQ(r, residual(pose_block, p_world));

  for (int i = 0; i < 6; ++i) {
    const Vec6d d = kStep * Vec6d::Unit(i);
    const Vec2d numeric = (residualMoved(d) - residualMoved(-d)) / (2.0 * kStep);
    EXPECT_LT(((J_ambient * plus).col(i) - numeric).norm(), kTolerance);
  }
  for (int i = 0; i < 3; ++i) {
    const Vec3d d = kStep * Vec3d::Unit(i);
    const Vec2d numeric =
        (residual(pose_block, p_world + d) - residual(pose_block, p_world - d)) / (2.0 * kStep);
    EXPECT_LT((J_point.col(i) - numeric).norm(), kTolerance);
  }
}

TEST_P(ReprojectionCostTest, ChargesAPointThatDoesNotProjectWithoutAGradient) {
  const Vec3d behind = poseUnderTest().inverse() * Vec3d(0.0, 0.1, -2.0);
  Eigen::Matrix<double, 2, 7, Eigen::RowMajor> J_ambient;
  Eigen::Matrix<double, 2, 3, Eigen::RowMajor> J_point;
  const double* parameters[] = {pose_block.data(), behind.data()};
  double* jacobians[] = {J_ambient.data(), J_point.data()};
  Vec2d r;
  ASSERT_TRUE(cost.Evaluate(parameters, r.data(), jacobians));
  EXPECT_DOUBLE_EQ(r.norm(), kUnprojectableNorm);
  EXPECT_EQ(J_ambient.norm(), 0.0);
  EXPECT_EQ(J_point.norm(), 0.0);
}

TEST_P(ReprojectionCostTest, WritesOnlyTheDerivativesThatAreAskedFor) {
  Eigen::Matrix<double, 2, 3, Eigen::RowMajor> J_point = Eigen::Matrix<double, 2, 3>::Zero();
  const double* parameters[] = {pose_block.data(), p_world.data()};
  double* jacobians[] = {nullptr, J_point.data()};
  Vec2d r;
  ASSERT_TRUE(cost.Evaluate(parameters, r.data(), jacobians));
  EXPECT_GT(J_point.norm(), 0.0);
}

INSTANTIATE_TEST_SUITE_P(AllCameraModels,
                         ReprojectionCostTest,
                         testing::Values(DistortionModel::none,
                                         DistortionModel::radial_tangential,
                                         DistortionModel::kannala_brandt4));

}  // namespace
}  // namespace glide
