// What a frame costs that comes as a texture (752x480): the conversion into level 0 that takes the
// place of the upload, and bringing its pixels to the CPU. Argument: 0 R8, 1 RGBA8, 2 external
// sampled by the kernel, 3 external drawn first. Skips where there is no GL.
#include "support/app_texture.h"
#include "support/egl_context.h"

#include "gpu/gl_caps.h"
#include "gpu/luma_upload.h"
#include "gpu/texture_reader.h"
#include "gpu/texture_upload.h"

#include <benchmark/benchmark.h>

#include <memory>
#include <optional>

namespace glide {
namespace {

constexpr FrameSize kFrame{752, 480};  // of EuRoC
constexpr int kGroupSize = 64;
constexpr std::int64_t kDrawn = 3;

/// A context with a texture in it; without one the benchmark is skipped.
class TextureSetup {
 public:
  explicit TextureSetup(benchmark::State* bench)
      : context_(test::EglContext::create(test::EglDebug::off)) {
    const Result<GlCaps> caps = GlCaps::query();
    if (!caps) {
      bench->SkipWithError(caps.error().message.c_str());
      return;
    }
    bench->SetLabel(caps->renderer);
    caps_ = *caps;
    if (bench->range(0) == kDrawn) caps_.has_external_essl3 = false;
    const test::AppTextureKind kinds[] = {test::AppTextureKind::r8,
                                          test::AppTextureKind::rgba8,
                                          test::AppTextureKind::external,
                                          test::AppTextureKind::external};
    Result<test::AppTexture> texture =
        test::AppTexture::create(kinds[bench->range(0)], kFrame.width, kFrame.height);
    if (!texture) {
      bench->SkipWithError(texture.error().message.c_str());
      return;
    }
    texture_ = std::move(*texture);
    ImageU8 image(kFrame.width, kFrame.height);
    texture_->write(image.view());
  }

  bool isReady() const { return texture_.has_value(); }
  Texture texture() const { return texture_->texture(kUpperRowFirst); }
  const GlCaps& caps() const { return caps_; }

 private:
  Result<test::EglContext> context_;
  GlCaps caps_;
  std::optional<test::AppTexture> texture_;
};

void BM_TextureToLevel0(benchmark::State& state) {
  const TextureSetup setup(&state);
  if (!setup.isReady()) return;
  const GlTexture level0 = GlTexture::allocate(GL_R32F, kFrame.width, kFrame.height);
  TextureUpload upload(setup.caps(), kFrame, kGroupSize, ProgramCache());
  GpuCommands commands;
  for (auto _ : state) {
    const ScopedGlState gl_state(GlStatePolicy::preserve);
    benchmark::DoNotOptimize(
        upload.run(setup.texture(), level0, GlStatePolicy::preserve, commands).ok());
    glFinish();
  }
}
BENCHMARK(BM_TextureToLevel0)->DenseRange(0, kDrawn)->Unit(benchmark::kMillisecond);

void BM_TextureToCpu(benchmark::State& state) {
  const TextureSetup setup(&state);
  if (!setup.isReady()) return;
  const std::unique_ptr<TextureReader> reader =
      TextureReader::create(setup.caps(), kFrame, GlStatePolicy::preserve, ProgramCache()).value();
  ImageU8 luma;
  if (!reader->check(setup.texture())) return state.SkipWithError("the texture is refused");
  for (auto _ : state) benchmark::DoNotOptimize(reader->read(setup.texture(), &luma));
}
BENCHMARK(BM_TextureToCpu)->DenseRange(0, kDrawn)->Unit(benchmark::kMillisecond);

/// The yardstick: the same frame as pixels.
void BM_PixelsToLevel0(benchmark::State& state) {
  const Result<test::EglContext> context = test::EglContext::create(test::EglDebug::off);
  if (!context) return state.SkipWithError(context.error().message.c_str());
  const GlTexture level0 = GlTexture::allocate(GL_R32F, kFrame.width, kFrame.height);
  const LumaUpload upload =
      LumaUpload::create(kFrame.width, kFrame.height, kGroupSize, ProgramCache()).value();
  const ImageU8 image(kFrame.width, kFrame.height);
  GpuCommands commands;
  for (auto _ : state) {
    const ScopedGlState gl_state(GlStatePolicy::preserve);
    upload.run(image.view(), level0, commands);
    glFinish();
  }
}
BENCHMARK(BM_PixelsToLevel0)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace glide
