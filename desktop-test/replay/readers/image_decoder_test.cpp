#include "replay/readers/image_decoder.h"

#include "replay/readers/scratch_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace glide::replay {
namespace {

std::string faultOf(const std::filesystem::path& file) {
  const Result<ImageU8> image = decodeGray(file);
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
  const Result<ImageU8> image = decodeGray(folder.path() / "a.png");
  ASSERT_TRUE(image.ok());
  ASSERT_EQ(image->width(), 64);
  for (int y = 0; y < 64; ++y) {
    for (int x = 0; x < 64; ++x) ASSERT_EQ(image->at(x, y), expected.at<std::uint8_t>(y, x));
  }
}

TEST(ImageDecoder, ConvertsColourWithAndWithoutAlpha) {
  const ScratchFolder folder;
  for (const int type : {CV_8UC3, CV_8UC4}) {
    const Result<ImageU8> image = decodeGray(folder.writeImage("colour.png", type, 8, 4));
    ASSERT_TRUE(image.ok());
    EXPECT_EQ(image->width(), 8);
    EXPECT_EQ(image->height(), 4);
    EXPECT_EQ(image->at(3, 2), 40);
  }
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
