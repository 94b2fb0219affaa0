#include "geometry/camera_model.h"

#include "unit/geometry/random_geometry.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace glide {
namespace {

using ::testing::HasSubstr;

CameraIntrinsics pinhole() {
  return {640, 480, 500.0, 510.0, 320.5, 239.0, DistortionModel::none, {}};
}

CameraIntrinsics euroc() {
  return {752,
          480,
          458.654,
          457.296,
          367.215,
          248.375,
          DistortionModel::radial_tangential,
          {-0.28340811, 0.07395907, 0.00019359, 1.76187114e-05}};
}

/// fr3-like with a third radial coefficient.
CameraIntrinsics fiveCoefficients() {
  return {640,
          480,
          517.306408,
          516.469215,
          318.643040,
          255.313989,
          DistortionModel::radial_tangential,
          {0.262383, -0.953104, -0.005358, 0.002628, 1.163314}};
}

/// The camera of desk_fisheye_400.
CameraIntrinsics fisheye() {
  return {320,
          240,
          192.49339078,
          193.60543407,
          162.0,
          125.0,
          DistortionModel::kannala_brandt4,
          {-0.00233426, -0.07807222, 0.08845117, -0.03281482}};
}

/// A wide phone lens whose model reaches past 90 degrees.
CameraIntrinsics wideFisheye() {
  return {640,
          640,
          180.0,
          180.0,
          320.0,
          320.0,
          DistortionModel::kannala_brandt4,
          {0.02, -0.005, 0.001, -0.0001}};
}

struct NamedCamera {
  std::string name;
  CameraIntrinsics intrinsics;
};

class EveryCamera : public ::testing::TestWithParam<NamedCamera> {
 protected:
  CameraModel camera() const { return CameraModel::create(GetParam().intrinsics).value(); }
};

INSTANTIATE_TEST_SUITE_P(CameraModel,
                         EveryCamera,
                         ::testing::Values(NamedCamera{"pinhole", pinhole()},
                                           NamedCamera{"euroc", euroc()},
                                           NamedCamera{"five", fiveCoefficients()},
                                           NamedCamera{"fisheye", fisheye()},
                                           NamedCamera{"wide", wideFisheye()}),
                         [](const auto& suite) { return suite.param.name; });

TEST_P(EveryCamera, ProjectsTheBearingOfEveryPixelBackOntoIt) {
  const CameraModel camera = this->camera();
  constexpr int kStep = 3;
  double worst = 0.0;
  for (int v = 0; v < camera.height(); v += kStep) {
    for (int u = 0; u < camera.width(); u += kStep) {
      const Vec2d uv(u, v);
      const std::optional<Vec3d> bearing = camera.unproject(uv);
      ASSERT_TRUE(bearing) << u << " " << v;
      EXPECT_NEAR(bearing->norm(), 1.0, 1e-14);
      const std::optional<Vec2d> back = camera.project(7.5 * *bearing);
      ASSERT_TRUE(back) << u << " " << v;
      worst = std::max(worst, (*back - uv).norm());
    }
  }
  EXPECT_LT(worst, 1e-9);
}

TEST_P(EveryCamera, JacobianIsTheDerivativeOfProject) {
  const CameraModel camera = this->camera();
  test::RandomGeometry random(1);
  for (int i = 0; i < 200; ++i) {
    const Vec2d uv(random.uniform(0.0, camera.width()), random.uniform(0.0, camera.height()));
    const Vec3d p = *camera.unproject(uv) * random.uniform(0.3, 20.0);
    const std::optional<Projection> projection = camera.projectWithJacobian(p);
    ASSERT_TRUE(projection);
    EXPECT_LT((projection->uv - *camera.project(p)).norm(), 1e-11);
    const double step = 1e-6 * p.norm();
    for (int axis = 0; axis < 3; ++axis) {
      const Vec3d offset = step * Vec3d::Unit(axis);
      const Vec2d numeric =
          (*camera.project(p + offset) - *camera.project(p - offset)) / (2.0 * step);
      const double scale = camera.fx() / p.norm();
      EXPECT_LT((projection->J_uv_point.col(axis) - numeric).norm(), 2e-6 * scale) << p.transpose();
    }
  }
}

TEST_P(EveryCamera, JacobianOnTheOpticalAxisIsThePinholes) {
  const CameraModel camera = this->camera();
  const std::optional<Projection> projection = camera.projectWithJacobian(Vec3d(0.0, 0.0, 2.0));
  ASSERT_TRUE(projection);
  Mat23d expected;
  expected << camera.fx() / 2.0, 0.0, 0.0, 0.0, camera.fy() / 2.0, 0.0;
  EXPECT_LT((projection->J_uv_point - expected).norm(), 1e-12);
  EXPECT_LT((projection->uv - Vec2d(camera.cx(), camera.cy())).norm(), 1e-12);
}

TEST_P(EveryCamera, LevelsHalveThePixelExactly) {
  const CameraModel camera = this->camera();
  const Vec3d p(0.31, -0.22, 1.7);
  for (int level = 0; level < 6; ++level) {
    const CameraModel small = camera.atLevel(level);
    EXPECT_LT((*small.project(p) * std::ldexp(1.0, level) - *camera.project(p)).norm(), 1e-10);
  }
}

TEST_P(EveryCamera, RefusesPointsBehindIt) {
  const CameraModel camera = this->camera();
  EXPECT_FALSE(camera.project(Vec3d(0.0, 0.0, -1.0)));
  EXPECT_FALSE(camera.project(Vec3d(0.0, 0.0, 0.0)));
  EXPECT_FALSE(camera.projectWithJacobian(Vec3d(0.0, 0.0, -1.0)));
  EXPECT_FALSE(camera.projectWithJacobian(Vec3d(0.0, 0.0, 0.0)));
}

TEST_P(EveryCamera, RefusesValuesThatAreNoNumbers) {
  const CameraModel camera = this->camera();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(camera.project(Vec3d(nan, 0.0, 1.0)));
  EXPECT_FALSE(camera.projectWithJacobian(Vec3d(0.0, nan, 1.0)));
  EXPECT_FALSE(camera.project(Vec3d(0.0, 1.0, nan)));
}

TEST(CameraModel, PinholeIsTheFormula) {
  const CameraModel camera = CameraModel::create(pinhole()).value();
  EXPECT_LT((*camera.project(Vec3d(1.0, -2.0, 4.0)) - Vec2d(445.5, -16.0)).norm(), 1e-12);
  EXPECT_EQ(camera.maxRadius(), std::numeric_limits<double>::infinity());
}

// Expected pixels by cv::projectPoints and cv::fisheye::projectPoints of OpenCV 4.6.
TEST(CameraModel, AgreesWithOpenCv) {
  const Vec3d p(0.4, -0.3, 1.0);
  const Vec3d q(-0.9, 0.5, 1.3);
  const CameraModel four = CameraModel::create(euroc()).value();
  EXPECT_LT((*four.project(p) - Vec2d(538.5093105639, 120.3082907155)).norm(), 1e-9);
  EXPECT_LT((*four.project(q) - Vec2d(96.8558076404, 398.1881687202)).norm(), 1e-9);
  const CameraModel five = CameraModel::create(fiveCoefficients()).value();
  EXPECT_LT((*five.project(p) - Vec2d(532.0139788878, 95.1074493180)).norm(), 1e-9);
  EXPECT_LT((*five.project(q) - Vec2d(-63.3166656384, 465.9076924086)).norm(), 1e-9);
  const CameraModel fish = CameraModel::create(fisheye()).value();
  EXPECT_LT((*fish.project(p) - Vec2d(233.1635884369, 71.3189721470)).norm(), 1e-9);
  EXPECT_LT((*fish.project(q) - Vec2d(50.4275452642, 187.3427855593)).norm(), 1e-9);
}

TEST(CameraModel, ProjectsBeyondNinetyDegreesThroughAWideFisheye) {
  const CameraModel camera = CameraModel::create(wideFisheye()).value();
  const Vec3d p = Vec3d(1.0, 0.0, std::cos(1.7) / std::sin(1.7));
  ASSERT_LT(p.z(), 0.0);
  const std::optional<Vec2d> uv = camera.project(p);
  ASSERT_TRUE(uv);
  EXPECT_LT((*camera.unproject(*uv) - p.normalized()).norm(), 1e-12);
}

TEST(CameraModel, RefusesRaysBeyondTheFoldOfTheDistortion) {
  CameraIntrinsics intrinsics = pinhole();
  intrinsics.distortion = DistortionModel::radial_tangential;
  intrinsics.coefficients = {-0.3, 0.0, 0.0, 0.0};  // r (1 - 0.3 r^2) turns at r^2 = 1 / 0.9
  const CameraModel camera = CameraModel::create(intrinsics).value();
  EXPECT_NEAR(camera.maxRadius(), 1.0 / 0.9, 1e-12);
  EXPECT_TRUE(camera.project(Vec3d(1.05, 0.0, 1.0)));
  EXPECT_FALSE(camera.project(Vec3d(1.06, 0.0, 1.0)));
  EXPECT_FALSE(camera.projectWithJacobian(Vec3d(1.06, 0.0, 1.0)));
  const double fold = std::sqrt(1.0 / 0.9) * (2.0 / 3.0) * camera.fx() + camera.cx();
  EXPECT_TRUE(camera.unproject(Vec2d(fold - 1.0, camera.cy())));
  EXPECT_FALSE(camera.unproject(Vec2d(fold + 1.0, camera.cy())));
}

TEST(CameraModel, FindsTheLargestAngleOfAFisheye) {
  const CameraModel folding = CameraModel::create(fisheye()).value();
  const double limit = folding.maxRadius();
  EXPECT_GT(limit, 0.9);
  EXPECT_LT(limit, 3.15);
  EXPECT_TRUE(folding.project(Vec3d(std::sin(limit - 1e-6), 0.0, std::cos(limit - 1e-6))));
  EXPECT_FALSE(folding.project(Vec3d(std::sin(limit + 1e-6), 0.0, std::cos(limit + 1e-6))));
}

TEST(CameraModel, LevelSizesRoundUp) {
  const CameraModel camera = CameraModel::create(euroc()).value();
  EXPECT_EQ(camera.atLevel(5).width(), 24);
  EXPECT_EQ(camera.atLevel(5).height(), 15);
  CameraIntrinsics odd = pinhole();
  odd.width = 641;
  odd.height = 479;
  const CameraModel small = CameraModel::create(odd).value().atLevel(1);
  EXPECT_EQ(small.width(), 321);
  EXPECT_EQ(small.height(), 240);
}

TEST(CameraModel, KnowsWhatIsInsideOfTheImage) {
  const CameraModel camera = CameraModel::create(pinhole()).value();
  EXPECT_TRUE(camera.isInImage(Vec2d(0.0, 0.0), 0.0));
  EXPECT_TRUE(camera.isInImage(Vec2d(639.0, 479.0), 0.0));
  EXPECT_FALSE(camera.isInImage(Vec2d(639.5, 100.0), 0.0));
  EXPECT_FALSE(camera.isInImage(Vec2d(3.0, 100.0), 4.0));
}

struct BadField {
  std::string field;
  CameraIntrinsics intrinsics;
};

std::vector<BadField> badFields() {
  std::vector<BadField> bad;
  const auto add = [&](const std::string& field, const CameraIntrinsics& base, auto change) {
    CameraIntrinsics intrinsics = base;
    change(intrinsics);
    bad.push_back({field, intrinsics});
  };
  using C = CameraIntrinsics;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  add("width", pinhole(), [](C& c) { c.width = 0; });
  add("height", pinhole(), [](C& c) { c.height = -1; });
  add("fx", pinhole(), [](C& c) { c.fx = 0.0; });
  add("fy", pinhole(), [&](C& c) { c.fy = nan; });
  add("cx", pinhole(), [&](C& c) { c.cx = nan; });
  add("cx", pinhole(), [&](C& c) { c.cx = 12.0 * c.width; });
  add("cy", pinhole(), [&](C& c) { c.cy = -1.5 * c.height; });
  add("cy", pinhole(), [](C& c) { c.cy = std::numeric_limits<double>::infinity(); });
  add("coefficients", pinhole(), [](C& c) { c.coefficients = {0.1}; });
  add("coefficients", euroc(), [](C& c) { c.coefficients.resize(3); });
  add("coefficients", fisheye(), [](C& c) { c.coefficients.resize(5); });
  add("coefficients", fisheye(), [&](C& c) { c.coefficients[1] = nan; });
  return bad;
}

TEST(CameraModel, NamesTheFieldThatIsWrong) {
  for (const BadField& bad : badFields()) {
    const Result<CameraModel> camera = CameraModel::create(bad.intrinsics);
    ASSERT_FALSE(camera.ok()) << bad.field;
    EXPECT_EQ(camera.error().code, ErrorCode::invalid_argument);
    EXPECT_THAT(camera.error().message, HasSubstr("camera." + bad.field));
  }
}

}  // namespace
}  // namespace glide
