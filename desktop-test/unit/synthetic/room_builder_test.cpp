#include "synthetic/living_room/room_builder.h"

#include "unit/synthetic/small_color_scene.h"
#include "unit/synthetic/small_scene.h"

#include <gtest/gtest.h>

namespace glide::synthetic {
namespace {

TEST(RoomBuilder, PaintsWhatTheCameraSeesInColour) {
  const std::shared_ptr<const Scene> scene = smallColorScene();
  Sequence sequence = Sequence::create(smallSequence(DistortionModel::none), scene).value();
  const ImageRgb& color = sequence.rendering(0).color;
  const Vec3f left = color.at(40, 60), right = color.at(120, 60);
  EXPECT_GT(left.x(), 1.5F * left.z());
  EXPECT_GT(right.z(), 1.5F * right.x());
}

TEST(RoomBuilder, GivesGrayImagesThatAreTheLumaOfTheColouredOnes) {
  Sequence sequence =
      Sequence::create(smallSequence(DistortionModel::none), smallColorScene()).value();
  ImageU8 gray, color;
  sequence.image(3, &gray);
  sequence.colorImage(3, &color);
  ASSERT_EQ(color.width(), 3 * gray.width());
  for (int y = 0; y < gray.height(); y += 7) {
    for (int x = 0; x < gray.width(); x += 7) {
      const std::uint8_t* rgb = color.row(y) + 3 * x;
      const double luma = 0.299 * rgb[0] + 0.587 * rgb[1] + 0.114 * rgb[2];
      EXPECT_NEAR(gray.at(x, y), luma, 1.1);
    }
  }
}

TEST(RoomBuilder, LetsGlowWhatIsNotLit) {
  RoomBuilder room;
  Look glowing = oneColor(Rgb::Ones());
  glowing.glow = 1.0F;
  room.add({0, 0, 0}, Vec3f::UnitX(), Vec3f::UnitY(), oneColor(Rgb::Ones()));
  room.add({2, 0, 0}, Vec3f::UnitX(), Vec3f::UnitY(), glowing);
  RoomLight no_light;
  no_light.sun = Vec3f::Zero();
  const Scene scene = room.finish(no_light, 1);
  EXPECT_EQ(scene.surfaces[0].texture.sample<Vec3f>(9, 9, 1), Vec3f(Vec3f::Zero()));
  EXPECT_GT(scene.surfaces[1].texture.sample<Vec3f>(9, 9, 1).x(), 150.0F);
}

TEST(RoomBuilder, StandsABoxOnItsFootWithAllFacesOutwards) {
  RoomBuilder room;
  const Stand stand{{1, 2, 3}, 0.3F};
  room.addBox(stand, {0.4F, 0.6F, 0.2F}, allAround(oneColor(Rgb::Ones())));
  const Vec3f center = stand.at(0, 0.3F, 0);
  for (const Surface& surface : room.finish({}, 1).surfaces) {
    const Vec3f middle = surface.origin + 0.5F * surface.width * surface.axis_u +
                         0.5F * surface.height * surface.axis_v;
    EXPECT_GT((middle - center).dot(surface.normal), 0.05F);
    EXPECT_LE(middle.y(), 2.0F);
  }
}

TEST(Sensor, MetersDarkViewsUp) {
  Sensor sensor;
  EXPECT_EQ(meteredGain(sensor, 30.0), 1.0);
  sensor.metering = 1.0;
  EXPECT_NEAR(meteredGain(sensor, 55.0), 2.0, 1e-12);
  sensor.metering = 0.5;
  EXPECT_NEAR(meteredGain(sensor, 440.0), 0.5, 1e-12);
}

}  // namespace
}  // namespace glide::synthetic
