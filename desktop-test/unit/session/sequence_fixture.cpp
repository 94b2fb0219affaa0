#include "unit/session/sequence_fixture.h"

#include <gtest/gtest.h>

#include <cmath>

namespace glide::test {
namespace {

constexpr std::int64_t kFrame_ns = 33'333'333;

CameraIntrinsics intrinsics() {
  CameraIntrinsics camera;
  camera.width = 320;
  camera.height = 240;
  camera.fx = camera.fy = 260.0;
  camera.cx = 159.5;
  camera.cy = 119.5;
  return camera;
}

}  // namespace

SequenceFixture::SequenceFixture()
    : scene_(TexturedScene::wallWithPanels()), camera_(CameraModel::create(intrinsics()).value()) {
  config_.camera = intrinsics();
  config_.backend = Backend::cpu;
  config_.execution = Execution::inline_;
  config_.initialization.min_matches = 60;
}

SE3d SequenceFixture::poseAt(double x) {
  SE3d T_world_cam;
  T_world_cam.t = Vec3d(x, 0.04 * std::sin(8.0 * x), 0.03 * std::sin(5.0 * x));
  T_world_cam.q = so3Exp(Vec3d(0.0, -0.1 * x, 0.05 * x));
  return T_world_cam;
}

ImageU8 SequenceFixture::imageAt(double x) const {
  return scene_.render(camera_, poseAt(x), Exposure{});
}

std::optional<Vec3d> SequenceFixture::pointAt(double x, const Vec2d& uv) const {
  return scene_.pointAt(camera_, poseAt(x), uv);
}

std::optional<Vec2d> SequenceFixture::pixelOf(double x, const Vec3d& p_world) const {
  return camera_.project(poseAt(x).inverse() * p_world);
}

ImageU8 SequenceFixture::blank() const {
  ImageU8 image(config_.camera.width, config_.camera.height);
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) image.at(x, y) = 90;
  return image;
}

FrameResult SequenceFixture::feed(Session* session, const ImageU8& image) {
  t_ns_ += kFrame_ns;
  const Luma luma{image.row(0), image.width(), image.height(), image.stride()};
  return session->update({t_ns_, luma}).value();
}

Session makeSession(const Config& config) {
  Result<Session> session = Session::create(config);
  EXPECT_TRUE(session.ok()) << session.error().message;
  return std::move(session.value());
}

}  // namespace glide::test
