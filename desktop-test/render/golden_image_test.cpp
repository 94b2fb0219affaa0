#include "support/golden_image.h"

#include "support/temporary_folder.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <random>

namespace glide::test {
namespace {

constexpr int kWidth = 96, kHeight = 64;

/// A disc with a soft edge on grey, and grey levels of noise.
RgbPicture disc(double center_x, int noise) {
  std::mt19937 random(3);
  RgbPicture picture{kWidth, kHeight, {}};
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const double inside = 0.5 + 12.0 - std::hypot(x - center_x, y - 32.0);
      const double alpha = std::fmin(std::fmax(inside, 0.0), 1.0);
      for (const double color : {255.0, 140.0, 0.0}) {
        const double value = 80.0 + alpha * (color - 80.0) + static_cast<int>(random() % 3) * noise;
        picture.pixels.push_back(static_cast<std::uint8_t>(std::fmin(value, 255.0)));
      }
    }
  }
  return picture;
}

class GoldenImageTest : public testing::Test {
 protected:
  void SetUp() override {
    if (std::getenv("GLIDE_UPDATE_GOLDENS") != nullptr) GTEST_SKIP() << "goldens are being written";
    writePng(folders_.goldens / "disc.png", disc(48.0, 0));
  }

  TemporaryFolder folder_;
  GoldenFolders folders_{folder_.path() / "goldens", folder_.path() / "diffs"};
};

TEST_F(GoldenImageTest, PngsKeepEveryPixel) {
  const RgbPicture read = readPng(folders_.goldens / "disc.png");
  EXPECT_EQ(read.width, kWidth);
  EXPECT_EQ(read.height, kHeight);
  EXPECT_EQ(read.pixels, disc(48.0, 0).pixels);
}

TEST_F(GoldenImageTest, TheSamePictureLooksTheSame) {
  EXPECT_EQ(shareOff(disc(48.0, 0), disc(48.0, 0), {}), 0.0);
  EXPECT_TRUE(looksAsGolden(disc(48.0, 0), "disc", folders_));
  EXPECT_FALSE(std::filesystem::exists(folders_.diffs));
}

TEST_F(GoldenImageTest, ASlightlyOtherRoundingAndAntiAliasingDoToo) {
  EXPECT_TRUE(looksAsGolden(disc(48.0, 1), "disc", folders_));
  EXPECT_TRUE(looksAsGolden(disc(48.06, 0), "disc", folders_));
}

TEST_F(GoldenImageTest, ADiscThatIsAPixelAsideDoesNot) {
  const testing::AssertionResult moved = looksAsGolden(disc(49.0, 0), "disc", folders_);
  EXPECT_FALSE(moved);
  for (const char* kind : {"actual", "expected", "diff"}) {
    const auto file = folders_.diffs / (std::string("disc.") + kind + ".png");
    EXPECT_TRUE(std::filesystem::exists(file)) << file;
    EXPECT_NE(std::string(moved.message()).find(file.string()), std::string::npos);
  }
}

TEST_F(GoldenImageTest, APictureOfAnotherSizeDoesNot) {
  RgbPicture flat = disc(48.0, 0);
  flat.height /= 2;
  flat.pixels.resize(flat.pixels.size() / 2);
  EXPECT_FALSE(looksAsGolden(flat, "disc", folders_));
}

TEST_F(GoldenImageTest, AMissingGoldenIsNamedWithTheWayToMakeIt) {
  const testing::AssertionResult missing = looksAsGolden(disc(48.0, 0), "none", folders_);
  EXPECT_FALSE(missing);
  EXPECT_NE(std::string(missing.message()).find("GLIDE_UPDATE_GOLDENS=1"), std::string::npos);
  EXPECT_TRUE(std::filesystem::exists(folders_.diffs / "none.actual.png"));
}

}  // namespace
}  // namespace glide::test
