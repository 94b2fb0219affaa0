// shaders/camera.glsl against geometry/camera_model, shaders/rigid.glsl against geometry/lie.
#include "gpu/align_fixture.h"
#include "gpu/align_layout.h"
#include "gpu/compute_program.h"
#include "gpu/gl_state.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace glide {
std::span<const EmbeddedShader> testShaders();
}

namespace glide::test {
namespace {

constexpr int kGroupSize = 64;

class CameraShaderTest : public GlTest {};
class RigidShaderTest : public GlTest {};

/// A shader of desktop-test/gpu/shaders, which may include those of the library.
ComputeProgram buildTestShader(std::string_view name, const ShaderDefines& defines) {
  std::vector<EmbeddedShader> library(embeddedShaders().begin(), embeddedShaders().end());
  library.insert(library.end(), testShaders().begin(), testShaders().end());
  Result<std::string> text = assembleShader(library, name, defines);
  EXPECT_TRUE(text.ok());
  Result<ComputeProgram> program = ComputeProgram::compile(name, *text);
  EXPECT_TRUE(program.ok()) << program.error().message;
  return std::move(*program);
}

/// Runs a kernel with one item per invocation; buffer 0 in, buffer 1 out, the count at location 0.
std::vector<float> runItems(const ComputeProgram& program,
                            const std::vector<float>& items,
                            int count,
                            int floats_out) {
  const GlBuffer in = makeBuffer(items);
  const GlBuffer out = GlBuffer::allocate(
      static_cast<std::int64_t>(sizeof(float)) * count * floats_out, GL_DYNAMIC_COPY);
  program.use();
  glUniform1i(0, count);
  bindStorage(0, in);
  bindStorage(1, out);
  glDispatchCompute(groupCount(count, kGroupSize), 1, 1);
  return readBuffer<float>(out);
}

/// Points in front of, beside and behind the camera.
std::vector<Vec3d> randomPoints(int count) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> lateral(-2.0, 2.0);
  std::uniform_real_distribution<double> depth(-0.3, 3.0);
  std::vector<Vec3d> points{{0.0, 0.0, 1.5}, {0.0, 0.0, -1.0}, {1e-4, -1e-4, 2.0}};
  while (static_cast<int>(points.size()) < count) {
    points.emplace_back(lateral(random), lateral(random), depth(random));
  }
  return points;
}

/// Float rounding of the pixel (ulp of 1000 px is 6e-5) and of the angle of a fisheye.
constexpr double kPixelTolerance = 2e-3;
/// Of the largest entry of the Jacobian.
constexpr double kJacobianTolerance = 1e-4;
/// Near the edge of the model's range float and double may disagree about being inside.
constexpr double kEdge = 1e-4;

/// Whether a slightly different point is judged differently.
bool isOnTheEdge(const CameraModel& camera, const Vec3d& p_cam) {
  const bool ok = camera.project(p_cam).has_value();
  const Vec3d further(p_cam.x() * (1 + kEdge), p_cam.y() * (1 + kEdge), p_cam.z() - kEdge);
  const Vec3d closer(p_cam.x() * (1 - kEdge), p_cam.y() * (1 - kEdge), p_cam.z() + kEdge);
  return camera.project(further).has_value() != ok || camera.project(closer).has_value() != ok;
}

void expectSameProjection(const CameraModel& level_camera,
                          const Vec3d& p_cam,
                          const float* result) {
  const std::optional<Projection> expected = level_camera.projectWithJacobian(p_cam);
  ASSERT_EQ(result[0] > 0.5F, expected.has_value()) << p_cam.transpose();
  // Far outside of the image the polynomials explode; no patch is ever sampled there.
  if (!expected || !level_camera.isInImage(expected->uv, -level_camera.width())) return;
  EXPECT_NEAR(result[1], expected->uv.x(), kPixelTolerance) << p_cam.transpose();
  EXPECT_NEAR(result[2], expected->uv.y(), kPixelTolerance) << p_cam.transpose();
  const double tolerance = kJacobianTolerance * expected->J_uv_point.cwiseAbs().maxCoeff();
  for (int c = 0; c < 3; ++c) {
    EXPECT_NEAR(result[4 + c], expected->J_uv_point(0, c), tolerance) << p_cam.transpose();
    EXPECT_NEAR(result[8 + c], expected->J_uv_point(1, c), tolerance) << p_cam.transpose();
  }
}

/// Results of test_project.comp: per point ok, uv and the two rows of the Jacobian, padded to 12
/// floats.
std::vector<float> projectOnGpu(const CameraModel& camera,
                                const std::vector<Vec3d>& points,
                                int level) {
  const ScopedGlState state(GlStatePolicy::preserve);
  GpuTuning tuning;
  tuning.group_size = kGroupSize;
  const GpuAlignSpec spec{Config::Direct{}, camera, 1, tuning};
  const GlBuffer constants = makeBuffer(std::vector<GpuAlignConstants>{alignConstants(spec)});
  glBindBufferBase(GL_UNIFORM_BUFFER, 0, constants.get());
  std::vector<float> items;
  for (const Vec3d& p : points) {
    const Eigen::Vector3f single = p.cast<float>();
    items.insert(items.end(), {single.x(), single.y(), single.z(), std::ldexp(1.0F, -level)});
  }
  const ComputeProgram program = buildTestShader("test_project.comp", alignDefines(spec));
  return runItems(program, items, static_cast<int>(points.size()), 12);
}

void expectSameProjections(const CameraModel& camera, int level) {
  const std::vector<Vec3d> points = randomPoints(300);
  const std::vector<float> results = projectOnGpu(camera, points, level);
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (isOnTheEdge(camera, points[i])) continue;
    expectSameProjection(camera.atLevel(level), points[i], results.data() + 12 * i);
  }
}

TEST_F(CameraShaderTest, ProjectsLikeTheCameraModelOnEveryLevel) {
  for (const DistortionModel model : kCameraModels) {
    SCOPED_TRACE(static_cast<int>(model));
    const CameraModel camera = testCamera(model, 752, 480);
    expectSameProjections(camera, 0);
    expectSameProjections(camera, 3);
  }
}

TEST_F(CameraShaderTest, RefusesPointsBeyondTheDistortionsReach) {
  // This radial polynomial rises up to a radius of about 1 and folds back beyond.
  CameraIntrinsics intrinsics{752,
                              480,
                              400.0,
                              400.0,
                              376.0,
                              240.0,
                              DistortionModel::radial_tangential,
                              {-0.4, 0.05, 0.0, 0.0}};
  const CameraModel camera = CameraModel::create(intrinsics).value();
  ASSERT_TRUE(std::isfinite(camera.maxRadius()));
  const double edge = std::sqrt(camera.maxRadius());
  const std::vector<float> results =
      projectOnGpu(camera, {{0.99 * edge, 0.0, 1.0}, {1.01 * edge, 0.0, 1.0}, {0.0, 0.0, -1.0}}, 0);
  EXPECT_EQ(results[0], 1.0F);
  EXPECT_EQ(results[12], 0.0F);
  EXPECT_EQ(results[24], 0.0F);
}

const Vec3d kMovedPoint(0.3, -0.7, 1.9);

/// Random twists from nothing to large angles.
std::vector<Vec6d> randomTwists() {
  std::mt19937 random(5);
  std::normal_distribution<double> normal;
  std::vector<Vec6d> twists;
  for (const double size : {0.0, 1e-7, 1e-6, 1e-4, 0.009, 0.0099, 0.0101, 0.011, 0.3, 0.9}) {
    Vec6d twist;
    for (double& value : twist) value = size * normal(random);
    twists.push_back(twist);
  }
  return twists;
}

TEST_F(RigidShaderTest, ExponentialAndRotationMatchLie) {
  const std::vector<Vec6d> twists = randomTwists();
  std::vector<float> items;
  for (const Vec6d& twist : twists) {
    for (const Vec3d& part : {Vec3d(twist.head<3>()), Vec3d(twist.tail<3>()), kMovedPoint}) {
      const Eigen::Vector3f single = part.cast<float>();
      items.insert(items.end(), {single.x(), single.y(), single.z(), 0.0F});
    }
  }
  const ScopedGlState state(GlStatePolicy::preserve);
  const ComputeProgram program = buildTestShader("test_rigid.comp", {{"GROUP_SIZE", kGroupSize}});
  const std::vector<float> results = runItems(program, items, static_cast<int>(twists.size()), 12);
  for (std::size_t i = 0; i < twists.size(); ++i) {
    const SE3d expected = SE3d::exp(twists[i]);
    const float* r = results.data() + 12 * i;
    const Eigen::Quaternionf q(r[3], r[0], r[1], r[2]);
    EXPECT_LT(q.cast<double>().angularDistance(expected.q), 1e-5) << twists[i].transpose();
    const Vec3d moved = expected * kMovedPoint;
    for (int c = 0; c < 3; ++c) {
      EXPECT_NEAR(r[4 + c], expected.t[c], 3e-6) << twists[i].transpose();
      EXPECT_NEAR(r[8 + c], moved[c], 3e-6) << twists[i].transpose();
    }
  }
}

}  // namespace
}  // namespace glide::test
