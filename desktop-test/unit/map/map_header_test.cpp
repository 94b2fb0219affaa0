#include "map/map_header.h"

#include "support/small_map.h"

#include "map/map_io.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace glide {
namespace {

using test::storedSmallMap;
using testing::HasSubstr;

// Where docs/map-format.md says that the fields are.
constexpr std::size_t kVersionOffset = 8, kWidthOffset = 24, kFxOffset = 32, kLensOffset = 64,
                      kCoefficientsOffset = 72, kFactorOffset = 112, kLevelsOffset = 120,
                      kReservedOffset = 124, kTableOffset = 128;

/// The error for a file whose header has a 32-bit number replaced and the checksum made right.
std::string errorWith(std::size_t offset, std::uint32_t number) {
  std::vector<std::byte> file = encodeMap(storedSmallMap({}));
  for (std::size_t i = 0; i < sizeof(number); ++i) {
    file[offset + i] = static_cast<std::byte>((number >> (8 * i)) & 0xFFU);
  }
  sealMapFile(file);
  MapHeader header;
  return readMapHeader(file, &header).value_or("no error");
}

std::vector<std::byte> text(const std::string& words) {
  std::vector<std::byte> bytes;
  for (const char letter : words) bytes.push_back(static_cast<std::byte>(letter));
  return bytes;
}

TEST(MapHeader, TellsWhatIsNoMap) {
  MapHeader header;
  EXPECT_THAT(*readMapHeader({}, &header), HasSubstr("empty"));
  EXPECT_THAT(*readMapHeader(text("seconds,tx,ty"), &header), HasSubstr("not a map"));
  EXPECT_THAT(*readMapHeader(text("GLi"), &header), HasSubstr("truncated"));
  EXPECT_THAT(*readMapHeader(text("GLx"), &header), HasSubstr("not a map"));
}

TEST(MapHeader, RejectsOtherVersions) {
  EXPECT_THAT(errorWith(kVersionOffset, 2), HasSubstr("version 2 of the format"));
  EXPECT_THAT(errorWith(kVersionOffset, 0), HasSubstr("version 0"));
}

TEST(MapHeader, TellsDamageFromTruncation) {
  std::vector<std::byte> file = encodeMap(storedSmallMap({}));
  MapHeader header;
  file.back() ^= std::byte{1};
  EXPECT_THAT(*readMapHeader(file, &header), HasSubstr("checksum"));
  file.pop_back();
  EXPECT_THAT(*readMapHeader(file, &header), HasSubstr("truncated"));
}

TEST(MapHeader, RejectsHostileSizes) {
  for (std::size_t section = 0; section < kMapSections; ++section) {
    const std::size_t entry = kTableOffset + 8 * section;
    EXPECT_THAT(errorWith(entry, 0xFFFFFFFF), HasSubstr("truncated"));
    EXPECT_THAT(errorWith(entry + 4, 0), HasSubstr("wrong size"));
    EXPECT_THAT(errorWith(entry + 4, 0xFFFFFFFF), HasSubstr("wrong size"));
  }
}

TEST(MapHeader, RejectsImpossibleCamerasAndLevels) {
  EXPECT_THAT(errorWith(kWidthOffset, 0), HasSubstr("camera.width"));
  EXPECT_THAT(errorWith(kWidthOffset, 0x7FFFFFFF), HasSubstr("image size"));
  EXPECT_THAT(errorWith(kWidthOffset + 4, 65536), HasSubstr("image size"));
  EXPECT_THAT(errorWith(kFxOffset + 4, 0x7FF80000), HasSubstr("camera.fx"));
  EXPECT_THAT(errorWith(kFxOffset + 4, 0xC0790000), HasSubstr("camera.fx"));
  EXPECT_THAT(errorWith(kLensOffset, 3), HasSubstr("lens model 3"));
  EXPECT_THAT(errorWith(kLensOffset + 4, 6), HasSubstr("6 lens coefficients"));
  EXPECT_THAT(errorWith(kLensOffset + 4, 3), HasSubstr("beyond their number"));
  EXPECT_THAT(errorWith(kLensOffset + 4, 5), HasSubstr("camera.coefficients"));
  EXPECT_THAT(errorWith(kCoefficientsOffset + 4, 0x7FF00000), HasSubstr("finite"));
  EXPECT_THAT(errorWith(kFactorOffset + 4, 0x3FE00000), HasSubstr("scale factor"));
  EXPECT_THAT(errorWith(kFactorOffset + 4, 0x7FF80000), HasSubstr("scale factor"));
  EXPECT_THAT(errorWith(kFactorOffset + 4, 0x40400000), HasSubstr("scale factor"));
  EXPECT_THAT(errorWith(kLevelsOffset, 0), HasSubstr("0 scale levels"));
  EXPECT_THAT(errorWith(kLevelsOffset, 13), HasSubstr("13 scale levels"));
  EXPECT_THAT(errorWith(kReservedOffset, 1), HasSubstr("reserved"));
}

}  // namespace
}  // namespace glide
