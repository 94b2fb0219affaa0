#include "replay/common/text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace glide::replay {
namespace {

using ::testing::ElementsAre;

std::filesystem::path scratchFile(const std::string& text) {
  const auto file = std::filesystem::path(testing::TempDir()) / "glide_text_test.txt";
  EXPECT_TRUE(writeFile(file, text).ok());
  return file;
}

TEST(Text, ReadsSecondsToTheNanosecond) {
  EXPECT_EQ(parseSeconds("1403636584.763555584"), 1403636584763555584);
  EXPECT_EQ(parseSeconds("0.1"), 100000000);
  EXPECT_EQ(parseSeconds("7"), 7000000000);
  EXPECT_EQ(parseSeconds(".5"), 500000000);
  EXPECT_EQ(parseSeconds("-1.5"), -1500000000);
  EXPECT_EQ(parseSeconds("1.00000000099"), 1000000000);
  EXPECT_EQ(parseSeconds("1.5e1"), 15000000000);
}

TEST(Text, RefusesWhatIsNoTime) {
  for (const char* text : {"", ".", "-", "1.2.3", "abc", "1403636584763555584", "nan", "1e30"}) {
    EXPECT_EQ(parseSeconds(text), std::nullopt) << text;
  }
}

TEST(Text, WritesSecondsThatItReadsBack) {
  for (const std::int64_t t_ns : {std::int64_t{0},
                                  std::int64_t{1403636584763555584},
                                  std::int64_t{5},
                                  std::int64_t{-1500000001}}) {
    EXPECT_EQ(parseSeconds(secondsText(t_ns)), t_ns);
  }
  EXPECT_EQ(secondsText(5), "0.000000005");
}

TEST(Text, GivesTheDoubleThatOthersRead) {
  EXPECT_EQ(toSeconds(1403636584763555584), 1403636584.763555584);
}

TEST(Text, ReadsNumbersThatFillTheWholeText) {
  EXPECT_EQ(parseNumber("-1.5e-3"), -1.5e-3);
  EXPECT_EQ(parseNumber("+2"), 2.0);
  for (const char* text : {"", "1,5", "1.5x", "inf", "nan", "0x10"}) {
    EXPECT_EQ(parseNumber(text), std::nullopt) << text;
  }
  EXPECT_EQ(parseInteger("12"), 12);
  EXPECT_EQ(parseInteger("12.0"), std::nullopt);
}

TEST(Text, SplitsAtAnySeparator) {
  EXPECT_THAT(splitFields("a, b ,c", ", "), ElementsAre("a", "b", "c"));
  EXPECT_TRUE(splitFields(" , ", ", ").empty());
}

TEST(Text, KeepsLineNumbersPastCommentsBlanksAndCarriageReturns) {
  const auto lines = readDataLines(scratchFile("# head\r\n\r\n  first\r\n#no\nsecond"));
  ASSERT_TRUE(lines.ok());
  ASSERT_EQ(lines->size(), 2u);
  EXPECT_EQ((*lines)[0].number, 3);
  EXPECT_EQ((*lines)[0].text, "first");
  EXPECT_EQ((*lines)[1].number, 5);
}

TEST(Text, NamesTheFileThatItCannotRead) {
  const auto missing = readFile("/no/such/file");
  ASSERT_FALSE(missing.ok());
  EXPECT_THAT(missing.error().message, testing::HasSubstr("/no/such/file"));
  EXPECT_FALSE(readFile(testing::TempDir()).ok());
  EXPECT_FALSE(writeFile("/no/such/file", "x").ok());
}

}  // namespace
}  // namespace glide::replay
