#include "replay/outputs/report_truth.h"

#include "replay/evaluation/accuracy.h"

#include <gtest/gtest.h>

#include <cmath>

namespace glide::replay {
namespace {

constexpr std::int64_t kPeriodNs = 50'000'000;
constexpr double kMetersPerUnit = 2.5;
const Eigen::Quaterniond kUpright = Eigen::Quaterniond::Identity();

Trajectory curve(int poses) {
  Trajectory trajectory;
  for (int i = 0; i < poses; ++i) {
    const double a = 0.1 * i;
    trajectory.push_back({i * kPeriodNs, {kUpright, Vec3d(std::cos(a), std::sin(a), 0.2 * a)}});
  }
  return trajectory;
}

/// The curve as another instrument saw it: turned, moved, in metres.
Trajectory inMeters(const Trajectory& trajectory) {
  const SE3d T{so3Exp(Vec3d(0.3, -0.7, 1.1)), Vec3d(5, 6, 7)};
  Trajectory truth;
  for (const StampedPose& pose : trajectory) {
    truth.push_back({pose.t_ns, {kUpright, T * Vec3d(kMetersPerUnit * pose.T_world_rig.t)}});
  }
  return truth;
}

TEST(ReportTruth, LiesOnTheTrajectoryThatItIsTheTruthOf) {
  const Trajectory trajectory = curve(60);
  const auto truth = reportTruth(inMeters(trajectory), trajectory);
  ASSERT_TRUE(truth);
  EXPECT_NEAR(truth->meters_per_unit, kMetersPerUnit, 1e-9);
  ASSERT_EQ(truth->matched.size(), trajectory.size());
  ASSERT_EQ(truth->path.size(), 3 * trajectory.size());
  for (std::size_t i = 0; i < trajectory.size(); ++i) {
    const Vec3d& p_world = trajectory[i].T_world_rig.t;
    for (int axis = 0; axis < 3; ++axis) {
      const auto k = static_cast<std::size_t>(axis);
      EXPECT_NEAR(truth->matched[i][k], p_world[axis], 1e-6);
      EXPECT_NEAR(truth->path[3 * i + k], p_world[axis], 1e-6);
    }
  }
}

TEST(ReportTruth, GivesTheErrorsWhoseMeanSquareIsTheAte) {
  Trajectory trajectory = curve(60);
  const Trajectory truth = inMeters(trajectory);
  for (std::size_t i = 0; i < trajectory.size(); ++i) {
    trajectory[i].T_world_rig.t.x() += 0.05 * std::sin(static_cast<double>(i));
  }
  const auto shown = reportTruth(truth, trajectory);
  ASSERT_TRUE(shown);
  double sum = 0.0;
  for (std::size_t i = 0; i < trajectory.size(); ++i) {
    const auto& p = shown->matched[i];
    sum += (Vec3d(p[0], p[1], p[2]) - trajectory[i].T_world_rig.t).squaredNorm();
  }
  const double rmse = shown->meters_per_unit * std::sqrt(sum / 60.0);
  EXPECT_NEAR(rmse, absoluteError(truth, trajectory)->rmse_m, 1e-6);
}

TEST(ReportTruth, HasNoPositionWhereNoTruthIsNear) {
  const Trajectory trajectory = curve(60);
  Trajectory truth = inMeters(trajectory);
  truth.erase(truth.begin() + 20, truth.begin() + 30);
  const auto shown = reportTruth(truth, trajectory);
  ASSERT_TRUE(shown);
  EXPECT_FALSE(std::isnan(shown->matched[19][0]));
  EXPECT_TRUE(std::isnan(shown->matched[25][0]));
  EXPECT_FALSE(std::isnan(shown->matched[30][0]));
}

TEST(ReportTruth, ShowsOnlyTheTimeOfTheTrajectoryAndNoMorePointsThanAScreenHas) {
  const Trajectory whole = curve(9000);
  const Trajectory part(whole.begin() + 1000, whole.begin() + 8000);
  const auto shown = reportTruth(inMeters(whole), part);
  ASSERT_TRUE(shown);
  EXPECT_LE(shown->path.size(), 3U * 2001U);
  EXPECT_GE(shown->path.size(), 3U * 1000U);
  EXPECT_NEAR(shown->path[2], whole[1000].T_world_rig.t.z(), 1e-4);
}

TEST(ReportTruth, IsNoneWhenThereIsNothingToAlign) {
  EXPECT_FALSE(reportTruth({}, {}));
  EXPECT_FALSE(reportTruth(curve(10), {}));
  EXPECT_FALSE(reportTruth(curve(2), curve(2)));
}

}  // namespace
}  // namespace glide::replay
