#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace glide::test {

/// Rows of red, green, blue bytes, the uppermost first, no padding: as RenderTarget::readRgb gives.
struct RgbPicture {
  int width = 0, height = 0;  ///< px
  std::vector<std::uint8_t> pixels;
};

/// nothing in it when there is no such file.
RgbPicture readPng(const std::filesystem::path& file);
void writePng(const std::filesystem::path& file, const RgbPicture& picture);

/// How far two pictures may differ: both are blurred by a Gaussian, since anti-aliasing differs by
/// a fraction of a pixel from driver to driver, and compared in CIE L*a*b*.
struct GoldenTolerance {
  double blur_px = 0.8;       ///< standard deviation
  double color_step = 6.0;    ///< CIE76; 2.3 is just noticeable, 6 anyone sees side by side
  double share_off = 1.0e-3;  ///< of the pixels may differ by more: an edge somewhere
};

/// Share of the pixels that differ by more than the tolerance; 1 when the sizes do.
double shareOff(const RgbPicture& a, const RgbPicture& b, const GoldenTolerance& tolerance);

/// Where goldens lie, and where pictures go that are not as they should be.
struct GoldenFolders {
  std::filesystem::path goldens;  ///< desktop-test/golden of the source tree
  std::filesystem::path diffs;    ///< golden-diffs of the build tree
};
GoldenFolders goldenFolders();

/// Whether the picture looks as goldens/NAME.png does. If not,
/// diffs/NAME.{actual,expected,diff}.png show it, and the message names them. With
/// GLIDE_UPDATE_GOLDENS=1 in the environment it writes the golden instead.
testing::AssertionResult looksAsGolden(const RgbPicture& actual,
                                       const std::string& name,
                                       const GoldenFolders& folders);
testing::AssertionResult looksAsGolden(const RgbPicture& actual, const std::string& name);

}  // namespace glide::test
