#include "replay/render/frame_sink.h"

#include "replay/common/text.h"
#include "replay/readers/scratch_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/videoio.hpp>

#include <algorithm>
#include <set>
#include <string>

namespace glide::replay {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

constexpr PictureSize kSize{64, 48};

/// A picture of one colour.
RgbPicture plain(std::uint8_t red, std::uint8_t green, std::uint8_t blue) {
  RgbPicture picture{kSize.width, kSize.height, {}};
  for (int i = 0; i < kSize.width * kSize.height; ++i) {
    picture.rgb.insert(picture.rgb.end(), {red, green, blue});
  }
  return picture;
}

std::set<std::string> namesIn(const fs::path& folder) {
  std::set<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder)) {
    names.insert(entry.path().filename().string());
  }
  return names;
}

/// Writes so many frames, 20 a second, red to the left of the middle one and blue after it.
void writeFrames(FrameSink& sink, int frames) {
  for (int i = 0; i < frames; ++i) {
    const RgbPicture picture = i < frames / 2 ? plain(230, 20, 20) : plain(20, 20, 230);
    ASSERT_TRUE(sink.write(picture, 5'000'000'000 + i * 50'000'000).ok());
  }
}

class VideoSink : public testing::TestWithParam<const char*> {};

TEST_P(VideoSink, HoldsTheFramesAtTheirRate) {
  const ScratchFolder folder;
  const fs::path file = folder.path() / "sub" / GetParam();
  auto sink = openFrameSink(file, kSize);
  ASSERT_TRUE(sink.ok()) << sink.error().message;
  writeFrames(**sink, 24);
  EXPECT_FALSE(fs::exists(file));  // not before it is whole
  ASSERT_TRUE((*sink)->finish().ok());
  EXPECT_THAT(namesIn(file.parent_path()), ElementsAre(GetParam()));
  cv::VideoCapture video(file.string(), cv::CAP_FFMPEG);
  EXPECT_NEAR(video.get(cv::CAP_PROP_FPS), 20.0, 0.01);
  int frames = 0;
  for (cv::Mat image; video.read(image); ++frames) {
    ASSERT_EQ(image.size(), cv::Size(kSize.width, kSize.height));
    const auto bgr = image.at<cv::Vec3b>(20, 30);
    const int warm = frames < 12 ? 2 : 0;
    EXPECT_GT(bgr[warm], bgr[2 - warm] + 100) << frames;
  }
  EXPECT_EQ(frames, 24);
}

INSTANTIATE_TEST_SUITE_P(Containers, VideoSink, testing::Values("a.mp4", "a.mkv", "a.AVI"));

TEST(FrameSink, TakesANameWithoutAFolder) {
  const ScratchFolder folder;
  const fs::path before = fs::current_path();
  fs::current_path(folder.path());
  const auto sink = openFrameSink("walk.mp4", kSize);
  EXPECT_TRUE(sink.ok()) << sink.error().message;
  fs::current_path(before);
}

TEST(FrameSink, WritesAVideoOfAFrameOrTwo) {
  for (const int frames : {1, 2}) {
    const ScratchFolder folder;
    const fs::path file = folder.path() / "short.mp4";
    auto sink = openFrameSink(file, kSize);
    ASSERT_TRUE(sink.ok());
    writeFrames(**sink, frames);
    ASSERT_TRUE((*sink)->finish().ok());
    EXPECT_EQ(cv::VideoCapture(file.string()).get(cv::CAP_PROP_FRAME_COUNT), frames);
  }
}

TEST(FrameSink, LeavesNoVideoWithoutFramesOrWithoutAnEnd) {
  const ScratchFolder folder;
  for (const int frames : {0, 20}) {
    auto sink = openFrameSink(folder.path() / "cut.mp4", kSize);
    ASSERT_TRUE(sink.ok());
    writeFrames(**sink, frames);
    const bool is_ended = frames == 0;
    EXPECT_TRUE(!is_ended || (*sink)->finish().ok());
    sink->reset();
    EXPECT_TRUE(fs::is_empty(folder.path()));
  }
}

TEST(FrameSink, NumbersPicturesAndRemovesThoseOfAnEarlierRun) {
  const ScratchFolder folder;
  const fs::path pictures = folder.path() / "new" / "frames";
  for (const int frames : {4, 2}) {
    auto sink = openFrameSink(pictures, kSize);
    ASSERT_TRUE(sink.ok());
    ASSERT_TRUE(writeFile(pictures / "notes.txt", "mine").ok());
    writeFrames(**sink, frames);
    ASSERT_TRUE((*sink)->finish().ok());
  }
  EXPECT_THAT(namesIn(pictures),
              ElementsAre(".glide-pictures", "000000.png", "000001.png", "notes.txt"));
  const cv::Mat first = cv::imread((pictures / "000000.png").string());
  EXPECT_EQ(first.size(), cv::Size(kSize.width, kSize.height));
  EXPECT_EQ(first.at<cv::Vec3b>(10, 10), cv::Vec3b(20, 20, 230));
}

TEST(FrameSink, RemovesNoPicturesOfOthers) {
  const ScratchFolder folder;
  for (const char* name : {"000000.png", "0000000000.png", "1305031102175304.png"}) {
    const fs::path pictures = folder.path() / fs::path(name).stem();
    fs::create_directories(pictures);
    ASSERT_TRUE(writeFile(pictures / name, "mine").ok());
    const auto sink = openFrameSink(pictures, kSize);
    ASSERT_FALSE(sink.ok()) << name;
    EXPECT_THAT(sink.error().message, HasSubstr((pictures / name).string()));
    EXPECT_EQ(*readFile(pictures / name), "mine");
  }
}

TEST(FrameSink, RemovesNoPictureBeyondThoseOfAnEarlierRun) {
  const ScratchFolder folder;
  {
    auto sink = openFrameSink(folder.path(), kSize);
    ASSERT_TRUE(sink.ok());
    writeFrames(**sink, 2);
  }
  ASSERT_TRUE(writeFile(folder.path() / "000002.png", "mine").ok());
  EXPECT_FALSE(openFrameSink(folder.path(), kSize).ok());
  EXPECT_THAT(namesIn(folder.path()),
              ElementsAre(".glide-pictures", "000000.png", "000001.png", "000002.png"));
}

TEST(FrameSink, SaysWhatItCannotWrite) {
  const ScratchFolder folder;
  const fs::path file = folder.path() / "file";
  ASSERT_TRUE(writeFile(file, "no folder").ok());
  for (const fs::path& path : {file / "x.mp4", file / "pictures", file}) {
    const auto sink = openFrameSink(path, kSize);
    ASSERT_FALSE(sink.ok()) << path;
    EXPECT_THAT(sink.error().message, HasSubstr(file.string()));
  }
  fs::create_directories(folder.path() / "folder.mp4");
  EXPECT_FALSE(openFrameSink(folder.path() / "folder.mp4", kSize).ok());
}

}  // namespace
}  // namespace glide::replay
