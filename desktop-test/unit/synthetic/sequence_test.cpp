#include "synthetic/sequence.h"

#include "unit/synthetic/small_scene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

namespace glide::synthetic {
namespace {

Sequence makeSequence(const SequenceOptions& options) {
  return Sequence::create(options, smallScene()).value();
}

ImageU8 imageOf(const SequenceOptions& options, int frame) {
  ImageU8 image;
  makeSequence(options).image(frame, &image);
  return image;
}

double mean(const ImageU8& image) {
  double sum = 0.0;
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) sum += image.at(x, y);
  }
  return sum / (image.width() * image.height());
}

/// Mean absolute difference of horizontal neighbours: how sharp an image is.
double sharpness(const ImageU8& image) {
  double sum = 0.0;
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 1; x < image.width(); ++x) sum += std::abs(image.at(x, y) - image.at(x - 1, y));
  }
  return sum / (image.width() * image.height());
}

double rmsDifference(const ImageU8& a, const ImageU8& b) {
  double sum = 0.0;
  for (int y = 0; y < a.height(); ++y) {
    for (int x = 0; x < a.width(); ++x) sum += std::pow(a.at(x, y) - b.at(x, y), 2.0);
  }
  return std::sqrt(sum / (a.width() * a.height()));
}

bool areEqual(const ImageU8& a, const ImageU8& b) { return rmsDifference(a, b) == 0.0; }

TEST(Sequence, GivesTheSameBytesForTheSameSeed) {
  SequenceOptions options = smallSequence(DistortionModel::none);
  options.sensor.noise = 2.0;
  options.sensor.flicker = 0.1;
  const ImageU8 first = imageOf(options, 3);
  EXPECT_TRUE(areEqual(first, imageOf(options, 3)));
  options.seed = 2;
  EXPECT_FALSE(areEqual(first, imageOf(options, 3)));
}

TEST(Sequence, MakesTheSameSceneForTheSameSeed) {
  const auto first = smallScene(), second = smallScene();
  const Scene &a = *first, &b = *second;
  ASSERT_EQ(a.surfaces.size(), b.surfaces.size());
  for (std::size_t i = 0; i < a.surfaces.size(); ++i) {
    EXPECT_EQ(a.surfaces[i].texture.sample<float>(9.5F, 7.5F, 1.0F),
              b.surfaces[i].texture.sample<float>(9.5F, 7.5F, 1.0F));
  }
}

TEST(Sequence, AddsNoiseOfTheStandardDeviationAskedFor) {
  SequenceOptions options = smallSequence(DistortionModel::none);
  const ImageU8 clean = imageOf(options, 0);
  options.sensor.noise = 3.0;
  EXPECT_NEAR(rmsDifference(clean, imageOf(options, 0)), 3.0, 0.15);
}

TEST(Sequence, RampsTheGainFromTheFirstToTheLastFrame) {
  SequenceOptions options = smallSequence(DistortionModel::none);
  options.motion.kind = MotionKind::still;
  const double neutral = mean(imageOf(options, 0));
  options.sensor.gain_begin = 0.5;
  options.sensor.gain_end = 1.25;
  EXPECT_NEAR(mean(imageOf(options, 0)), 0.5 * neutral, 1.0);
  EXPECT_NEAR(mean(imageOf(options, 9)), 1.25 * neutral, 0.03 * neutral);  // a little is clipped
}

TEST(Sequence, BlursWhatMovesAndNothingElse) {
  SequenceOptions options = smallSequence(DistortionModel::none);
  options.motion.speed = 4.0;  // about three pixels during the exposure
  const ImageU8 sharp = imageOf(options, 0);
  options.sensor.shutter_s = 0.03;
  EXPECT_LT(sharpness(imageOf(options, 0)), 0.9 * sharpness(sharp));
  options.motion.kind = MotionKind::still;
  EXPECT_LT(rmsDifference(imageOf(options, 0), sharp), 0.5);
}

TEST(Sequence, RefusesOptionsThatMakeNoSenseAndNamesThem) {
  SequenceOptions options = smallSequence(DistortionModel::none);
  options.sensor.shutter_s = 1.0;
  EXPECT_NE(Sequence::create(options).error().message.find("shutter"), std::string::npos);
  options = smallSequence(DistortionModel::none);
  options.frames = 0;
  EXPECT_NE(Sequence::create(options).error().message.find("frames"), std::string::npos);
  options = smallSequence(DistortionModel::none);
  options.camera.fx = -1.0;
  EXPECT_FALSE(Sequence::create(options, smallScene()).ok());
}

TEST(Trajectory, HandheldStartsWithTranslation) {
  const Viewpoint viewpoint;
  const SE3d T_0 = poseAt({}, viewpoint, 0.0), T_1 = poseAt({}, viewpoint, 0.5);
  EXPECT_GT((T_1.t - T_0.t).norm(), 0.1 * viewpoint.depth);
  EXPECT_LT((T_0.q.inverse() * T_1.q).vec().norm(), 0.1);
}

TEST(Trajectory, IsDefinedBeforeItsBeginning) {
  // A shutter that is centred on the first frame opens before time zero.
  EXPECT_LT((poseAt({}, {}, -0.01).t - poseAt({}, {}, 0.0).t).norm(), 0.01);
}

TEST(Trajectory, RotatesOnTheSpotWhereItIsToldTo) {
  Motion motion;
  motion.turn_first_s = 2.0;
  const SE3d T_0 = poseAt(motion, {}, 0.0);
  EXPECT_LT((poseAt(motion, {}, 1.0).t - T_0.t).norm(), 1e-12);
  EXPECT_GT((T_0.q.inverse() * poseAt(motion, {}, 1.0).q).vec().norm(), 0.15);
  EXPECT_GT((poseAt(motion, {}, 3.0).t - T_0.t).norm(), 0.1);
}

TEST(Trajectory, PausesAndGoesOnWithoutAJump) {
  Motion motion;
  motion.pause_begin_s = 1.0;
  motion.pause_end_s = 3.0;
  const auto position = [&](double t) { return poseAt(motion, {}, t).t; };
  EXPECT_LT((position(2.9) - position(1.1)).norm(), 1e-12);
  constexpr double kStep = 0.01;
  for (double t = 0.0; t < 5.0; t += kStep) {
    EXPECT_LT((position(t + kStep) - position(t)).norm(), kStep * 0.7)
        << t;  // metres: the motion's top speed
  }
}

}  // namespace
}  // namespace glide::synthetic
