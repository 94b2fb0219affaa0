// Where the camera's picture lies in the framebuffer, pixel by pixel.
#include "support/app_texture.h"

#include "render/camera_scene.h"

#include "gpu/gl_test.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <optional>
#include <random>

namespace glide::test {
namespace {

using ::testing::HasSubstr;

constexpr int kWidth = 40, kHeight = 30;
using Pixel = std::array<int, 3>;
constexpr Pixel kBackground{51, 51, 51};  // of drawn()

Pixel pixelAt(const RgbPicture& picture, int x, int y) {
  const auto at = static_cast<std::size_t>(3 * (y * picture.width + x));
  return {picture.pixels[at], picture.pixels[at + 1], picture.pixels[at + 2]};
}

/// Colours that differ in every pixel, four bytes each.
std::vector<std::uint8_t> noise() {
  std::mt19937 random(7);
  std::vector<std::uint8_t> rgba(static_cast<std::size_t>(4 * kWidth * kHeight));
  for (std::uint8_t& value : rgba) value = static_cast<std::uint8_t>(random());
  return rgba;
}

Pixel noiseAt(const std::vector<std::uint8_t>& rgba, int x, int y) {
  const auto at = static_cast<std::size_t>(4 * (y * kWidth + x));
  return {rgba[at], rgba[at + 1], rgba[at + 2]};
}

class CameraPictureTest : public GlTest {
 protected:
  static CameraRenderer makeRenderer() {
    Result<CameraRenderer> made =
        CameraRenderer::create(GlStatePolicy::preserve, pinhole(kWidth, kHeight));
    EXPECT_TRUE(made.ok()) << made.error().message;
    return std::move(*made);
  }
  /// A target of that size with the picture in the whole of it.
  static RgbPicture show(const Picture& picture, int width, int height) {
    CameraRenderer renderer = makeRenderer();
    return drawn(width, height, [&](const Viewport& viewport) {
      const Status status = renderer.drawPicture(picture, viewport);
      EXPECT_TRUE(status.ok()) << status.error().message;
    });
  }
  static Error errorOf(const Picture& picture) {
    CameraRenderer renderer = makeRenderer();
    Error error;
    drawn(kWidth, kHeight, [&](const Viewport& viewport) {
      const Status status = renderer.drawPicture(picture, viewport);
      if (!status) error = status.error();
    });
    return error;
  }
};

TEST_F(CameraPictureTest, LumaIsExactAtOneToOne) {
  const ImageU8 image = randomImage(kWidth, kHeight, 3);
  const RgbPicture shown =
      show(Luma{image.row(0), kWidth, kHeight, image.stride()}, kWidth, kHeight);
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const int grey = image.at(x, y);
      ASSERT_EQ(pixelAt(shown, x, y), (Pixel{grey, grey, grey})) << x << ", " << y;
    }
  }
}

TEST_F(CameraPictureTest, RgbIsExactAtOneToOneWhateverItsStride) {
  const std::vector<std::uint8_t> rgba = noise();
  for (const int padding : {0, 1, 3}) {
    const int stride = 3 * kWidth + padding;
    std::vector<std::uint8_t> rows(static_cast<std::size_t>(stride * kHeight));
    for (int y = 0; y < kHeight; ++y) {
      for (int x = 0; x < kWidth; ++x) {
        const Pixel color = noiseAt(rgba, x, y);
        for (std::size_t i = 0; i < 3; ++i)
          rows[static_cast<std::size_t>(y * stride + 3 * x) + i] =
              static_cast<std::uint8_t>(color[i]);
      }
    }
    const RgbPicture shown = show(Rgb{rows.data(), kWidth, kHeight, stride}, kWidth, kHeight);
    for (int y = 0; y < kHeight; ++y) {
      for (int x = 0; x < kWidth; ++x)
        ASSERT_EQ(pixelAt(shown, x, y), noiseAt(rgba, x, y)) << padding << ": " << x << ", " << y;
    }
  }
}

TEST_F(CameraPictureTest, TheRestOfTheViewportAndWhatIsOutsideStays) {
  const ImageU8 white = [] {
    ImageU8 image(kWidth, kHeight);
    for (int y = 0; y < kHeight; ++y) std::fill_n(image.row(y), kWidth, std::uint8_t{255});
    return image;
  }();
  CameraRenderer renderer = makeRenderer();
  const Luma luma{white.row(0), kWidth, kHeight, white.stride()};
  // A viewport of 100 x 45 px: the picture takes 60 x 45, with 20 px on each side.
  const RgbPicture shown = drawn(120, 70, [&](const Viewport&) {
    EXPECT_TRUE(renderer.drawPicture(luma, {10, 5, 100, 45}).ok());
  });
  constexpr Pixel kWhite{255, 255, 255};
  for (int y = 0; y < 70; ++y) {
    for (int x = 0; x < 120; ++x) {
      const bool inside = x >= 30 && x < 90 && y >= 20 && y < 65;  // rows from above
      ASSERT_EQ(pixelAt(shown, x, y), inside ? kWhite : kBackground) << x << ", " << y;
    }
  }
}

TEST_F(CameraPictureTest, EnlargedItIsSmoothAndShrunkItIsAveraged) {
  ImageU8 stripes(kWidth, kHeight);
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) stripes.at(x, y) = x % 2 == 0 ? 0 : 200;
  }
  const Luma luma{stripes.row(0), kWidth, kHeight, stripes.stride()};
  const RgbPicture large = show(luma, 4 * kWidth, 4 * kHeight);
  EXPECT_EQ(pixelAt(large, 4 * 7 + 2, 10)[0], pixelAt(large, 4 * 7 + 1, 10)[0] - 0)
      << "the middle of a stripe is symmetric";
  EXPECT_GT(pixelAt(large, 4 * 7, 10)[0], 60);
  EXPECT_LT(pixelAt(large, 4 * 7, 10)[0], 190);
  const RgbPicture small = show(luma, kWidth / 2, kHeight / 2);
  for (int x = 1; x + 1 < kWidth / 2; ++x) EXPECT_NEAR(pixelAt(small, x, 7)[0], 100, 2);
}

/// A transform of a texture, and which of its texels is pixel (x, y) of a frame.
struct Orientation {
  TextureTransform transform;
  std::function<std::array<int, 2>(int, int)> texel;
};

std::vector<Orientation> orientations() {
  return {{kUpperRowFirst,
           [](int x, int y) {
             return std::array<int, 2>{x, y};
           }},
          {kLowerRowFirst,
           [](int x, int y) {
             return std::array<int, 2>{x, kHeight - 1 - y};
           }},
          // Mirrored, as a front camera's.
          {affineTransform({-1.0F, 0.0F, 1.0F}, {0.0F, -1.0F, 1.0F}), [](int x, int y) {
             return std::array<int, 2>{kWidth - 1 - x, y};
           }}};
}

void expectShown(const AppTexture& texture,
                 const std::vector<std::uint8_t>& rgba,
                 const Orientation& orientation) {
  Result<CameraRenderer> renderer =
      CameraRenderer::create(GlStatePolicy::preserve, pinhole(kWidth, kHeight));
  ASSERT_TRUE(renderer.ok());
  const RgbPicture shown = drawn(kWidth, kHeight, [&](const Viewport& viewport) {
    const Status status = renderer->drawPicture(texture.texture(orientation.transform), viewport);
    ASSERT_TRUE(status.ok()) << status.error().message;
  });
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const std::array<int, 2> texel = orientation.texel(x, y);
      ASSERT_EQ(pixelAt(shown, x, y), noiseAt(rgba, texel[0], texel[1])) << x << ", " << y;
    }
  }
}

TEST_F(CameraPictureTest, TexturesAreShownAsTheirTransformSays) {
  Result<AppTexture> texture = AppTexture::create(AppTextureKind::rgba8, kWidth, kHeight);
  ASSERT_TRUE(texture.ok());
  const std::vector<std::uint8_t> rgba = noise();
  texture->write(rgba);
  for (const Orientation& orientation : orientations()) expectShown(*texture, rgba, orientation);
}

TEST_F(CameraPictureTest, ExternalTexturesAreShownAsTheirTransformSays) {
  Result<AppTexture> texture = AppTexture::create(AppTextureKind::external, kWidth, kHeight);
  if (!texture || !caps().has_external) GTEST_SKIP() << caps().renderer << ": no such texture";
  const std::vector<std::uint8_t> rgba = noise();
  texture->write(rgba);
  for (const Orientation& orientation : orientations()) expectShown(*texture, rgba, orientation);
}

TEST_F(CameraPictureTest, TexturesWithoutColoursAreGrey) {
  Result<AppTexture> texture = AppTexture::create(AppTextureKind::r8, kWidth, kHeight);
  ASSERT_TRUE(texture.ok());
  const ImageU8 image = randomImage(kWidth, kHeight, 9);
  texture->write(image.view());
  const RgbPicture shown = show(texture->texture(kUpperRowFirst), kWidth, kHeight);
  const int grey = image.at(11, 6);
  EXPECT_EQ(pixelAt(shown, 11, 6), (Pixel{grey, grey, grey}));
}

TEST_F(CameraPictureTest, PicturesMayChangeTheirKindAndSize) {
  CameraRenderer renderer = makeRenderer();
  const std::vector<std::uint8_t> bytes(3 * 80 * 60, 200);
  const RgbPicture shown = drawn(kWidth, kHeight, [&](const Viewport& viewport) {
    EXPECT_TRUE(renderer.drawPicture(Luma{bytes.data(), kWidth, kHeight, kWidth}, viewport).ok());
    EXPECT_TRUE(renderer.drawPicture(Rgb{bytes.data(), 80, 60, 240}, viewport).ok());
    EXPECT_TRUE(renderer.drawPicture(Luma{bytes.data(), 80, 60, 80}, viewport).ok());
  });
  EXPECT_EQ(pixelAt(shown, 20, 15), (Pixel{200, 200, 200}));
}

TEST_F(CameraPictureTest, WhatIsNoPictureIsRefusedByName) {
  const std::vector<std::uint8_t> bytes(3 * kWidth * kHeight);
  const Error none = errorOf(Luma{nullptr, kWidth, kHeight, kWidth});
  EXPECT_EQ(none.code, ErrorCode::invalid_argument);
  EXPECT_THAT(none.message, HasSubstr("picture has no pixels"));
  EXPECT_THAT(errorOf(Luma{bytes.data(), 0, kHeight, kWidth}).message, HasSubstr("no pixels"));
  EXPECT_THAT(errorOf(Rgb{bytes.data(), kWidth, kHeight, kWidth}).message,
              HasSubstr("picture.stride"));
  EXPECT_THAT(errorOf(Texture{}).message, HasSubstr("picture's name is 0"));
  const Error missing = errorOf(Texture{4711, GL_TEXTURE_2D, kWidth, kHeight, kUpperRowFirst});
  EXPECT_EQ(missing.code, ErrorCode::invalid_argument);
  EXPECT_THAT(missing.message, HasSubstr("picture's name 4711 is no texture"));
}

TEST_F(CameraPictureTest, AViewportWithoutPixelsIsRefused) {
  CameraRenderer renderer = makeRenderer();
  const std::vector<std::uint8_t> bytes(kWidth * kHeight);
  const Viewport empty{0, 0, kWidth, 0};
  const Luma luma{bytes.data(), kWidth, kHeight, kWidth};
  for (const Status& status : {renderer.drawPicture(luma, empty),
                               renderer.drawPoints({}, TrackerKind::direct, empty),
                               renderer.drawAr({}, {}, empty)}) {
    ASSERT_FALSE(status.ok());
    EXPECT_EQ(status.error().code, ErrorCode::invalid_argument);
    EXPECT_THAT(status.error().message, HasSubstr("40x0"));
  }
}

TEST_F(CameraPictureTest, PointsAreDrawnWhereThePictureShowsThem) {
  CameraRenderer renderer = makeRenderer();
  const std::vector<std::uint8_t> bytes(kWidth * kHeight);
  std::vector<TrackedPoint> points(1);
  points[0].u = 30.0F;
  points[0].v = 10.0F;
  points[0].inlier = true;
  // Four px for each of the picture's, above a bar of 40 px.
  const RgbPicture shown = drawn(4 * kWidth, 4 * kHeight + 80, [&](const Viewport& viewport) {
    const Luma luma{bytes.data(), kWidth, kHeight, kWidth};
    EXPECT_TRUE(renderer.drawPicture(luma, viewport).ok());
    EXPECT_TRUE(renderer.drawPoints(points, TrackerKind::direct, viewport).ok());
  });
  EXPECT_GT(pixelAt(shown, 122, 82)[1], 190);
  EXPECT_EQ(pixelAt(shown, 132, 82), (Pixel{0, 0, 0}));
  EXPECT_EQ(pixelAt(shown, 122, 92), (Pixel{0, 0, 0}));
}

}  // namespace
}  // namespace glide::test
