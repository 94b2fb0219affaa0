#include "replay/evaluation/trajectory.h"

#include "replay/common/text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace glide::replay {
namespace {

using ::testing::HasSubstr;

Result<GroundTruth> read(const std::string& text) {
  const auto file = std::filesystem::path(testing::TempDir()) / "glide_trajectory_test.txt";
  EXPECT_TRUE(writeFile(file, text).ok());
  return readGroundTruth(file);
}

std::string faultOf(const std::string& text) {
  const auto truth = read(text);
  return truth ? "" : truth.error().message;
}

TEST(GroundTruth, ReadsTumAsTheCamerasPoses) {
  const auto truth = read("# time\n1.5 1 2 3 0 0 0.7071068 0.7071068\n");
  ASSERT_TRUE(truth.ok());
  EXPECT_EQ(truth->rig, RigFrame::camera);
  ASSERT_EQ(truth->poses.size(), 1u);
  EXPECT_EQ(truth->poses[0].t_ns, 1500000000);
  const Vec3d p_world = truth->poses[0].T_world_rig * Vec3d(1, 0, 0);
  EXPECT_LT((p_world - Vec3d(1, 3, 3)).norm(), 1e-6);
}

TEST(GroundTruth, ReadsEurocAsTheBodysPosesWithWFirst) {
  const auto truth =
      read("#timestamp, p, q, v\n1403636584763555584,1,2,3,0.7071068,0,0,0.7071068,0.1,0.2,0.3\n");
  ASSERT_TRUE(truth.ok());
  EXPECT_EQ(truth->rig, RigFrame::body);
  EXPECT_EQ(truth->poses[0].t_ns, 1403636584763555584);
  const Vec3d p_world = truth->poses[0].T_world_rig * Vec3d(1, 0, 0);
  EXPECT_LT((p_world - Vec3d(1, 3, 3)).norm(), 1e-6);
}

TEST(GroundTruth, IsSortedByTime) {
  const auto truth = read("2 0 0 0 0 0 0 1\n1 0 0 0 0 0 0 1\n");
  EXPECT_EQ(truth->poses[0].t_ns, 1000000000);
}

TEST(GroundTruth, NormalisesRoundedQuaternions) {
  const auto truth = read("1 0 0 0 0.0003 0.8617 -0.5072 -0.0145\n");
  EXPECT_NEAR(truth->poses[0].T_world_rig.q.norm(), 1.0, 1e-12);
}

TEST(GroundTruth, NamesTheBrokenLine) {
  EXPECT_THAT(faultOf("1 0 0 0 0 0 0 1\n2 0 0 0\n"), HasSubstr("test.txt:2: expected a time"));
  EXPECT_THAT(faultOf("1 0 0 x 0 0 0 1\n"), HasSubstr("test.txt:1: has an entry that is not"));
  EXPECT_THAT(faultOf("1 0 0 0 0 0 0 0\n"), HasSubstr("test.txt:1: the quaternion is zero"));
  EXPECT_THAT(faultOf("# nothing\n"), HasSubstr("has no pose"));
  EXPECT_FALSE(readGroundTruth("/no/such/file").ok());
}

TEST(TumText, IsReadBackToTheLastDigit) {
  SE3d T_world_cam = SE3d::exp((Vec6d() << 1.25, -2.5, 3.75, 0.1, 0.2, -0.3).finished());
  const Trajectory written = {{1403636584763555584, T_world_cam}};
  const auto truth = read(tumText(written));
  ASSERT_TRUE(truth.ok());
  EXPECT_EQ(truth->poses[0].t_ns, written[0].t_ns);
  const SE3d difference = truth->poses[0].T_world_rig.inverse() * T_world_cam;
  EXPECT_LT(difference.log().norm(), 1e-8);
}

TEST(InFrame, AppendsTheTransformOnTheRight) {
  const SE3d T_world_body = SE3d::exp((Vec6d() << 1, 0, 0, 0, 0, 1.5707963267948966).finished());
  const SE3d T_body_cam{Eigen::Quaterniond::Identity(), Vec3d(0.5, 0, 0)};
  const Trajectory cam = inFrame({{0, T_world_body}}, T_body_cam);
  const Vec3d expected = T_world_body * Vec3d(0.5, 0, 0);
  EXPECT_LT((cam[0].T_world_rig.t - expected).norm(), 1e-12);
}

}  // namespace
}  // namespace glide::replay
