#include "unit/session/sequence_fixture.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <random>
#include <thread>
#include <vector>

namespace glide::test {
namespace {

constexpr double kStep_m = 0.03;
constexpr int kFrames = 24;
constexpr int kActions = 150;
constexpr int kSessions = 4;

std::vector<ImageU8> imagesOf(const SequenceFixture& fixture) {
  std::vector<ImageU8> images;
  for (int i = 0; i < kFrames; ++i) images.push_back(fixture.imageAt(i * kStep_m));
  return images;
}

/// Does something to the session that an app may do at any moment.
void disturb(std::uint64_t choice, Session* session, std::vector<std::byte>* saved) {
  switch (choice % 24) {
    case 0:
      session->reset();
      break;
    case 1:
      session->pause();
      break;
    case 2:
    case 3:
      session->resume();
      break;
    case 4:
      if (const auto bytes = session->saveMap()) *saved = *bytes;
      break;
    case 5:
      if (!saved->empty()) session->loadMap(*saved);
      break;
    case 6:
      session->waitForMapping();
      break;
    default:
      break;
  }
}

TEST(SessionStress, SurvivesResetsSavesPausesAndTheEndAtRandomMoments) {
  SequenceFixture fixture;
  const std::vector<ImageU8> images = imagesOf(fixture);
  const ImageU8 blank = fixture.blank();
  Config config = fixture.config();
  config.execution = Execution::threaded;
  std::vector<std::byte> saved;
  int tracked = 0;
  for (int seed = 0; seed < kSessions; ++seed) {
    std::mt19937_64 random(static_cast<std::uint64_t>(seed));
    Session session = makeSession(config);
    for (int i = 0; i < kActions; ++i) {
      disturb(random(), &session, &saved);
      const bool sees = random() % 8 != 0;
      const std::size_t frame = static_cast<std::size_t>(i) % (2 * kFrames);
      const std::size_t there_and_back = frame < kFrames ? frame : 2 * kFrames - 1 - frame;
      const FrameResult result = fixture.feed(&session, sees ? images[there_and_back] : blank);
      tracked += result.state == TrackingState::tracking ? 1 : 0;
    }
  }  // destroyed while threads are at work
  EXPECT_GT(tracked, kSessions * kActions / 20);
}

TEST(SessionStress, MapAndLocateAndSaveMayBeCalledFromOtherThreads) {
  SequenceFixture fixture;
  const std::vector<ImageU8> images = imagesOf(fixture);
  Config config = fixture.config();
  config.execution = Execution::threaded;
  Session session = makeSession(config);
  std::vector<std::thread> readers;
  for (int r = 0; r < 2; ++r) {
    readers.emplace_back([&session] {
      for (int i = 0; i < 30; ++i) {
        EXPECT_NE(session.map(), nullptr);
        const std::shared_ptr<const FrameMap> of_frame = session.frameMap();
        EXPECT_EQ(of_frame->view()->revision, of_frame->revision());
        const auto saved = session.saveMap();
        EXPECT_TRUE(saved.ok() || saved.error().code == ErrorCode::no_map);
        EXPECT_EQ(session.locate(i).t_ns, i);
      }
    });
  }
  for (const ImageU8& image : images) {
    fixture.feed(&session, image);
    EXPECT_NE(session.frameMap()->view(), nullptr);  // as a reader may at the same time
  }
  for (std::thread& reader : readers) reader.join();
}

}  // namespace
}  // namespace glide::test
