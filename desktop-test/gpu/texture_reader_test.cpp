#include "gpu/texture_reader.h"

#include "support/app_texture.h"

#include "gpu/gl_test.h"
#include "gpu/luma_upload.h"
#include "gpu/texture_upload.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <optional>
#include <random>
#include <string>

namespace glide::test {
namespace {

using ::testing::HasSubstr;

constexpr int kGroupSize = 64;

/// Random colours, and the grey levels that OpenCV's cvtColor gives them.
struct Colours {
  std::vector<std::uint8_t> rgba;
  ImageU8 grey;
};

Colours randomColours(int width, int height) {
  constexpr std::uint32_t kSeed = 5;
  std::mt19937 random(kSeed);
  Colours colours{{}, ImageU8(width, height)};
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const auto r = static_cast<std::uint32_t>(random() & 0xFFU);
      const auto g = static_cast<std::uint32_t>(random() & 0xFFU);
      const auto b = static_cast<std::uint32_t>(random() & 0xFFU);
      const auto a = static_cast<std::uint32_t>(random() & 0xFFU);
      for (const std::uint32_t value : {r, g, b, a})
        colours.rgba.push_back(static_cast<std::uint8_t>(value));
      colours.grey.at(x, y) =
          static_cast<std::uint8_t>((9798U * r + 19235U * g + 3735U * b + 16384U) >> 15U);
    }
  }
  return colours;
}

/// How a frame lies in the texture: the transform, and the texel of each pixel.
struct Layout {
  std::string name;
  TextureTransform transform;
  FrameSize frame;
  std::function<std::pair<int, int>(int, int)> texel;
};

/// Layouts of frames in a texture of that size, which is larger than 40 x 40.
std::vector<Layout> layouts(int width, int height) {
  const auto w = static_cast<float>(width);
  const auto h = static_cast<float>(height);
  const int last_x = width - 1, last_y = height - 1;
  constexpr int kLeft = 7, kUpper = 3;  // of the crop
  const FrameSize crop{width - 20, height - 10};
  const float crop_w = static_cast<float>(crop.width) / w;
  const float crop_h = static_cast<float>(crop.height) / h;
  return {
      {"as uploaded",
       kUpperRowFirst,
       {width, height},
       [](int x, int y) { return std::pair(x, y); }},
      {"as rendered",
       kLowerRowFirst,
       {width, height},
       [=](int x, int y) { return std::pair(x, last_y - y); }},
      {"mirrored",
       affineTransform({-1, 0, 1}, {0, -1, 1}),
       {width, height},
       [=](int x, int y) { return std::pair(last_x - x, y); }},
      {"turned by a quarter",
       affineTransform({0, 1, 0}, {1, 0, 0}),
       {height, width},
       [=](int x, int y) { return std::pair(last_x - y, x); }},
      {"cropped",
       affineTransform({crop_w, 0, kLeft / w}, {0, -crop_h, kUpper / h + crop_h}),
       crop,
       [](int x, int y) { return std::pair(x + kLeft, y + kUpper); }},
  };
}

ImageU8 frameOf(const ImageU8& texels, const Layout& layout) {
  ImageU8 frame(layout.frame.width, layout.frame.height);
  for (int y = 0; y < frame.height(); ++y) {
    for (int x = 0; x < frame.width(); ++x) {
      const auto [u, v] = layout.texel(x, y);
      frame.at(x, y) = texels.at(u, v);
    }
  }
  return frame;
}

/// Pixels whose grey levels are not the same.
template <class Image>
int differences(const ImageU8& expected, const Image& seen) {
  int count = 0;
  for (int y = 0; y < expected.height(); ++y) {
    for (int x = 0; x < expected.width(); ++x)
      count += static_cast<float>(expected.at(x, y)) != static_cast<float>(seen.at(x, y)) ? 1 : 0;
  }
  return count;
}

class TextureReaderTest : public GlTest {
 protected:
  /// Reads the texture both ways, into level 0 and to the CPU, and compares.
  static void expectFrame(const GlCaps& caps, const Texture& texture, const ImageU8& expected) {
    const FrameSize frame{expected.width(), expected.height()};
    const GlTexture level0 = GlTexture::allocate(GL_R32F, frame.width, frame.height);
    {
      const ScopedGlState state(GlStatePolicy::preserve);
      TextureUpload upload(caps, frame, kGroupSize, ProgramCache());
      GpuCommands commands;
      const Status uploaded = upload.run(texture, level0, GlStatePolicy::preserve, commands);
      ASSERT_TRUE(uploaded.ok()) << uploaded.error().message;
    }
    EXPECT_EQ(differences(expected, readTexture(level0)), 0) << "level 0";
    const auto reader = TextureReader::create(caps, frame, GlStatePolicy::preserve, ProgramCache());
    ASSERT_TRUE(reader.ok()) << reader.error().message;
    const Status checked = (*reader)->check(texture);
    ASSERT_TRUE(checked.ok()) << checked.error().message;
    ImageU8 luma;
    ASSERT_TRUE((*reader)->read(texture, &luma));
    EXPECT_EQ(differences(expected, luma), 0) << "bytes";
  }

  static void expectAllLayouts(const GlCaps& caps, const AppTexture& app, const ImageU8& texels) {
    for (const Layout& layout : layouts(texels.width(), texels.height())) {
      SCOPED_TRACE(layout.name);
      expectFrame(caps, app.texture(layout.transform), frameOf(texels, layout));
    }
  }

  /// An external texture with colours; nothing, and the test is skipped, where there is none.
  std::optional<AppTexture> externalWith(const Colours& colours) {
    Result<AppTexture> app =
        AppTexture::create(AppTextureKind::external, colours.grey.width(), colours.grey.height());
    if (!app) return std::nullopt;
    app->write(colours.rgba);
    return std::move(*app);
  }

  std::string refusal(const Texture& texture) {
    const auto reader =
        TextureReader::create(caps(), {64, 48}, GlStatePolicy::preserve, ProgramCache());
    const Status status = (*reader)->check(texture);
    return status ? "" : status.error().message;
  }

  static constexpr int kWidth = 101, kHeight = 67;  // neither a multiple of a group nor of a word
};

TEST_F(TextureReaderTest, TakesR8AsTheLumaItIs) {
  const ImageU8 texels = randomImage(kWidth, kHeight, 3);
  Result<AppTexture> app = AppTexture::create(AppTextureKind::r8, kWidth, kHeight);
  app->write(texels.view());
  expectAllLayouts(caps(), *app, texels);
}

TEST_F(TextureReaderTest, WeighsColoursAsOpenCvDoes) {
  const Colours colours = randomColours(kWidth, kHeight);
  Result<AppTexture> app = AppTexture::create(AppTextureKind::rgba8, kWidth, kHeight);
  app->write(colours.rgba);
  expectAllLayouts(caps(), *app, colours.grey);
}

TEST_F(TextureReaderTest, SamplesExternalTexturesInTheKernel) {
  const Colours colours = randomColours(kWidth, kHeight);
  const std::optional<AppTexture> app = externalWith(colours);
  if (!app || !caps().has_external_essl3) GTEST_SKIP() << caps().renderer << ": no such texture";
  expectAllLayouts(caps(), *app, colours.grey);
}

TEST_F(TextureReaderTest, DrawsExternalTexturesWhereKernelsCannotSampleThem) {
  const Colours colours = randomColours(kWidth, kHeight);
  const std::optional<AppTexture> app = externalWith(colours);
  if (!app || !caps().has_external) GTEST_SKIP() << caps().renderer << ": no such texture";
  GlCaps without_essl3 = caps();
  without_essl3.has_external_essl3 = false;
  expectAllLayouts(without_essl3, *app, colours.grey);
}

TEST_F(TextureReaderTest, ConvertsWithAsManyCommandsAsPixelsNeed) {
  const ImageU8 image = randomImage(kWidth, kHeight, 3);
  Result<AppTexture> app = AppTexture::create(AppTextureKind::r8, kWidth, kHeight);
  app->write(image.view());
  const GlTexture level0 = GlTexture::allocate(GL_R32F, kWidth, kHeight);
  const ScopedGlState state(GlStatePolicy::preserve);
  const auto pixels = LumaUpload::create(kWidth, kHeight, kGroupSize, ProgramCache());
  TextureUpload texture(caps(), {kWidth, kHeight}, kGroupSize, ProgramCache());
  GpuCommands of_pixels, of_texture;
  pixels->run(image.view(), level0, of_pixels);
  ASSERT_TRUE(
      texture.run(app->texture(kUpperRowFirst), level0, GlStatePolicy::preserve, of_texture).ok());
  const GpuCommandCount expected = of_pixels.count(GpuStage::upload);
  EXPECT_EQ(of_texture.count(GpuStage::upload).dispatches, expected.dispatches);
  EXPECT_EQ(of_texture.count(GpuStage::upload).barriers, expected.barriers);
}

TEST_F(TextureReaderTest, FiltersAFrameThatIsScaled) {
  constexpr int kScale = 2;
  const ImageU8 small = randomImage(32, 24, 9);
  ImageU8 large(kScale * small.width(), kScale * small.height());
  for (int y = 0; y < large.height(); ++y) {
    for (int x = 0; x < large.width(); ++x) large.at(x, y) = small.at(x / kScale, y / kScale);
  }
  Result<AppTexture> app = AppTexture::create(AppTextureKind::r8, large.width(), large.height());
  app->write(large.view());
  expectFrame(caps(), app->texture(kUpperRowFirst), small);
}

TEST_F(TextureReaderTest, NamesWhatItCannotRead) {
  const GlTexture integers = GlTexture::allocate(GL_R8UI, 64, 48);
  const GlTexture small = GlTexture::allocate(GL_R8, 32, 24);
  EXPECT_THAT(refusal({integers.get(), GL_TEXTURE_2D, 64, 48}), HasSubstr("integers"));
  EXPECT_THAT(refusal({small.get(), GL_TEXTURE_2D, 64, 48}), HasSubstr("32x24, not 64x48"));
  EXPECT_THAT(refusal({12345, GL_TEXTURE_2D, 64, 48}), HasSubstr("no texture"));
  EXPECT_EQ(glIsTexture(12345), GL_FALSE) << "asking must not make one";
  GlCaps without = caps();
  without.has_external = without.has_external_essl3 = false;
  const auto reader =
      TextureReader::create(without, {64, 48}, GlStatePolicy::preserve, ProgramCache());
  const Status status = (*reader)->check({small.get(), GL_TEXTURE_EXTERNAL_OES, 64, 48});
  ASSERT_FALSE(status.ok());
  EXPECT_EQ(status.error().code, ErrorCode::unsupported);
}

TEST_F(TextureReaderTest, NamesATextureOfAnotherTarget) {
  const Colours colours = randomColours(64, 48);
  const std::optional<AppTexture> app = externalWith(colours);
  if (!app || !caps().has_external) GTEST_SKIP() << caps().renderer << ": no such texture";
  Texture swapped = app->texture(kUpperRowFirst);
  swapped.target = GL_TEXTURE_2D;
  EXPECT_THAT(refusal(swapped), HasSubstr("target GL_TEXTURE_2D"));
  EXPECT_NE(glGetError(), static_cast<GLenum>(GL_NO_ERROR));  // that of the app's mistake
  forgetDriverMessages();
}

TEST_F(TextureReaderTest, RefusesAndroidBuffersElsewhere) {
  const auto reader =
      TextureReader::create(caps(), {64, 48}, GlStatePolicy::preserve, ProgramCache());
  const Result<Texture> texture = (*reader)->import(HardwareBuffer{});
  ASSERT_FALSE(texture.ok());
  EXPECT_EQ(texture.error().code, ErrorCode::unsupported);
}

}  // namespace
}  // namespace glide::test
