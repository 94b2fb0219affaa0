#include "photometric/point_residuals.h"

#include "unit/photometric/align_fixture.h"

#include <gtest/gtest.h>

#include <numeric>
#include <vector>

namespace glide {
namespace {

using test::AlignScenario;

/// A reference and a frame of the same scene, aligned by the CPU aligner.
class PointResidualsTest : public ::testing::Test {
 protected:
  PointResidualsTest() : scenario_(test::smallScenario()) {}

  /// The residuals in `frame`, of the alignment that `frame` itself gave.
  std::span<const PointResiduals::Residual> residualsIn(const ImageU8& frame) {
    const std::unique_ptr<CpuAligner> aligner = scenario_.alignerWithReference();
    EXPECT_TRUE(aligner->loadFrame(frame.view()));
    align_ = aligner->align(scenario_.perturbedGuess());
    EXPECT_TRUE(align_.valid);
    residuals_.setReference(scenario_.referenceImage().view(), points_);
    return residuals_.evaluate(frame.view(), align_);
  }

  AlignScenario scenario_;
  std::vector<AlignPoint> points_ = scenario_.alignPoints();
  PointResiduals residuals_{scenario_.config, scenario_.camera};
  AlignResult align_;
};

TEST_F(PointResidualsTest, LieWhereTheFrameSeesThePoints) {
  const std::vector<PointResiduals::Residual> residuals = [&] {
    const auto seen = residualsIn(scenario_.frameImage());
    return std::vector<PointResiduals::Residual>(seen.begin(), seen.end());
  }();
  ASSERT_EQ(static_cast<int>(residuals.size()), align_.visible);
  for (const PointResiduals::Residual& residual : residuals) {
    const Vec3d p_cam = scenario_.truth() * points_[residual.point].p_ref;
    EXPECT_LT((residual.uv - *scenario_.camera.project(p_cam)).norm(), 0.1);
  }
}

TEST_F(PointResidualsTest, AgreeWithWhatTheAlignerSaysOfAllOfThem) {
  scenario_.frame_exposure = {0.8, 12.0};
  const auto residuals = residualsIn(scenario_.frameImage());
  int inliers = 0;
  for (const PointResiduals::Residual& residual : residuals) inliers += residual.is_inlier ? 1 : 0;
  // The aligner measured before its last, tiny step.
  EXPECT_NEAR(inliers, align_.inliers, 3);
  const double sum = std::accumulate(
      residuals.begin(), residuals.end(), 0.0, [](double total, const auto& residual) {
        return total + residual.rms;
      });
  EXPECT_NEAR(sum / static_cast<double>(residuals.size()), align_.rms, 0.3 * align_.rms);
}

TEST_F(PointResidualsTest, TellThePointsThatSomethingHides) {
  ImageU8 frame = scenario_.frameImage();
  const int hidden_width = frame.width() / 5;
  for (int y = 0; y < frame.height(); ++y)
    for (int x = 0; x < hidden_width; ++x)
      frame.at(x, y) = static_cast<std::uint8_t>(x % 7 * 40);  // stripes
  int hidden = 0;
  const int half = scenario_.config.patch_size / 2;
  for (const PointResiduals::Residual& residual : residualsIn(frame)) {
    const bool is_hidden = residual.uv.x() < hidden_width - half;
    const bool is_clear = residual.uv.x() > hidden_width + half;
    hidden += is_hidden ? 1 : 0;
    EXPECT_FALSE(is_hidden && residual.is_inlier) << residual.rms;
    EXPECT_FALSE(is_clear && residual.rms > 20.0) << residual.rms;
  }
  EXPECT_GT(hidden, 20);
}

TEST_F(PointResidualsTest, AreNoneWithoutAReference) {
  EXPECT_TRUE(residuals_.evaluate(scenario_.frameImage().view(), AlignResult()).empty());
}

}  // namespace
}  // namespace glide
