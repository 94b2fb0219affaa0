#include "gpu/texture_reader.h"

#include <cstdint>
#include <utility>

namespace glide {
namespace {

constexpr int kGroupSize = 64;     // one size for all devices: this pass is rare and short
constexpr int kPixelsPerWord = 4;  // of the kernel
constexpr GLint kWords = 4;        // layout(location) of its own uniform

/// Bytes of the rows that the kernel writes: laid out as those of `luma`.
std::int64_t bytesOf(const ImageU8& luma) {
  return static_cast<std::int64_t>(luma.stride()) * luma.height();
}

}  // namespace

Result<std::unique_ptr<TextureReader>> TextureReader::create(const GlCaps& caps,
                                                             FrameSize frame,
                                                             GlStatePolicy policy,
                                                             const ProgramCache& programs) {
  Result<GlHome> home = GlHome::create();
  if (!home) return home.error();
  const ScopedGlState state(policy);
  const ImageU8 layout(frame.width, frame.height);
  GlBuffer bytes = GlBuffer::allocate(bytesOf(layout), GL_DYNAMIC_READ);
  if (!bytes.isComplete()) return outOfMemory("reading textures back");
  home->publish();
  TexturePass pass({"texture_to_bytes.comp", kGroupSize, programs}, caps, frame);
  return std::unique_ptr<TextureReader>(
      new TextureReader(std::move(*home), std::move(pass), std::move(bytes), policy));
}

TextureReader::TextureReader(GlHome home, TexturePass pass, GlBuffer bytes, GlStatePolicy policy)
    : home_(std::move(home)), pass_(std::move(pass)), bytes_(std::move(bytes)), policy_(policy) {}

TextureReader::~TextureReader() {
  if (!home_.isHere()) abandon();
}

void TextureReader::abandon() { abandonAll(pass_, bytes_, buffer_texture_, home_); }

Result<Texture> TextureReader::import(const HardwareBuffer& buffer) {
  const GlVisit visit(&home_, policy_);
  return buffer_texture_.import(buffer, policy_);
}

Status TextureReader::check(const Texture& texture) {
  Status placed = checkPlacement(texture, pass_.frame());
  if (!placed || pass_.isPrepared(texture)) return placed;
  const GlVisit visit(&home_, policy_);
  return pass_.prepare(texture, policy_);
}

void TextureReader::submit(const Texture& texture, int words_per_row) {
  const int rows = pass_.frame().height;
  TextureBinding binding;
  pass_.bind(texture, policy_, &binding);
  glUniform2i(kWords, words_per_row, rows);
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, bytes_.get());
  commands_.dispatch(groupCount(words_per_row, kGroupWidth),
                     groupCount(rows, kGroupSize / kGroupWidth));
  commands_.barrier(GL_BUFFER_UPDATE_BARRIER_BIT);  // read() maps it
}

bool TextureReader::read(const Texture& texture, ImageU8* luma) {
  luma->resize(pass_.frame().width, pass_.frame().height);
  const GlVisit visit(&home_, policy_);
  submit(texture, static_cast<int>(luma->stride()) / kPixelsPerWord);
  return GlSync::insert().wait(kGpuTimeoutNs) && bytes_.read(luma->row(0), bytesOf(*luma));
}

}  // namespace glide
