#include "render/camera_points.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace glide::test {
namespace {

constexpr FrameSize kCamera{300, 150};

/// What is drawn of the points of a picture without history, 2 px a pixel.
std::vector<InkShape> shapesOf(std::span<const TrackedPoint> points, PointTrails* trails) {
  trails->add(points);
  std::vector<InkShape> shapes;
  const PictureLayout layout = PictureLayout::fit(kCamera, {0, 0, 600, 300});
  PointInk{kCamera, layout, TrackerKind::direct}.append(points, *trails, &shapes);
  return shapes;
}

TrackedPoint pointAt(float u, bool inlier) {
  TrackedPoint point;
  point.landmark = 1;
  point.u = u;
  point.v = 20.0F;
  point.inlier = inlier;
  return point;
}

TEST(PointColor, GoesFromGreenOverYellowToRed) {
  const Color good = pointColor(0.0F, TrackerKind::direct);
  EXPECT_GT(good[1], 2.0F * good[0]);
  const Color fair = pointColor(12.5F, TrackerKind::direct);
  EXPECT_GT(fair[0], 0.8F);
  EXPECT_GT(fair[1], 0.8F);
  const Color bad = pointColor(25.0F, TrackerKind::direct);
  EXPECT_GT(bad[0], 4.0F * bad[1]);
}

TEST(PointColor, EndsWithTheTrackersScale) {
  EXPECT_EQ(pointColor(1000.0F, TrackerKind::direct), pointColor(25.0F, TrackerKind::direct));
  EXPECT_EQ(pointColor(1000.0F, TrackerKind::indirect), pointColor(3.0F, TrackerKind::indirect));
  EXPECT_EQ(pointColor(12.5F, TrackerKind::direct), pointColor(1.5F, TrackerKind::indirect));
}

TEST(PointInk, DrawsAnInlierAsADiscOnItsShade) {
  PointTrails trails;
  const std::vector<InkShape> shapes = shapesOf(std::vector{pointAt(10.0F, true)}, &trails);
  ASSERT_EQ(shapes.size(), 2U);
  EXPECT_GT(shapes[0].cd[0], shapes[1].cd[0]);
  for (const InkShape& shape : shapes) {
    EXPECT_FLOAT_EQ(shape.ab[0], 21.0F);
    EXPECT_FLOAT_EQ(shape.ab[1], 41.0F);
    EXPECT_LT(shape.cd[1], 0.0F) << "a hole";
  }
  EXPECT_EQ(shapes[1].colors[0], packColor(pointColor(0.0F, TrackerKind::direct)));
}

TEST(PointInk, DrawsAnOutlierHollow) {
  PointTrails trails;
  const std::vector<InkShape> shapes = shapesOf(std::vector{pointAt(10.0F, false)}, &trails);
  ASSERT_EQ(shapes.size(), 2U);
  for (const InkShape& shape : shapes) EXPECT_GT(shape.cd[1], 1.0F);
}

TEST(PointInk, LetsTheTrailFadeOutBelowThePoint) {
  PointTrails trails;
  for (int frame = 0; frame < 3; ++frame)
    trails.add(std::vector{pointAt(static_cast<float>(frame), true)});
  const std::vector<InkShape> shapes = shapesOf(std::vector{pointAt(3.0F, true)}, &trails);
  ASSERT_EQ(shapes.size(), 5U);
  int alpha = 256;
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_FLOAT_EQ(shapes[i].ab[0], 7.0F - 2.0F * static_cast<float>(i));
    EXPECT_FLOAT_EQ(shapes[i].ab[2], 5.0F - 2.0F * static_cast<float>(i));
    EXPECT_LT(shapes[i].colors[0][3], alpha);
    EXPECT_LT(shapes[i].colors[1][3], shapes[i].colors[0][3]);
    alpha = shapes[i].colors[0][3];
  }
}

}  // namespace
}  // namespace glide::test
