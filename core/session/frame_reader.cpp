#include "session/frame_reader.h"

#include "base/stopwatch.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <variant>

#if defined(GLIDE_GLES)
#include "gpu/device_cache.h"
#include "gpu/gl_caps.h"
#include "gpu/program_cache.h"
#include "gpu/texture_placement.h"
#include "gpu/texture_reader.h"
#endif

namespace glide {
namespace {

Error invalid(const std::string& what) { return {ErrorCode::invalid_argument, what}; }

std::string sizeText(int width, int height) {
  return std::to_string(width) + "x" + std::to_string(height);
}

}  // namespace

FrameReader::FrameReader(const Config& config, Backend backend)
    : width_(config.camera.width),
      height_(config.camera.height),
      backend_(backend),
      options_(config.gl) {}

FrameReader::~FrameReader() = default;

Status FrameReader::checkLuma(const Luma& luma) const {
  if (luma.pixels == nullptr) return invalid("the image's pixels are null");
  if (luma.width != width_ || luma.height != height_)
    return invalid("the image is " + sizeText(luma.width, luma.height) +
                   ", but the camera of the config is " + sizeText(width_, height_));
  if (luma.stride < luma.width)
    return invalid("the image's row stride, " + std::to_string(luma.stride) +
                   ", is smaller than its width, " + std::to_string(luma.width));
  if (luma.stride > std::numeric_limits<int>::max())  // GL_UNPACK_ROW_LENGTH is an int
    return invalid("the image's row stride is larger than an int");
  return Unit{};
}

Status FrameReader::check(const Input& input) const {
  if (const auto* luma = std::get_if<Luma>(&input)) return checkLuma(*luma);
  if (const auto* texture = std::get_if<Texture>(&input)) return checkTexture(*texture);
  const auto& buffer = *std::get_if<HardwareBuffer>(&input);
  if (buffer.buffer == nullptr) return invalid("the image's hardware buffer is null");
  return Unit{};
}

Status FrameReader::take(const Input& input) {
  readback_ms_ = 0.0;
  is_read_ = false;
  Status valid = check(input);
  if (!valid) return valid;
  if (const auto* texture = std::get_if<Texture>(&input)) return takeTexture(*texture);
  if (const auto* buffer = std::get_if<HardwareBuffer>(&input)) return takeBuffer(*buffer);
  const Luma& luma = *std::get_if<Luma>(&input);
  image_ = ImageViewU8{luma.pixels, luma.width, luma.height, luma.stride};
  return Unit{};
}

FrameImage FrameReader::image() {
  if (backend_ == Backend::cpu) return luma();
  return image_;
}

ImageViewU8 FrameReader::luma() {
  const auto* texture = std::get_if<Texture>(&image_);
  if (texture == nullptr) return *std::get_if<ImageViewU8>(&image_);
  if (!is_read_) {
    Stopwatch watch;
    read(*texture);
    is_read_ = true;
    readback_ms_ = watch.lapMs();
  }
  return bytes_.view();
}

#if defined(GLIDE_GLES)
struct FrameReader::Gl {
  std::unique_ptr<TextureReader> reader;
};

Status FrameReader::checkTexture(const Texture& texture) const {
  return checkPlacement(texture, {width_, height_});
}

Status FrameReader::ensureGl() {
  if (gl_ && gl_->reader->isUsable()) return Unit{};
  gl_.reset();
  const Result<GlCaps> caps = GlCaps::query();
  if (!caps) return Error{caps.error().code, "the image is a texture: " + caps.error().message};
  const ProgramCache programs(DeviceCache(options_.cache_dir, *caps), *caps);
  auto reader = TextureReader::create(*caps, {width_, height_}, options_.state, programs);
  if (!reader) return reader.error();
  gl_ = std::make_unique<Gl>(Gl{std::move(*reader)});
  return Unit{};
}

Status FrameReader::takeTexture(const Texture& texture) {
  Status ready = ensureGl();
  if (ready) ready = gl_->reader->check(texture);
  if (ready) image_ = texture;
  return ready;
}

Status FrameReader::takeBuffer(const HardwareBuffer& buffer) {
  const Status ready = ensureGl();
  if (!ready) return ready;
  const Result<Texture> texture = gl_->reader->import(buffer);
  return texture ? takeTexture(*texture) : Status(texture.error());
}

void FrameReader::read(const Texture& texture) {
  if (gl_->reader->read(texture, &bytes_)) return;
  for (int y = 0; y < height_; ++y) std::fill_n(bytes_.row(y), width_, std::uint8_t{0});
}

void FrameReader::releaseGl() { gl_.reset(); }

void FrameReader::abandonGl() {
  if (gl_) gl_->reader->abandon();
  gl_.reset();
}
#else
struct FrameReader::Gl {};

namespace {
Error noGles() {
  return {ErrorCode::unsupported,
          "the image is a texture: this build has no OpenGL ES (GLIDE_GLES=OFF), and reads none"};
}
}  // namespace

Status FrameReader::checkTexture(const Texture&) const { return noGles(); }
Status FrameReader::ensureGl() { return noGles(); }
Status FrameReader::takeTexture(const Texture&) { return noGles(); }
Status FrameReader::takeBuffer(const HardwareBuffer&) { return noGles(); }
void FrameReader::read(const Texture&) {}
void FrameReader::releaseGl() {}
void FrameReader::abandonGl() {}
#endif

}  // namespace glide
