#include "support/golden_image.h"

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include <cstdlib>
#include <string_view>

namespace glide::test {
namespace {

// In a picture of differences: twice the tolerated step is white.
constexpr double kWhiteSteps = 2.0;

/// A view of the picture's pixels.
cv::Mat viewOf(const RgbPicture& picture) {
  return {picture.height,
          picture.width,
          CV_8UC3,
          const_cast<std::uint8_t*>(picture.pixels.data())};  // only read
}

RgbPicture pictureOf(const cv::Mat& rgb) {
  return {rgb.cols, rgb.rows, {rgb.datastart, rgb.dataend}};
}

cv::Mat blurredLab(const RgbPicture& picture, double blur_px) {
  cv::Mat colors, lab;
  viewOf(picture).convertTo(colors, CV_32FC3, 1.0 / 255.0);
  cv::GaussianBlur(colors, colors, cv::Size(), blur_px);
  cv::cvtColor(colors, lab, cv::COLOR_RGB2Lab);
  return lab;
}

/// Distance of the colours of each pixel, of pictures of one size.
cv::Mat colorSteps(const RgbPicture& a, const RgbPicture& b, double blur_px) {
  const cv::Mat difference = blurredLab(a, blur_px) - blurredLab(b, blur_px);
  cv::Mat steps(difference.size(), CV_32F);
  for (int y = 0; y < steps.rows; ++y) {
    for (int x = 0; x < steps.cols; ++x)
      steps.at<float>(y, x) = static_cast<float>(cv::norm(difference.at<cv::Vec3f>(y, x)));
  }
  return steps;
}

bool haveSameSize(const RgbPicture& a, const RgbPicture& b) {
  return a.width == b.width && a.height == b.height && !a.pixels.empty();
}

RgbPicture differencePicture(const RgbPicture& a,
                             const RgbPicture& b,
                             const GoldenTolerance& tolerance) {
  cv::Mat gray, rgb;
  const double scale = 255.0 / (kWhiteSteps * tolerance.color_step);
  colorSteps(a, b, tolerance.blur_px).convertTo(gray, CV_8U, scale);
  cv::cvtColor(gray, rgb, cv::COLOR_GRAY2RGB);
  return pictureOf(rgb);
}

bool isUpdating() {
  const char* value = std::getenv("GLIDE_UPDATE_GOLDENS");
  return value != nullptr && std::string_view(value) == "1";
}

/// Writes the pictures that show what is wrong; their names.
std::string leaveDiffs(const RgbPicture& actual,
                       const RgbPicture& expected,
                       const std::filesystem::path& stem) {
  const std::string base = stem.string();
  writePng(base + ".actual.png", actual);
  std::string names = base + ".actual.png";
  if (expected.pixels.empty()) return names;
  writePng(base + ".expected.png", expected);
  names += ", " + base + ".expected.png";
  if (!haveSameSize(actual, expected)) return names;
  writePng(base + ".diff.png", differencePicture(actual, expected, {}));
  return names + ", " + base + ".diff.png";
}

}  // namespace

RgbPicture readPng(const std::filesystem::path& file) {
  if (!std::filesystem::exists(file)) return {};
  const cv::Mat bgr = cv::imread(file.string(), cv::IMREAD_COLOR);
  if (bgr.empty()) return {};
  cv::Mat rgb;
  cv::cvtColor(bgr, rgb, cv::COLOR_BGR2RGB);
  return pictureOf(rgb);
}

void writePng(const std::filesystem::path& file, const RgbPicture& picture) {
  std::error_code ignored;  // what cannot be written is missed by who looks for it
  std::filesystem::create_directories(file.parent_path(), ignored);
  cv::Mat bgr;
  cv::cvtColor(viewOf(picture), bgr, cv::COLOR_RGB2BGR);
  constexpr int kSmallest = 9;  // goldens are committed
  cv::imwrite(file.string(), bgr, {cv::IMWRITE_PNG_COMPRESSION, kSmallest});
}

double shareOff(const RgbPicture& a, const RgbPicture& b, const GoldenTolerance& tolerance) {
  if (!haveSameSize(a, b)) return 1.0;
  const cv::Mat steps = colorSteps(a, b, tolerance.blur_px);
  return static_cast<double>(cv::countNonZero(steps > tolerance.color_step)) /
         static_cast<double>(steps.total());
}

GoldenFolders goldenFolders() {
  const char* source = std::getenv("GLIDE_SOURCE_DIR");
  const std::filesystem::path root = source != nullptr ? source : ".";
  return {root / "desktop-test" / "golden", GLIDE_GOLDEN_DIFFS};
}

testing::AssertionResult looksAsGolden(const RgbPicture& actual,
                                       const std::string& name,
                                       const GoldenFolders& folders) {
  const std::filesystem::path golden = folders.goldens / (name + ".png");
  if (isUpdating()) {
    writePng(golden, actual);
    return testing::AssertionSuccess() << "wrote " << golden;
  }
  const GoldenTolerance tolerance;
  const RgbPicture expected = readPng(golden);
  const double share = shareOff(actual, expected, tolerance);
  if (share <= tolerance.share_off) return testing::AssertionSuccess();
  const std::string shown = leaveDiffs(actual, expected, folders.diffs / name);
  if (expected.pixels.empty())
    return testing::AssertionFailure()
           << "there is no " << golden << "; look at " << shown
           << " and, if it is right, run the test with GLIDE_UPDATE_GOLDENS=1";
  return testing::AssertionFailure()
         << 100.0 * share << " % of the pixels differ from " << golden << ": see " << shown;
}

testing::AssertionResult looksAsGolden(const RgbPicture& actual, const std::string& name) {
  return looksAsGolden(actual, name, goldenFolders());
}

}  // namespace glide::test
