#include "replay/outputs/base64.h"

#include <gtest/gtest.h>

namespace glide::replay {
namespace {

std::string encoded(const std::string& text) {
  return base64({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
}

TEST(Base64, EncodesTheVectorsOfRfc4648) {
  EXPECT_EQ(encoded(""), "");
  EXPECT_EQ(encoded("f"), "Zg==");
  EXPECT_EQ(encoded("fo"), "Zm8=");
  EXPECT_EQ(encoded("foo"), "Zm9v");
  EXPECT_EQ(encoded("foob"), "Zm9vYg==");
  EXPECT_EQ(encoded("fooba"), "Zm9vYmE=");
  EXPECT_EQ(encoded("foobar"), "Zm9vYmFy");
}

TEST(Base64, EncodesBytesAboveTheAsciiRange) {
  const std::vector<std::uint8_t> bytes = {0xFF, 0xFE, 0xFD, 0x00};
  EXPECT_EQ(base64(bytes), "//79AA==");
}

TEST(Base64, TellsTheLengthBeforehand) {
  for (std::size_t size = 0; size < 10; ++size) {
    EXPECT_EQ(base64(std::vector<std::uint8_t>(size)).size(), base64Size(size)) << size;
  }
}

TEST(Base64, EncodesNumbersInLittleEndianOrder) {
  EXPECT_EQ(base64Of(std::vector<std::uint32_t>{1}), "AQAAAA==");
  EXPECT_EQ(base64Of(std::vector<float>{1.0F}), "AACAPw==");
}

}  // namespace
}  // namespace glide::replay
