#include "e2e/synthetic_run.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace glide::test {
namespace {

constexpr int kFrames = 150;
// Corners of the image lie 10 px off.
constexpr double kWrongK1 = 0.08;

/// The sessions of these tests are told of a lens that bends what was rendered straight.
Config wrongLens(const synthetic::SequenceOptions& options) {
  Config config = inlineConfig();
  config.camera = options.camera;
  config.camera.distortion = DistortionModel::radial_tangential;
  config.camera.coefficients = {kWrongK1, 0.0, 0.0, 0.0};
  return config;
}

/// Feeds the whole sequence and returns its maps and whether all frames were tracked.
void feed(synthetic::Sequence* sequence, Session* session) {
  ImageU8 image;
  for (int i = 0; i < sequence->size(); ++i) {
    sequence->image(i, &image);
    const Luma luma{image.row(0), image.width(), image.height(), image.stride()};
    ASSERT_TRUE(session->update({sequence->timestamp(i), luma}).ok());
  }
}

TEST(SelfCalibration, FindsTheLensAndMapsBringItAlong) {
  const synthetic::SequenceOptions options = roomWalk(kFrames);
  Result<synthetic::Sequence> sequence = synthetic::Sequence::create(options);
  ASSERT_TRUE(sequence.ok());
  const Config config = wrongLens(options);
  Result<Session> session = Session::create(config);
  ASSERT_TRUE(session.ok());
  feed(&*sequence, &*session);
  const auto found = session->map()->corrected_camera;
  ASSERT_TRUE(found.has_value());
  EXPECT_NEAR(found->coefficients.front(), 0.0, 0.15 * kWrongK1);
  EXPECT_EQ(found->fx, config.camera.fx);

  const Result<std::vector<std::byte>> file = session->saveMap();
  Result<Session> other = Session::create(config);
  ASSERT_TRUE(file.ok() && other.ok());
  ASSERT_TRUE(other->loadMap(*file).ok());
  ASSERT_TRUE(other->map()->corrected_camera.has_value());
  EXPECT_EQ(other->map()->corrected_camera->coefficients, found->coefficients);
}

TEST(SelfCalibration, LeavesARightLensAlone) {
  const Playback run = play(roomWalk(kFrames), inlineConfig());
  EXPECT_FALSE(run.map->corrected_camera.has_value());
}

}  // namespace
}  // namespace glide::test
