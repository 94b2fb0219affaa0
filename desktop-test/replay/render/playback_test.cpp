#include "replay/render/playback.h"

#include <gtest/gtest.h>

namespace glide::replay {
namespace {

TEST(Playback, GoesOnUntilItIsPausedAndThenAgain) {
  Playback playback;
  EXPECT_TRUE(playback.mayGoOn());
  playback.obey(ViewerKey::pause);
  EXPECT_FALSE(playback.mayGoOn());
  playback.obey(ViewerKey::follow);
  EXPECT_FALSE(playback.mayGoOn());
  playback.obey(ViewerKey::pause);
  EXPECT_TRUE(playback.mayGoOn());
}

TEST(Playback, StepsOneFrameAndStaysPaused) {
  Playback playback;
  playback.obey(ViewerKey::step);  // also without a pause before
  EXPECT_TRUE(playback.mayGoOn());
  playback.showFrame();
  EXPECT_FALSE(playback.mayGoOn());
  playback.obey(ViewerKey::step);
  playback.showFrame();
  EXPECT_FALSE(playback.mayGoOn());
}

TEST(Playback, EndsAlsoWhenItIsPaused) {
  Playback playback;
  playback.obey(ViewerKey::pause);
  EXPECT_FALSE(playback.hasQuit());
  playback.obey(ViewerKey::quit);
  EXPECT_TRUE(playback.hasQuit());
  EXPECT_TRUE(playback.mayGoOn());
}

}  // namespace
}  // namespace glide::replay
