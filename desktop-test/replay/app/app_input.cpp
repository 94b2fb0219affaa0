#include "replay/app/app_input.h"

#include <utility>

#if defined(GLIDE_GLES)
#include "support/app_texture.h"
#endif

namespace glide::replay {

#if defined(GLIDE_GLES)
struct AppInput::Uploaded {
  test::AppTexture texture;
};

Result<FrameInput> AppInput::make(std::int64_t t_ns, const ImageU8& image) {
  if (kind_ == InputKind::luma)
    return FrameInput{t_ns, Luma{image.row(0), image.width(), image.height(), image.stride()}};
  if (!texture_) {
    const auto kind =
        kind_ == InputKind::external ? test::AppTextureKind::external : test::AppTextureKind::rgba8;
    Result<test::AppTexture> made = test::AppTexture::create(kind, image.width(), image.height());
    if (!made) return Error{made.error().code, "--input: " + made.error().message};
    texture_ = std::make_unique<Uploaded>(Uploaded{std::move(*made)});
  }
  texture_->texture.write(image.view());
  return FrameInput{t_ns, texture_->texture.texture(kUpperRowFirst)};
}
#else
struct AppInput::Uploaded {};

Result<FrameInput> AppInput::make(std::int64_t t_ns, const ImageU8& image) {
  if (kind_ == InputKind::luma)
    return FrameInput{t_ns, Luma{image.row(0), image.width(), image.height(), image.stride()}};
  return Error{ErrorCode::unsupported, "--input: built without OpenGL ES (GLIDE_GLES)"};
}
#endif

AppInput::AppInput(InputKind kind) : kind_(kind) {}
AppInput::AppInput(AppInput&&) noexcept = default;
AppInput& AppInput::operator=(AppInput&&) noexcept = default;
AppInput::~AppInput() = default;

}  // namespace glide::replay
