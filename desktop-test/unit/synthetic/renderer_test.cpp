#include "synthetic/renderer.h"

#include "unit/synthetic/small_scene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace glide::synthetic {
namespace {

class RenderThrough : public testing::TestWithParam<DistortionModel> {
 protected:
  void SetUp() override {
    auto sequence = Sequence::create(smallSequence(GetParam()), smallScene());
    ASSERT_TRUE(sequence.ok()) << sequence.error().message;
    sequence_.emplace(std::move(*sequence));
  }

  std::optional<Sequence> sequence_;
};

float bilinear(const ImageF& image, const Vec2d& uv) {
  const int x = static_cast<int>(uv.x()), y = static_cast<int>(uv.y());
  const auto fx = static_cast<float>(uv.x() - x), fy = static_cast<float>(uv.y() - y);
  return (1 - fy) * ((1 - fx) * image.at(x, y) + fx * image.at(x + 1, y)) +
         fy * ((1 - fx) * image.at(x, y + 1) + fx * image.at(x + 1, y + 1));
}

TEST_P(RenderThrough, RangesOfTwoViewsTellTheSameScene) {
  const CameraModel& camera = sequence_->camera();
  const Rendering a = sequence_->rendering(0), b = sequence_->rendering(6);
  const SE3d T_b_a = sequence_->T_world_cam(6).inverse() * sequence_->T_world_cam(0);
  int seen = 0, agreeing = 0;
  for (int y = 4; y < camera.height(); y += 4) {
    for (int x = 4; x < camera.width(); x += 4) {
      const auto bearing = camera.unproject(Vec2d(x, y));
      if (!bearing || a.range.at(x, y) <= 0.0F) continue;
      const Vec3d p_b = T_b_a * Vec3d(static_cast<double>(a.range.at(x, y)) * *bearing);
      const auto uv_b = camera.project(p_b);
      if (!uv_b || !camera.isInImage(*uv_b, 2.0)) continue;
      ++seen;
      constexpr double kTolerance = 0.01;  // metres; ranges vary within a pixel
      if (std::abs(bilinear(b.range, *uv_b) - p_b.norm()) < kTolerance) ++agreeing;
    }
  }
  EXPECT_GT(seen, 500);
  EXPECT_GT(agreeing, 0.9 * seen) << "of "
                                  << seen;  // the rest is hidden in one of the views, or on an edge
}

TEST_P(RenderThrough, APointKeepsItsBrightness) {
  const CameraModel& camera = sequence_->camera();
  const Rendering a = sequence_->rendering(0), b = sequence_->rendering(1);
  const SE3d T_b_a = sequence_->T_world_cam(1).inverse() * sequence_->T_world_cam(0);
  std::vector<float> differences;
  for (int y = 4; y < camera.height() - 4; y += 3) {
    for (int x = 4; x < camera.width() - 4; x += 3) {
      const auto bearing = camera.unproject(Vec2d(x, y));
      if (!bearing || a.range.at(x, y) <= 0.0F) continue;
      const auto uv_b =
          camera.project(T_b_a * Vec3d(static_cast<double>(a.range.at(x, y)) * *bearing));
      if (!uv_b || !camera.isInImage(*uv_b, 2.0)) continue;
      differences.push_back(std::abs(bilinear(b.radiance, *uv_b) - a.radiance.at(x, y)));
    }
  }
  ASSERT_GT(differences.size(), 500U);
  const auto middle = differences.begin() + static_cast<std::ptrdiff_t>(differences.size() / 2);
  std::nth_element(differences.begin(), middle, differences.end());
  EXPECT_LT(*middle, 2.0F) << "grey levels, median";
}

INSTANTIATE_TEST_SUITE_P(EveryLens,
                         RenderThrough,
                         testing::Values(DistortionModel::none,
                                         DistortionModel::radial_tangential,
                                         DistortionModel::kannala_brandt4));

/// A white square on nothing, in front of a pinhole camera whose pixels are 1 cm at its distance.
class RenderSquare : public testing::Test {
 protected:
  RenderSquare() : renderer_(CameraModel::create(camera()).value()) {
    ImageF white(8, 8);
    for (int y = 0; y < 8; ++y) std::fill_n(white.row(y), 8, 200.0F);
    Surface square;
    square.origin = {-0.1F, -0.1F, 1.0F};
    square.width = square.height = 0.2F;
    square.texels_per_m = 40.0F;
    square.texture = Texture(white);
    scene_.surfaces.push_back(square);
  }

  static CameraIntrinsics camera() {
    CameraIntrinsics intrinsics;
    intrinsics.width = 65;
    intrinsics.height = 65;
    intrinsics.fx = intrinsics.fy = 100.0;
    intrinsics.cx = intrinsics.cy = 32.0;
    return intrinsics;
  }

  Rendering renderAt(const std::vector<SE3d>& T_world_cam_rows) {
    Rendering out;
    renderer_.render(scene_, T_world_cam_rows, &out);
    return out;
  }

  Scene scene_;
  Renderer renderer_;
};

SE3d movedBy(double x, double y) { return {Eigen::Quaterniond::Identity(), Vec3d(x, y, 0.0)}; }

TEST_F(RenderSquare, CoversTheAreaThatGeometrySays) {
  // Moved by a third of a pixel: the edges cover parts of pixels.
  const Rendering out = renderAt({movedBy(0.0033, 0.0033)});
  double covered = 0.0;
  for (int y = 0; y < 65; ++y) {
    for (int x = 0; x < 65; ++x) covered += static_cast<double>(out.radiance.at(x, y)) / 200.0;
  }
  EXPECT_NEAR(covered,
              20.0 * 20.0,
              12.0);  // sixteen rays resolve a quarter of a pixel along 80 pixels of outline
  EXPECT_FLOAT_EQ(out.range.at(32, 32), 1.0F);
  EXPECT_FLOAT_EQ(out.range.at(2, 2), 0.0F);
}

TEST_F(RenderSquare, IsInvisibleFromBehind) {
  const SE3d T_world_cam{Eigen::Quaterniond(0.0, 0.0, 1.0, 0.0), Vec3d(0.0, 0.0, 2.0)};
  EXPECT_FLOAT_EQ(renderAt({T_world_cam}).range.at(32, 32), 0.0F);
}

TEST_F(RenderSquare, TakesEachRowOfARollingShutterFromItsOwnPose) {
  std::vector<SE3d> rows;
  for (int y = 0; y < 65; ++y) rows.push_back(movedBy(0.001 * y, 0.0005 * y));
  const Rendering rolling = renderAt(rows);
  for (const int y : {25, 32, 37}) {
    const Rendering still = renderAt({rows[static_cast<std::size_t>(y)]});
    for (int x = 0; x < 65; ++x) {
      ASSERT_EQ(rolling.range.at(x, y) > 0.0F, still.range.at(x, y) > 0.0F) << x << ", " << y;
    }
  }
}

}  // namespace
}  // namespace glide::synthetic
