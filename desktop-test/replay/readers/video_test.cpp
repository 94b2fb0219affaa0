#include "replay/readers/video.h"

#include "replay/readers/open_source.h"
#include "replay/readers/scratch_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <opencv2/videoio.hpp>

namespace glide::replay {
namespace {

using ::testing::HasSubstr;

constexpr int kFrames = 10;
constexpr int kGreyStep = 20;  // frame i has grey 20 * i, far beyond what the codec loses

std::filesystem::path writeVideo(const ScratchFolder& folder) {
  const auto file = folder.path() / "walk.avi";
  cv::VideoWriter writer(
      file.string(), cv::CAP_FFMPEG, cv::VideoWriter::fourcc('M', 'J', 'P', 'G'), 20.0, {64, 48});
  for (int i = 0; i < kFrames; ++i) {
    writer.write(cv::Mat(48, 64, CV_8UC3, cv::Scalar::all(kGreyStep * i)));
  }
  return file;
}

std::vector<SourceFrame> framesOf(FrameSource& source) {
  std::vector<SourceFrame> frames;
  while (auto frame = source.next()) frames.push_back(std::move(*frame));
  return frames;
}

TEST(Video, GivesEveryFrameInOrderWithTheContainersTimes) {
  const ScratchFolder folder;
  const auto source = openVideo(writeVideo(folder), {}, std::nullopt);
  ASSERT_TRUE(source.ok()) << source.error().message;
  EXPECT_EQ((*source)->info().name, "walk");
  EXPECT_EQ((*source)->info().frames, kFrames);
  const auto frames = framesOf(**source);
  ASSERT_EQ(frames.size(), static_cast<std::size_t>(kFrames));
  for (int i = 0; i < kFrames; ++i) {
    const SourceFrame& frame = frames[static_cast<std::size_t>(i)];
    EXPECT_NEAR(static_cast<double>(frame.t_ns - frames[0].t_ns) * 1e-9, 0.05 * i, 1e-6);
    EXPECT_NEAR(frame.image.at(30, 20), kGreyStep * i, 4);
    EXPECT_EQ(frame.image.width(), 64);
    ASSERT_EQ(frame.color.rgb.size(), 3U * 64U * 48U);
    EXPECT_NEAR(frame.color.rgb[3 * (20 * 64 + 30)], kGreyStep * i, 4);
  }
  EXPECT_TRUE((*source)->skips().skips().empty());
}

TEST(Video, ObeysAGivenFrameRateAndASelection) {
  const ScratchFolder folder;
  FrameSelection selection;
  selection.start_s = 0.2;
  selection.duration_s = 0.55;
  selection.stride = 2;
  selection.max_frames = 2;
  const auto source = openVideo(writeVideo(folder), selection, 10.0);
  ASSERT_TRUE(source.ok());
  EXPECT_EQ((*source)->info().frames, 2);
  const auto frames = framesOf(**source);
  ASSERT_EQ(frames.size(), 2u);
  EXPECT_EQ(frames[0].t_ns, 200000000);
  EXPECT_EQ(frames[1].t_ns, 400000000);
  EXPECT_NEAR(frames[1].image.at(0, 0), 4 * kGreyStep, 4);
}

TEST(Video, IsRecognisedByItsName) {
  const ScratchFolder folder;
  const auto opened = openSource(writeVideo(folder).string(), {}, std::nullopt);
  ASSERT_TRUE(opened.ok());
  EXPECT_EQ(opened->frames->info().kind, "video");
}

TEST(Video, RefusesWhatIsNoVideo) {
  const ScratchFolder folder;
  const auto source = openVideo(folder.write("fake.mp4", "nothing"), {}, std::nullopt);
  ASSERT_FALSE(source.ok());
  EXPECT_THAT(source.error().message, HasSubstr("fake.mp4: is no video"));
}

TEST(Video, RefusesASelectionBeyondItsEnd) {
  const ScratchFolder folder;
  FrameSelection late;
  late.start_s = 60.0;
  const auto source = openVideo(writeVideo(folder), late, std::nullopt);
  ASSERT_FALSE(source.ok());
  EXPECT_THAT(source.error().message, HasSubstr("no frame in the part asked for"));
}

}  // namespace
}  // namespace glide::replay
