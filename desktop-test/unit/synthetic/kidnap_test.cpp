#include "synthetic/kidnap.h"

#include "unit/synthetic/small_scene.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace glide::synthetic {
namespace {

constexpr int kBegin = 40, kEnd = 52, kFrames = 70;

SequenceOptions kidnapped(KidnapView view) {
  SequenceOptions options = smallSequence(DistortionModel::none);
  options.frames = kFrames;
  options.kidnap = {kBegin, kEnd, view};
  return options;
}

Sequence makeSequence(const SequenceOptions& options) {
  return Sequence::create(options, smallScene()).value();
}

int brightest(const ImageU8& image) {
  int level = 0;
  for (int y = 0; y < image.height(); ++y) {
    const std::uint8_t* row = image.row(y);
    level = std::max<int>(level, *std::max_element(row, row + image.width()));
  }
  return level;
}

TEST(Kidnap, IsBlackExactlyWhileTheCameraIsCarriedAway) {
  Sequence sequence = makeSequence(kidnapped(KidnapView::black));
  ImageU8 image;
  for (const int frame : {kBegin - 1, kBegin, kEnd - 1, kEnd}) {
    sequence.image(frame, &image);
    const bool is_dark = frame >= kBegin && frame < kEnd;
    EXPECT_EQ(sequence.isKidnapped(frame), is_dark) << frame;
    EXPECT_EQ(brightest(image) == 0, is_dark) << frame;
  }
}

TEST(Kidnap, ReturnsBesideTheEarlierPath) {
  const SequenceOptions options = kidnapped(KidnapView::black);
  const Sequence sequence = makeSequence(options);
  const SE3d back = sequence.T_world_cam(kEnd);
  double nearest = 1e9, turned = 1e9;
  for (int frame = 0; frame < kBegin; ++frame) {
    const SE3d T_back_cam = back.inverse() * sequence.T_world_cam(frame);
    nearest = std::min(nearest, T_back_cam.t.norm());
    turned = std::min(turned, so3Log(T_back_cam.q).norm());
  }
  const double depth = sequence.scene()->viewpoint.depth;
  EXPECT_LT(nearest, 0.12 * depth);
  EXPECT_LT(turned, 0.2);
  EXPECT_GT((back.t - sequence.T_world_cam(kBegin - 1).t).norm(), 0.02 * depth);
}

TEST(Kidnap, MovesOnSmoothlyAfterTheReturn) {
  const Sequence sequence = makeSequence(kidnapped(KidnapView::black));
  for (int frame = kEnd; frame + 1 < kFrames; ++frame) {
    const Vec3d step = sequence.T_world_cam(frame + 1).t - sequence.T_world_cam(frame).t;
    EXPECT_LT(step.norm(), 0.03) << frame;  // metres: the hand's top speed
  }
}

TEST(Kidnap, IsRefusedWhenItEndsBeforeItBegins) {
  SequenceOptions options = kidnapped(KidnapView::black);
  options.kidnap.end = kBegin - 1;
  EXPECT_NE(Sequence::create(options, smallScene()).error().message.find("kidnap"),
            std::string::npos);
}

TEST(Kidnap, AWalkNeedsAWay) {
  SequenceOptions options = smallSequence(DistortionModel::none);
  options.motion.kind = MotionKind::walk;
  EXPECT_FALSE(Sequence::create(options, smallScene()).ok());
}

}  // namespace
}  // namespace glide::synthetic
