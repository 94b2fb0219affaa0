// Session::trackedPoints with the GPU: nothing of the alignment comes back, and the points are
// told.
#include "guest/guest_fixture.h"
#include "support/app_texture.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace glide::test {
namespace {

constexpr int kFrames = 12;

int inliersOf(const std::vector<TrackedPoint>& points) {
  return static_cast<int>(std::count_if(
      points.begin(), points.end(), [](const TrackedPoint& point) { return point.inlier; }));
}

/// Landmark, place and residual of every point.
std::vector<float> numbersOf(const std::vector<TrackedPoint>& points) {
  std::vector<float> numbers;
  for (const TrackedPoint& point : points)
    numbers.insert(numbers.end(),
                   {static_cast<float>(point.landmark), point.u, point.v, point.residual});
  return numbers;
}

TEST_F(GuestTest, TrackedPointsOfTexturesAreThoseOfPixels) {
  Config reporting = config();
  reporting.tracked_points = ReportPoints::on;
  Session of_pixels = makeSession(reporting);
  Session of_textures = makeSession(reporting);
  Result<AppTexture> texture =
      AppTexture::create(AppTextureKind::r8, reporting.camera.width, reporting.camera.height);
  ASSERT_TRUE(texture.ok());
  int direct = 0;
  for (int frame = 0; frame < kFrames; ++frame) {
    const Result<FrameResult> expected = feed(&of_pixels, frame);
    texture->write(walkImage(frame).view());
    const Result<FrameResult> seen = feed(&of_textures, frame, texture->texture(kUpperRowFirst));
    ASSERT_TRUE(expected.ok() && seen.ok());
    EXPECT_EQ(numbersOf(of_textures.trackedPoints()), numbersOf(of_pixels.trackedPoints()));
    if (seen->tracker != TrackerKind::direct) continue;
    ++direct;
    EXPECT_GT(seen->stats.readback_ms, 0.0);
    EXPECT_NEAR(inliersOf(of_textures.trackedPoints()), seen->stats.inliers, 3);
  }
  EXPECT_GT(direct, 1);
}

}  // namespace
}  // namespace glide::test
