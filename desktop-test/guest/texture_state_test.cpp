// Sessions that read an app's textures leave its GL state and objects alone, whichever way they
// take to the texture.
#include "guest/guest_fixture.h"
#include "support/app_texture.h"
#include "support/gl_app.h"

#include "gpu/gl_caps.h"
#include "gpu/gl_draw_state.h"
#include "gpu/gl_state.h"
#include "gpu/program_cache.h"
#include "gpu/texture_reader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <optional>
#include <utility>

namespace glide::test {
namespace {

constexpr FrameSize kFrame{64, 48};

class GuestTextureTest : public GuestTest {
 protected:
  /// A texture of the app with one grey level in it; nothing where there is no such texture.
  static std::optional<AppTexture> greyTexture(AppTextureKind kind, FrameSize size) {
    Result<AppTexture> texture = AppTexture::create(kind, size.width, size.height);
    if (!texture) return std::nullopt;
    texture->write(
        std::vector<std::uint8_t>(static_cast<std::size_t>(4 * size.width * size.height), kGrey));
    return std::move(*texture);
  }

  /// Reads the texture in many states of an app, and compares each with what is there afterwards.
  static void expectStateKept(const GlCaps& caps, const AppTexture& texture) {
    const Texture input = texture.texture(kUpperRowFirst);
    GlApp gl_app(21);
    for (int round = 0; round < 12; ++round) {
      gl_app.randomise();
      const GlSnapshot objects = gl_app.objects();
      const GlSnapshot before = contextState();
      ImageU8 luma;
      {
        const auto reader =
            TextureReader::create(caps, kFrame, GlStatePolicy::preserve, ProgramCache());
        ASSERT_TRUE(reader.ok() && (*reader)->check(input).ok());
        ASSERT_TRUE((*reader)->read(input, &luma));
      }
      EXPECT_EQ(differences(before, contextState()), "") << "round " << round;
      EXPECT_EQ(differences(objects, gl_app.objects()), "") << "round " << round;
      EXPECT_EQ(luma.at(0, 0), kGrey) << "the app's state kept the kernels from working";
      EXPECT_EQ(luma.at(kFrame.width - 1, kFrame.height - 1), kGrey);
    }
    gl_app.finish();
  }

  static constexpr std::uint8_t kGrey = 113;
};

TEST_F(GuestTextureTest, PlainTexturesAreReadWithoutATrace) {
  const std::optional<AppTexture> texture = greyTexture(AppTextureKind::rgba8, kFrame);
  expectStateKept(caps(), *texture);
}

TEST_F(GuestTextureTest, ExternalTexturesAreReadWithoutATrace) {
  const std::optional<AppTexture> texture = greyTexture(AppTextureKind::external, kFrame);
  if (!texture || !caps().has_external) GTEST_SKIP() << caps().renderer << ": no such texture";
  GlCaps drawing = caps();
  drawing.has_external_essl3 = false;
  for (const GlCaps& way : {caps(), drawing}) {
    SCOPED_TRACE(way.has_external_essl3 ? "sampled" : "drawn");
    expectStateKept(way, *texture);
  }
}

TEST_F(GuestTextureTest, ASessionThatReadsThemComesAndGoesWithoutNamesLeft) {
  const Config with_textures = config();
  const std::optional<AppTexture> texture =
      greyTexture(AppTextureKind::rgba8, {with_textures.camera.width, with_textures.camera.height});
  const std::vector<int> before = countNames();
  Session session = makeSession(with_textures);
  EXPECT_TRUE(session.update({1, texture->texture(kUpperRowFirst)}).ok());
  EXPECT_NE(countNames(), before);
  session.releaseGl();
  EXPECT_EQ(countNames(), before);
  EXPECT_TRUE(session.update({2, texture->texture(kUpperRowFirst)}).ok());
  session.releaseGl();
  EXPECT_EQ(countNames(), before);
}

TEST_F(GuestTextureTest, ASessionReadsThemInAnotherContextAfterALoss) {
  const Config with_textures = config();
  const FrameSize size{with_textures.camera.width, with_textures.camera.height};
  Session session = makeSession(with_textures);
  {
    const std::optional<AppTexture> texture = greyTexture(AppTextureKind::rgba8, size);
    EXPECT_TRUE(session.update({1, texture->texture(kUpperRowFirst)}).ok());
  }
  destroyApp();
  AppContext other = makeContext(ContextSharing::none);
  {
    const std::optional<AppTexture> texture = greyTexture(AppTextureKind::rgba8, size);
    EXPECT_TRUE(session.update({2, texture->texture(kUpperRowFirst)}).ok());
    session.releaseGl();
  }
  EXPECT_THAT(other.complaints(), ::testing::IsEmpty());
}

}  // namespace
}  // namespace glide::test
