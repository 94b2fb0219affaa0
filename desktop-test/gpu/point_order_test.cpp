#include "gpu/point_order.h"

#include "gpu/align_fixture.h"
#include "gpu/align_twin.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace glide::test {
namespace {

constexpr int kLevels = 4;
constexpr int kPoints = 300;

GpuAlignSpec specOf(const AlignScene& scene) {
  Config::Direct direct;
  direct.max_points = kPoints;
  return {direct, scene.camera, kLevels, GpuTuning{}};
}

TEST(PointOrder, PutsAllValidPointsOfALevelFirstAndFewOthers) {
  for (const DistortionModel model : kCameraModels) {
    const AlignScene scene = makeAlignScene({model, 376, 240, kPoints, smallMotion(), Exposure{}});
    const GpuAlignSpec spec = specOf(scene);
    PointOrder order(spec);
    order.sort(scene.points_ref);
    const Pyramid pyramid = scene.referencePyramid(kLevels);
    for (int level = 0; level < kLevels; ++level) {
      const auto isValid = [&](const AlignPoint& point) {
        const ImageF& image = pyramid.levels[static_cast<std::size_t>(level)];
        const CameraModel camera = spec.camera.atLevel(level);
        return describeTwin(image, camera, point.p_ref, spec.direct.patch_size).valid;
      };
      const auto head = order.points().first(static_cast<std::size_t>(order.count(level)));
      const auto valid = std::count_if(head.begin(), head.end(), isValid);
      EXPECT_EQ(valid, std::count_if(scene.points_ref.begin(), scene.points_ref.end(), isValid));
      EXPECT_LE(order.count(level), valid + kPoints / 50) << "level " << level;
    }
    EXPECT_LT(order.count(kLevels - 1), order.count(0));
  }
}

TEST(PointOrder, LeavesOutPointsBeyondMaxPointsAndBehindTheCamera) {
  const AlignScene scene =
      makeAlignScene({DistortionModel::none, 376, 240, kPoints, smallMotion(), Exposure{}});
  GpuAlignSpec spec = specOf(scene);
  spec.direct.max_points = 20;
  PointOrder order(spec);
  std::vector<AlignPoint> points_ref = scene.points_ref;
  points_ref[3].p_ref.z() = -1.0;
  order.sort(points_ref);
  EXPECT_LE(order.points().size(), 19U);
  EXPECT_GE(order.points().size(), 15U);
  order.sort({});
  EXPECT_EQ(order.count(0), 0);
}

}  // namespace
}  // namespace glide::test
