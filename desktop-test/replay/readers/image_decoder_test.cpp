#include "replay/readers/image_decoder.h"

#include "replay/readers/scratch_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace glide::replay {
namespace {

std::string faultOf(const std::filesystem::path& file) {
  const Result<DecodedImage> image = decodeImage(file);
  return image ? "" : image.error().message;
}

/// Noise does not compress, so half of the file is half of the rows.
cv::Mat noise() {
  cv::Mat image(64, 64, CV_8UC1);
  cv::theRNG().state = 7;
  cv::randu(image, 0, 256);
  return image;
}

std::filesystem::path writeHalf(const ScratchFolder& folder, const std::string& name) {
  const auto file = folder.path() / name;
  EXPECT_TRUE(cv::imwrite(file.string(), noise()));
  const auto bytes = readFile(file);
  return folder.write(name, bytes->substr(0, bytes->size() / 2));
}

TEST(ImageDecoder, ReadsGrayPixelsExactly) {
  const ScratchFolder folder;
  const cv::Mat expected = noise();
  cv::imwrite((folder.path() / "a.png").string(), expected);
  const Result<DecodedImage> image = decodeImage(folder.path() / "a.png");
  ASSERT_TRUE(image.ok());
  ASSERT_EQ(image->gray.width(), 64);
  for (int y = 0; y < 64; ++y) {
    for (int x = 0; x < 64; ++x) ASSERT_EQ(image->gray.at(x, y), expected.at<std::uint8_t>(y, x));
  }
  EXPECT_TRUE(image->color.rgb.empty());
}

TEST(ImageDecoder, ConvertsColourWithAndWithoutAlpha) {
  const ScratchFolder folder;
  for (const int type : {CV_8UC3, CV_8UC4}) {
    const Result<DecodedImage> image = decodeImage(folder.writeImage("colour.png", type, 8, 4));
    ASSERT_TRUE(image.ok());
    EXPECT_EQ(image->gray.width(), 8);
    EXPECT_EQ(image->gray.height(), 4);
    EXPECT_EQ(image->gray.at(3, 2), 40);
  }
}

TEST(ImageDecoder, KeepsTheColoursInTheOrderRedGreenBlue) {
  const ScratchFolder folder;
  cv::Mat pixels(3, 5, CV_8UC3, cv::Scalar(200, 100, 50));  // blue, green, red
  pixels.at<cv::Vec3b>(1, 2) = {1, 2, 3};
  const auto file = folder.path() / "colour.png";
  ASSERT_TRUE(cv::imwrite(file.string(), pixels));
  const Result<DecodedImage> image = decodeImage(file);
  ASSERT_TRUE(image.ok());
  ASSERT_EQ(image->color.width, 5);
  ASSERT_EQ(image->color.height, 3);
  ASSERT_EQ(image->color.rgb.size(), 45U);
  EXPECT_THAT(std::vector<int>(image->color.rgb.begin() + 18, image->color.rgb.begin() + 24),
              ::testing::ElementsAre(50, 100, 200, 3, 2, 1));
  EXPECT_EQ(image->gray.at(0, 0), 96);  // 0.299 * 50 + 0.587 * 100 + 0.114 * 200
}

TEST(ImageDecoder, RefusesSixteenBits) {
  const ScratchFolder folder;
  EXPECT_EQ(faultOf(folder.writeImage("depth.png", CV_16UC1, 8, 8)),
            "do not have 8 bits per channel");
}

TEST(ImageDecoder, RefusesAnEmptyFile) {
  const ScratchFolder folder;
  EXPECT_EQ(faultOf(folder.write("empty.png", "")), "are empty files");
}

TEST(ImageDecoder, RefusesAMissingFile) {
  EXPECT_EQ(faultOf("/no/such/image.png"), "cannot be opened");
}

TEST(ImageDecoder, RefusesTextThatIsCalledAnImage) {
  const ScratchFolder folder;
  EXPECT_EQ(faultOf(folder.write("text.png", "not a picture")), "cannot be decoded");
}

TEST(ImageDecoder, RefusesATruncatedPng) {
  const ScratchFolder folder;
  EXPECT_EQ(faultOf(writeHalf(folder, "half.png")), "are truncated");
}

TEST(ImageDecoder, RefusesATruncatedJpeg) {
  const ScratchFolder folder;
  EXPECT_EQ(faultOf(writeHalf(folder, "half.jpg")), "are truncated");
}

TEST(ImageDecoder, RefusesAPngWhoseDataIsDamaged) {
  const ScratchFolder folder;
  const auto file = folder.path() / "damaged.png";
  cv::imwrite(file.string(), noise());
  std::string bytes = readFile(file).value();
  std::fill_n(bytes.begin() + 45, 400, 'x');
  folder.write("damaged.png", bytes);
  EXPECT_EQ(faultOf(file), "cannot be decoded");
}

TEST(ImageDecoder, RefusesAnImageWithoutPixels) {
  const ScratchFolder folder;
  EXPECT_EQ(faultOf(folder.write("zero.pgm", "P5\n0 0\n255\n")), "cannot be decoded");
}

}  // namespace
}  // namespace glide::replay
