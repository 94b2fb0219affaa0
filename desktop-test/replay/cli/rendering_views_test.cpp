// What --render-view leaves out and shows alone.
#include "replay/cli/dataset_test.h"
#include "replay/cli/replay_program.h"

#include "glide/render_types.h"

#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include <filesystem>
#include <string>

namespace glide::replay {
namespace {

namespace fs = std::filesystem;

class RenderingViews : public DatasetTest {
 protected:
  /// The picture of the last frame; BGR.
  cv::Mat lastOf(const std::string& view) const {
    const fs::path frames = folder_.path() / view;
    const ProgramResult result = runReplay({dataset().string(),
                                            "-o",
                                            out().string(),
                                            "--deterministic",
                                            "--no-report",
                                            "--progress",
                                            "none",
                                            "--render",
                                            frames.string(),
                                            "--render-view",
                                            view},
                                           folder_.path());
    EXPECT_EQ(result.exit_code, 0) << result.err;
    return cv::imread((frames / "000023.png").string());
  }
  cv::Mat lastImage() const {
    return cv::imread(
        (dataset() / "rgb" / (std::to_string(kRenderedFrames - 1) + ".png")).string());
  }
};

/// How many pixels have about this colour.
int countColor(const cv::Mat& bgr, const Color& color) {
  constexpr double kTolerance = 40.0;  // grey levels: lines are smoothed
  const cv::Scalar wanted(255.0 * color[2], 255.0 * color[1], 255.0 * color[0]);
  const cv::Scalar around = cv::Scalar::all(kTolerance);
  cv::Mat is_wanted;
  cv::inRange(bgr, wanted - around, wanted + around, is_wanted);
  return cv::countNonZero(is_wanted);
}

TEST_F(RenderingViews, OfTheCameraIsItsPictureWithTheMapInACorner) {
  const cv::Mat shown = lastOf("ar");
  ASSERT_EQ(shown.size(), cv::Size(960, 720));
  cv::Mat image, difference;
  cv::resize(lastImage(), image, shown.size(), 0.0, 0.0, cv::INTER_LINEAR);
  cv::absdiff(shown, image, difference);
  const cv::Rect left(0, 0, 480, 720);  // down to the lower edge, where other views have the strip
  const cv::Scalar mean = cv::mean(difference(left));
  for (int channel = 0; channel < 3; ++channel) EXPECT_LT(mean[channel], 4.0);
  const cv::Rect corner(700, 525, 252, 187);
  EXPECT_GT(countColor(shown(corner), kDirectColor), 20);
}

TEST_F(RenderingViews, OfTheMapHasNeitherPictureNorStrip) {
  const cv::Mat shown = lastOf("map");
  ASSERT_EQ(shown.size(), cv::Size(1280, 720));
  EXPECT_GT(countColor(shown, kDirectColor), 50);
  EXPECT_GT(countColor(shown, kIndirectColor), 50);
  constexpr int kPaper = 240;  // grey level at least: no picture lies in the upper left corner
  EXPECT_GT(cv::mean(shown(cv::Rect(0, 0, 60, 60)))[0], kPaper);
  const cv::Mat below = shown.rowRange(720 - 30, 720);
  EXPECT_LT(countColor(below, kDirectColor) + countColor(below, kIndirectColor), 500);
}

}  // namespace
}  // namespace glide::replay
