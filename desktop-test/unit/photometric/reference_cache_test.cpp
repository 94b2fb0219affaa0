#include "photometric/reference_cache.h"

#include "unit/photometric/align_fixture.h"
#include "unit/photometric/smooth_image.h"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

namespace glide {
namespace {

using test::bilinear;
using test::makeCamera;

constexpr int kPatch = 7;
constexpr int kHalf = kPatch / 2;

/// Two smooth levels that belong to no common image: each level is tested by itself.
Pyramid smoothPyramid(const CameraModel& camera) {
  Pyramid pyramid;
  pyramid.levels.push_back(test::smoothImage(camera.width(), camera.height(), 0.3));
  pyramid.levels.push_back(
      test::smoothImage((camera.width() + 1) / 2, (camera.height() + 1) / 2, 1.1));
  return pyramid;
}

ReferenceCache cacheOf(const CameraModel& camera, const std::vector<AlignPoint>& points) {
  ReferenceCache cache;
  buildReferenceCache(smoothPyramid(camera), camera, PatchLayout::ofSize(kPatch), points, &cache);
  return cache;
}

AlignPoint pointAt(const CameraModel& camera, double u, double v, double depth) {
  const Vec3d bearing = *camera.unproject(Vec2d(u, v));
  return {bearing * depth / bearing.z()};
}

/// The patch's grey levels when exp(delta) moves its point, by plain sampling.
Eigen::VectorXd greyLevels(const ImageF& image,
                           const CameraModel& camera,
                           const Vec3d& p_ref,
                           const Vec6d& delta) {
  const Vec2d uv = *camera.project(SE3d::exp(delta) * p_ref);
  Eigen::VectorXd grey(kPatch * kPatch);
  for (int k = 0; k < kPatch * kPatch; ++k) {
    const Vec2d at = uv + test::patchOffset(k, kPatch);
    grey(k) = bilinear(image, at.x(), at.y());
  }
  return grey;
}

/// J^T J of a patch by central differences of plain samples.
Mat6d numericNormalMatrix(const ImageF& image, const CameraModel& camera, const Vec3d& p_ref) {
  constexpr double kStep = 0.004;  // about half a pixel: the gradient is a difference over two
  Eigen::MatrixXd J(kPatch * kPatch, 6);
  for (int j = 0; j < 6; ++j) {
    const Vec6d step = kStep * Vec6d::Unit(j);
    J.col(j) = (greyLevels(image, camera, p_ref, step) - greyLevels(image, camera, p_ref, -step)) /
               (2.0 * kStep);
  }
  return J.transpose() * J;
}

class ReferenceCacheOfLens : public testing::TestWithParam<DistortionModel> {};

TEST_P(ReferenceCacheOfLens, HasTheNormalMatrixOfTheNumericJacobian) {
  const CameraModel camera = makeCamera(GetParam(), 160, 120);
  const Pyramid pyramid = smoothPyramid(camera);
  const std::vector<AlignPoint> points{pointAt(camera, 50.2, 60.7, 1.2),
                                       pointAt(camera, 110.6, 40.3, 2.0)};
  const ReferenceCache cache = cacheOf(camera, points);
  for (std::size_t k = 0; k < 4; ++k) {
    const std::size_t l = k / 2;
    const std::size_t i = k % 2;
    const CameraModel level_camera = camera.atLevel(static_cast<int>(l));
    const Mat6d expected = numericNormalMatrix(pyramid.levels[l], level_camera, points[i].p_ref);
    const Mat6d H = unpackHessian(cache.levels[l].normals[i].H);
    EXPECT_LT((H - expected).norm(), 0.05 * expected.norm()) << "level " << l << " point " << i;
  }
}

INSTANTIATE_TEST_SUITE_P(Lenses,
                         ReferenceCacheOfLens,
                         testing::Values(DistortionModel::none,
                                         DistortionModel::radial_tangential,
                                         DistortionModel::kannala_brandt4));

TEST(ReferenceCache, TakesPatchesThatJustFitWithTheirGradients) {
  const CameraModel camera = makeCamera(DistortionModel::none, 160, 120);
  constexpr double kInside = 1e-6;
  constexpr double kFirst = kHalf + 1;
  const double last_x = 160 - kHalf - 2;
  const double last_y = 120 - kHalf - 2;
  const auto valid = [&](double u, double v) {
    return cacheOf(camera, {pointAt(camera, u, v, 1.0)}).levels[0].size() == 1;
  };
  EXPECT_TRUE(valid(kFirst + kInside, 60.0));
  EXPECT_FALSE(valid(kFirst - kInside, 60.0));
  EXPECT_TRUE(valid(80.0, kFirst + kInside));
  EXPECT_FALSE(valid(80.0, kFirst - kInside));
  EXPECT_TRUE(valid(last_x - kInside, last_y - kInside));
  EXPECT_FALSE(valid(last_x + kInside, 60.0));
  EXPECT_FALSE(valid(80.0, last_y + kInside));
}

TEST(ReferenceCache, DecidesValidityPerLevel) {
  const CameraModel camera = makeCamera(DistortionModel::none, 160, 120);
  const ReferenceCache cache =
      cacheOf(camera, {pointAt(camera, 5.0, 60.0, 1.0), pointAt(camera, 80.0, 60.0, 1.0)});
  EXPECT_EQ(cache.levels[0].point, (std::vector<std::size_t>{0, 1}));
  EXPECT_EQ(cache.levels[1].point, (std::vector<std::size_t>{1}));
}

TEST(ReferenceCache, LeavesOutPointsThatDoNotProject) {
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  const CameraModel camera = makeCamera(DistortionModel::radial_tangential, 160, 120);
  const ReferenceCache cache = cacheOf(camera,
                                       {{Vec3d(0.0, 0.0, -1.0)},
                                        {Vec3d(0.0, 0.0, 0.0)},
                                        {Vec3d(kNaN, 0.0, 1.0)},
                                        {Vec3d(0.0, 0.0, 1.0)}});
  for (const ReferenceLevel& level : cache.levels) {
    EXPECT_EQ(level.point, (std::vector<std::size_t>{3}));
  }
}

TEST(ReferenceCache, SumsTheNormalMatricesOfALevel) {
  const CameraModel camera = makeCamera(DistortionModel::none, 160, 120);
  const ReferenceCache cache =
      cacheOf(camera, {pointAt(camera, 40.0, 50.0, 1.0), pointAt(camera, 80.0, 60.0, 2.0)});
  const auto& normals = cache.levels[0].normals;
  EXPECT_EQ(cache.levels[0].H_all,
            Mat6d(unpackHessian(normals[0].H) + unpackHessian(normals[1].H)));
}

TEST(ReferenceCache, ForgetsTheReferenceBefore) {
  const CameraModel camera = makeCamera(DistortionModel::none, 160, 120);
  ReferenceCache cache;
  const PatchLayout layout = PatchLayout::ofSize(kPatch);
  const std::vector<AlignPoint> many(20, pointAt(camera, 60.0, 60.0, 1.0));
  const std::vector<AlignPoint> one{pointAt(camera, 50.0, 50.0, 1.0)};
  buildReferenceCache(smoothPyramid(camera), camera, layout, many, &cache);
  buildReferenceCache(smoothPyramid(camera), camera, layout, one, &cache);
  EXPECT_EQ(cache.points.size(), 1U);
  EXPECT_EQ(cache.levels[0].size(), 1);
  EXPECT_EQ(cache.levels[0].H_all, unpackHessian(cache.levels[0].normals[0].H));
}

}  // namespace
}  // namespace glide
