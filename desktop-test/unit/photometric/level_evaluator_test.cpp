#include "photometric/level_evaluator.h"

#include "unit/photometric/align_fixture.h"
#include "unit/photometric/smooth_image.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace glide {
namespace {

using test::bilinear;
using test::twist;

/// One level with a reference image and a different frame, and random points in view.
struct Level {
  CameraModel camera = test::makeCamera(DistortionModel::radial_tangential, 160, 120);
  Config::Direct config;
  Pyramid reference_image;
  ImageF frame = test::smoothImage(160, 120, 0.7);
  std::vector<AlignPoint> points;
  ReferenceCache reference;
  SE3d T_cam_ref = SE3d::exp(twist({0.02, -0.03, 0.01}, {0.01, 0.02, -0.02}));

  explicit Level(int patch_size) {
    config.patch_size = patch_size;
    reference_image.levels.push_back(test::smoothImage(160, 120, 0.3));
    std::mt19937 random(11);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    for (int i = 0; i < 60; ++i) {
      const double u = 160.0 * unit(random);
      const double v = 120.0 * unit(random);
      points.push_back({(1.0 + 2.0 * unit(random)) * *camera.unproject(Vec2d(u, v))});
    }
    const PatchLayout layout = PatchLayout::ofSize(patch_size);
    buildReferenceCache(reference_image, camera, layout, points, &reference);
  }

  LevelPair pair() const { return {frame, camera, reference, reference.levels[0]}; }
  AlignState freshState() const {
    return {T_cam_ref, 1.0, 0.0, std::vector<double>(points.size(), 1.0)};
  }
};

std::vector<double> patchAt(const ImageF& image, const Vec2d& uv, int size) {
  std::vector<double> grey;
  grey.reserve(static_cast<std::size_t>(size) * static_cast<std::size_t>(size));
  for (int k = 0; k < size * size; ++k) {
    const Vec2d at = uv + test::patchOffset(k, size);
    grey.push_back(bilinear(image, at.x(), at.y()));
  }
  return grey;
}

double meanOf(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

double variationOf(const std::vector<double>& values) {
  const double mean = meanOf(values);
  double sum = 0.0;
  for (const double value : values) sum += (value - mean) * (value - mean);
  return sum;
}

/// The derivation page's iteration with explicit residuals, pixel by pixel, in double.
struct PlainEvaluation {
  struct Point {
    std::size_t index;
    Vec3d p_ref;
    Vec2d uv_ref;
    std::vector<double> reference, frame;
    double rho = 0.0;
  };
  std::vector<Point> visible;
  double gain = 1.0, bias = 0.0, rms = 0.0;
  int inliers = 0;
  NormalEquations normals;
};

std::vector<PlainEvaluation::Point> visiblePoints(const Level& level, const SE3d& T_cam_ref) {
  const int size = level.config.patch_size;
  const int half = size / 2;
  std::vector<PlainEvaluation::Point> out;
  for (const std::size_t index : level.reference.levels[0].point) {
    const Vec3d p_ref = level.points[index].p_ref;
    const Vec2d uv_ref = *level.camera.project(p_ref);
    const std::optional<Vec2d> uv = level.camera.project(T_cam_ref * p_ref);
    if (!uv || uv->x() < half || uv->y() < half || uv->x() >= 160 - half - 1 ||
        uv->y() >= 120 - half - 1) {
      continue;
    }
    out.push_back({index,
                   p_ref,
                   uv_ref,
                   patchAt(level.reference_image.levels[0], uv_ref, size),
                   patchAt(level.frame, *uv, size)});
  }
  return out;
}

void plainExposure(const std::vector<double>& weights, PlainEvaluation* out) {
  double frame = 0.0, reference = 0.0, frame_mean = 0.0, reference_mean = 0.0, total = 0.0;
  for (const auto& point : out->visible) {
    const double w = weights[point.index];
    frame += w * variationOf(point.frame);
    reference += w * variationOf(point.reference);
    frame_mean += w * meanOf(point.frame);
    reference_mean += w * meanOf(point.reference);
    total += w;
  }
  out->gain = std::clamp(std::sqrt(frame / reference), 0.2, 5.0);
  out->bias = (frame_mean - out->gain * reference_mean) / total;
}

/// The rows of a point's Jacobian, from central differences of plain samples.
Eigen::MatrixXd plainJacobian(const Level& level, const PlainEvaluation::Point& point) {
  const ImageF& image = level.reference_image.levels[0];
  const int size = level.config.patch_size;
  Mat26d J_uv;
  J_uv << level.camera.projectWithJacobian(point.p_ref)->J_uv_point,
      -level.camera.projectWithJacobian(point.p_ref)->J_uv_point * skew(point.p_ref);
  const std::vector<double> right = patchAt(image, point.uv_ref + Vec2d(1.0, 0.0), size);
  const std::vector<double> left = patchAt(image, point.uv_ref - Vec2d(1.0, 0.0), size);
  const std::vector<double> below = patchAt(image, point.uv_ref + Vec2d(0.0, 1.0), size);
  const std::vector<double> above = patchAt(image, point.uv_ref - Vec2d(0.0, 1.0), size);
  Eigen::MatrixXd J(size * size, 6);
  for (int k = 0; k < size * size; ++k) {
    const auto at = static_cast<std::size_t>(k);
    J.row(k) =
        0.5 * (right[at] - left[at]) * J_uv.row(0) + 0.5 * (below[at] - above[at]) * J_uv.row(1);
  }
  return J;
}

Eigen::VectorXd residuals(const PlainEvaluation::Point& point, double gain, double bias) {
  Eigen::VectorXd r(static_cast<Eigen::Index>(point.frame.size()));
  for (std::size_t k = 0; k < point.frame.size(); ++k) {
    r(static_cast<Eigen::Index>(k)) = (point.frame[k] - bias) / gain - point.reference[k];
  }
  return r;
}

PlainEvaluation plainEvaluate(const Level& level, std::vector<double>* weights) {
  PlainEvaluation out;
  out.visible = visiblePoints(level, level.T_cam_ref);
  plainExposure(*weights, &out);
  double weighted = 0.0, total = 0.0;
  for (auto& point : out.visible) {
    const Eigen::VectorXd r = residuals(point, out.gain, out.bias);
    point.rho = std::sqrt(r.squaredNorm() / static_cast<double>(r.size()));
    weighted += (*weights)[point.index] * point.rho;
    total += (*weights)[point.index];
  }
  const double threshold =
      std::max(level.config.huber_factor * weighted / total, level.config.huber_floor);
  double new_total = 0.0;
  for (const auto& point : out.visible) {
    const double w = std::min(1.0, threshold / point.rho);
    const Eigen::MatrixXd J = plainJacobian(level, point);
    (*weights)[point.index] = w;
    new_total += w;
    out.rms += w * point.rho;
    out.inliers += point.rho <= threshold ? 1 : 0;
    out.normals.H += w * J.transpose() * J;
    out.normals.b += w * J.transpose() * residuals(point, out.gain, out.bias);
  }
  out.rms /= new_total;
  return out;
}

class LevelEvaluatorOfPatch : public testing::TestWithParam<int> {};

TEST_P(LevelEvaluatorOfPatch, EqualsThePlainSumsOverPixels) {
  const Level level(GetParam());
  LevelEvaluator evaluator(level.config);
  AlignState state = level.freshState();
  std::vector<double> weights = state.weights;
  for (int iteration = 0; iteration < 3; ++iteration) {  // the weights of one feed the next
    const std::optional<Evaluation> evaluation = evaluator.evaluate(level.pair(), &state);
    const PlainEvaluation plain = plainEvaluate(level, &weights);
    ASSERT_TRUE(evaluation);
    EXPECT_EQ(evaluation->visible, static_cast<int>(plain.visible.size()));
    EXPECT_EQ(evaluation->inliers, plain.inliers);
    EXPECT_NEAR(state.gain, plain.gain, 1e-4);
    EXPECT_NEAR(state.bias, plain.bias, 1e-2);
    EXPECT_NEAR(evaluation->rms, plain.rms, 1e-3);
    EXPECT_TRUE(evaluation->normals.H.isApprox(plain.normals.H, 1e-4));
    EXPECT_TRUE(evaluation->normals.b.isApprox(plain.normals.b, 1e-3));
    for (std::size_t i = 0; i < weights.size(); ++i)
      EXPECT_NEAR(state.weights[i], weights[i], 1e-4);
  }
}

INSTANTIATE_TEST_SUITE_P(OddSizes, LevelEvaluatorOfPatch, testing::Values(5, 7, 11, 15));

TEST(LevelEvaluator, HasTheNegativeGradientOfTheCostAsItsRightHandSide) {
  // d/d(delta) of sum w |r|^2 / 2 when exp(delta) moves the template's points is -b.
  constexpr double kStep = 1e-4;
  Level level(7);
  level.config.huber_floor = 1000.0;  // all weights one
  LevelEvaluator evaluator(level.config);
  AlignState state = level.freshState();
  const std::optional<Evaluation> evaluation = evaluator.evaluate(level.pair(), &state);
  ASSERT_TRUE(evaluation);

  const auto cost = [&](const Vec6d& delta) {
    double sum = 0.0;
    for (PlainEvaluation::Point& point : visiblePoints(level, level.T_cam_ref)) {
      const Vec2d uv = *level.camera.project(SE3d::exp(delta) * point.p_ref);
      point.reference = patchAt(level.reference_image.levels[0], uv, 7);
      sum += 0.5 * residuals(point, state.gain, state.bias).squaredNorm();
    }
    return sum;
  };
  Vec6d gradient;
  for (int j = 0; j < 6; ++j) {
    const Vec6d step = kStep * Vec6d::Unit(j);
    gradient(j) = (cost(step) - cost(-step)) / (2.0 * kStep);
  }
  EXPECT_LT((gradient + evaluation->normals.b).norm(), 0.02 * gradient.norm());
}

TEST(LevelEvaluator, StepsDownhillWithTheSignOfTheUpdate) {
  Level level(7);
  level.frame = level.reference_image.levels[0];  // the truth is the identity
  level.T_cam_ref = SE3d::exp(twist({0.01, -0.005, 0.01}, {0.004, 0.006, -0.004}));
  LevelEvaluator evaluator(level.config);
  AlignState state = level.freshState();
  const std::optional<Evaluation> before = evaluator.evaluate(level.pair(), &state);
  ASSERT_TRUE(before);
  state.T_cam_ref = state.T_cam_ref * SE3d::exp(-*solveNormals(before->normals));
  const std::optional<Evaluation> after = evaluator.evaluate(level.pair(), &state);
  ASSERT_TRUE(after);
  EXPECT_LT(after->rms, 0.3 * before->rms);
  EXPECT_LT(state.T_cam_ref.log().norm(), 0.5 * level.T_cam_ref.log().norm());
}

TEST(LevelEvaluator, KeepsTheWeightOfAPointThatIsNotVisible) {
  Level level(7);
  level.T_cam_ref = SE3d::exp(twist({0.0, 0.0, 0.0}, {0.0, 0.4, 0.0}));
  LevelEvaluator evaluator(level.config);
  AlignState state = level.freshState();
  state.weights.assign(state.weights.size(), 0.125);
  const std::optional<Evaluation> evaluation = evaluator.evaluate(level.pair(), &state);
  ASSERT_TRUE(evaluation);
  const auto kept = std::count(state.weights.begin(), state.weights.end(), 0.125);
  EXPECT_EQ(kept, static_cast<long>(level.points.size()) - evaluation->visible);
  EXPECT_GT(kept, 0);
}

TEST(LevelEvaluator, LeavesTheStateAloneWithTooFewVisiblePoints) {
  Level level(7);
  level.config.min_points = 1000;
  LevelEvaluator evaluator(level.config);
  AlignState state = level.freshState();
  state.gain = 1.5;
  EXPECT_FALSE(evaluator.evaluate(level.pair(), &state));
  EXPECT_EQ(state.gain, 1.5);
  EXPECT_EQ(state.weights, level.freshState().weights);
}

}  // namespace
}  // namespace glide
