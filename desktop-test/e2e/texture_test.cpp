#include "e2e/run_matchers.h"
#include "support/app_texture.h"
#include "support/egl_context.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <map>
#include <optional>
#include <string_view>
#include <utility>

namespace glide::test {
namespace {

using ::testing::HasSubstr;

constexpr int kFrames = 30;

bool glRequired() {
  const char* value = std::getenv("GLIDE_REQUIRE_GL");
  return value != nullptr && std::string_view(value) == "1";
}

/// Sessions that get their frames as textures of an app.
class Textures : public ::testing::Test {
 protected:
  void SetUp() override {
    Result<EglContext> context = EglContext::create(EglDebug::off);
    if (!context && glRequired()) FAIL() << "GLIDE_REQUIRE_GL=1, but " << context.error().message;
    if (!context) GTEST_SKIP() << "no GL: " << context.error().message;
    context_.emplace(std::move(*context));
  }

  static Config configOf(Backend backend) {
    Config config = inlineConfig();
    config.backend = backend;
    return config;
  }

  /// The walk handed over as pixels. One run per config is enough for all tests.
  static const Playback& playPixels(const Config& config) {
    static std::map<std::pair<Backend, TrackerMode>, Playback> runs;
    const auto [run, is_new] = runs.try_emplace({config.backend, config.tracker});
    if (is_new) run->second = play(roomWalk(kFrames), config);
    return run->second;
  }

  /// Plays the walk with every image uploaded to one texture of that kind, as an app would.
  static Playback playTextures(AppTextureKind kind, const Config& config) {
    const synthetic::SequenceOptions options = roomWalk(kFrames);
    Result<AppTexture> app = AppTexture::create(kind, options.camera.width, options.camera.height);
    if (!app) return {};
    const auto upload = [&](const ImageU8& image) {
      app->write(image.view());
      return app->texture(kUpperRowFirst);
    };
    return playAs(upload, options, config);
  }

  static void expectSamePoses(const Playback& textures, const Playback& pixels) {
    ASSERT_EQ(textures.results.size(), pixels.results.size());
    for (std::size_t i = 0; i < pixels.results.size(); ++i) {
      const FrameResult& seen = textures.results[i];
      const FrameResult& expected = pixels.results[i];
      EXPECT_EQ(seen.tracker, expected.tracker) << "frame " << i;
      EXPECT_EQ(seen.T_world_cam.t_xyz, expected.T_world_cam.t_xyz) << "frame " << i;
      EXPECT_EQ(seen.T_world_cam.q_xyzw, expected.T_world_cam.q_xyzw) << "frame " << i;
    }
  }

  /// Frames whose pixels were brought to the CPU, over those of one tracker.
  static int readBack(const Playback& run, TrackerKind tracker) {
    int count = 0;
    for (const FrameResult& result : run.results)
      count += result.tracker == tracker && result.stats.readback_ms > 0.0 ? 1 : 0;
    return count;
  }

  static int framesOf(const Playback& run, TrackerKind tracker) {
    int count = 0;
    for (const FrameResult& result : run.results) count += result.tracker == tracker ? 1 : 0;
    return count;
  }

  std::optional<EglContext> context_;
};

TEST_F(Textures, GiveThePosesOfPixelsAndAreReadBackForTheIndirectTrackerOnly) {
  const Config config = configOf(Backend::gles);
  const Playback& pixels = playPixels(config);
  ASSERT_THAT(pixels, IsTrackedToTheEnd());
  const Playback textures = playTextures(AppTextureKind::r8, config);
  expectSamePoses(textures, pixels);
  EXPECT_GT(framesOf(textures, TrackerKind::direct), kFrames / 3);
  EXPECT_EQ(readBack(textures, TrackerKind::direct), 0);
  EXPECT_EQ(readBack(textures, TrackerKind::indirect), framesOf(textures, TrackerKind::indirect));
  EXPECT_EQ(readBack(pixels, TrackerKind::indirect), 0);
}

TEST_F(Textures, OfACameraGiveThePosesOfPixels) {
  const Config config = configOf(Backend::gles);
  const Playback textures = playTextures(AppTextureKind::external, config);
  if (textures.results.empty()) GTEST_SKIP() << "EGL makes no image of a texture here";
  expectSamePoses(textures, playPixels(config));
}

TEST_F(Textures, AreReadForTheCpuBackendAndTheIndirectTracker) {
  Config config = configOf(Backend::cpu);
  expectSamePoses(playTextures(AppTextureKind::rgba8, config), playPixels(config));
  config.tracker = TrackerMode::indirect;
  expectSamePoses(playTextures(AppTextureKind::r8, config), playPixels(config));
}

TEST_F(Textures, MayTakeTurnsWithPixels) {
  const Config config = configOf(Backend::gles);
  const synthetic::SequenceOptions options = roomWalk(kFrames);
  Result<AppTexture> app =
      AppTexture::create(AppTextureKind::r8, options.camera.width, options.camera.height);
  int frame = 0;
  const MakeInput take_turns = [&](const ImageU8& image) -> decltype(FrameInput::image) {
    app->write(image.view());
    if (++frame % 2 == 0) return app->texture(kUpperRowFirst);
    return Luma{image.row(0), image.width(), image.height(), image.stride()};
  };
  expectSamePoses(playAs(take_turns, options, config), playPixels(config));
}

TEST_F(Textures, AreRefusedByNameAndTheSessionGoesOn) {
  Config config = configOf(Backend::gles);
  config.camera = roomWalk(1).camera;
  Result<Session> session = Session::create(config);
  ASSERT_TRUE(session.ok());
  Result<AppTexture> app =
      AppTexture::create(AppTextureKind::r8, config.camera.width, config.camera.height);
  const Texture good = app->texture(kUpperRowFirst);
  Texture wrong = good;
  wrong.name = 777;
  EXPECT_THAT(session->update({1, wrong}).error().message, HasSubstr("the image's name 777"));
  EXPECT_EQ(session->update({1, HardwareBuffer{}}).error().code, ErrorCode::invalid_argument);
  EXPECT_TRUE(session->update({1, good}).ok());
}

TEST_F(Textures, NeedAContext) {
  Config config = configOf(Backend::cpu);
  config.camera = roomWalk(1).camera;
  Result<Session> session = Session::create(config);
  ASSERT_TRUE(session.ok());
  context_.reset();
  const Texture texture{1, GL_TEXTURE_2D, config.camera.width, config.camera.height};
  const Result<FrameResult> result = session->update({1, texture});
  ASSERT_FALSE(result.ok());
  EXPECT_EQ(result.error().code, ErrorCode::missing_context);
  EXPECT_THAT(result.error().message, HasSubstr("the image is a texture"));
}

}  // namespace
}  // namespace glide::test
