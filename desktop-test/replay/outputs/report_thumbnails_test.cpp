#include "replay/outputs/report_thumbnails.h"

#include "replay/outputs/base64.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>

#include <algorithm>

namespace glide::replay {
namespace {

using ::testing::ElementsAre;

/// Offers pictures of so many bytes of frames of which every key_stride-th is a keyframe.
ThumbnailStrip filled(std::size_t budget, int frames, int key_stride, std::size_t bytes) {
  ThumbnailStrip strip(budget);
  for (int i = 0; i < frames; ++i) {
    if (strip.wantsNext(i % key_stride == 0)) strip.add(std::vector<std::uint8_t>(bytes, 1));
  }
  return strip;
}

std::size_t sizeOf(const ThumbnailStrip& strip) {
  std::size_t size = 0;
  for (const Thumbnail& picture : strip.pictures()) size += base64Size(picture.jpeg.size());
  return size;
}

std::vector<std::size_t> framesOf(const ThumbnailStrip& strip, bool of_keyframes) {
  std::vector<std::size_t> frames;
  for (const Thumbnail& picture : strip.pictures()) {
    if (picture.is_keyframe == of_keyframes) frames.push_back(picture.frame);
  }
  return frames;
}

SourceFrame grayFrame(int width, int height) {
  SourceFrame frame;
  frame.image.resize(width, height);
  for (int y = 0; y < height; ++y) std::fill_n(frame.image.row(y), width, std::uint8_t{90});
  return frame;
}

TEST(ThumbnailStrip, KeepsEveryFrameWhileTheBudgetLasts) {
  const ThumbnailStrip strip = filled(1000, 10, 5, 60);
  EXPECT_EQ(strip.pictures().size(), 10U);
  EXPECT_THAT(framesOf(strip, true), ElementsAre(0, 5));
}

TEST(ThumbnailStrip, NeverExceedsItsBudget) {
  for (const std::size_t budget : {0U, 50U, 79U, 80U, 81U, 1000U, 5000U}) {
    for (const int key_stride : {1, 7, 10000}) {
      EXPECT_LE(sizeOf(filled(budget, 300, key_stride, 60)), budget) << budget << " " << key_stride;
    }
  }
}

TEST(ThumbnailStrip, ThinsFramesBeforeKeyframesAndEvenly) {
  const ThumbnailStrip strip = filled(1600, 40, 8, 60);  // room for 20 pictures
  EXPECT_THAT(framesOf(strip, true), ElementsAre(0, 8, 16, 24, 32));
  const std::vector<std::size_t> others = framesOf(strip, false);
  ASSERT_GE(others.size(), 8U);
  for (std::size_t i = 2; i < others.size(); ++i) {
    EXPECT_LE(others[i] - others[i - 1], 6U) << "a gap before frame " << others[i];
  }
}

TEST(ThumbnailStrip, FillsAtLeastAQuarterOfItsBudgetOnALongRun) {
  EXPECT_GE(sizeOf(filled(8000, 5000, 9, 60)), 2000U);
}

TEST(ThumbnailJpeg, ShrinksAFrameAndKeepsItsShape) {
  const cv::Mat picture = cv::imdecode(thumbnailJpeg(grayFrame(480, 300)), cv::IMREAD_UNCHANGED);
  EXPECT_EQ(picture.cols, kThumbnailWidth);
  EXPECT_EQ(picture.rows, 150);
  EXPECT_EQ(picture.channels(), 1);
  EXPECT_NEAR(picture.at<std::uint8_t>(75, 120), 90, 2);
}

TEST(ThumbnailJpeg, LeavesASmallFrameAsItIs) {
  const cv::Mat picture = cv::imdecode(thumbnailJpeg(grayFrame(17, 5)), cv::IMREAD_UNCHANGED);
  EXPECT_EQ(picture.cols, 17);
  EXPECT_EQ(picture.rows, 5);
}

TEST(ThumbnailJpeg, ShowsAFlatFrameOfOneRow) {
  const cv::Mat picture = cv::imdecode(thumbnailJpeg(grayFrame(4000, 1)), cv::IMREAD_UNCHANGED);
  EXPECT_EQ(picture.rows, 1);
}

TEST(ThumbnailJpeg, KeepsRedRed) {
  SourceFrame frame = grayFrame(32, 32);
  frame.color = {32, 32, {}};
  for (int i = 0; i < 32 * 32; ++i) frame.color.rgb.insert(frame.color.rgb.end(), {200, 30, 20});
  const cv::Mat picture = cv::imdecode(thumbnailJpeg(frame), cv::IMREAD_COLOR);
  const auto bgr = picture.at<cv::Vec3b>(16, 16);
  EXPECT_NEAR(bgr[2], 200, 6);
  EXPECT_NEAR(bgr[0], 20, 6);
}

}  // namespace
}  // namespace glide::replay
