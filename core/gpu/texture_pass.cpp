#include "gpu/texture_pass.h"

#include "gpu/gl_sampler.h"
#include "gpu/luma_weights.h"
#include "gpu/texture_check.h"

#include <utility>

namespace glide {
namespace {

// layout(location) of shaders/texture_source.glsl
constexpr GLint kOrigin = 0, kPerColumn = 1, kPerRow = 2, kWeights = 3;

/// Which of the colours of the texture that is bound to GL_TEXTURE_2D of unit 0 make the luma.
const std::array<float, 3>& boundWeights() {
  return isBoundTextureGrey() ? kGreyWeights : kColourWeights;
}

void setUniforms(const TexturePlacement& place, const std::array<float, 3>& weights) {
  glUniform2fv(kOrigin, 1, place.origin.data());
  glUniform2fv(kPerColumn, 1, place.per_column.data());
  glUniform2fv(kPerRow, 1, place.per_row.data());
  glUniform3fv(kWeights, 1, weights.data());
}

bool isSame(const Texture& a, const Texture& b) {
  return a.name == b.name && a.target == b.target && a.width == b.width && a.height == b.height;
}

}  // namespace

TexturePass::TexturePass(TextureKernel kernel, const GlCaps& caps, FrameSize frame)
    : kernel_(std::move(kernel)),
      samples_external_(caps.has_external_essl3),
      draws_external_(caps.has_external),
      frame_(frame) {}

bool TexturePass::isPrepared(const Texture& texture) const {
  return isSame(texture, prepared_) && glIsTexture(texture.name) == GL_TRUE;
}

Status TexturePass::prepare(const Texture& texture, GlStatePolicy policy) {
  prepared_ = Texture();
  const bool external = texture.target == GL_TEXTURE_EXTERNAL_OES;
  if (external && !samples_external_ && !draws_external_)
    return Error{ErrorCode::unsupported,
                 "the image: this OpenGL ES has neither GL_OES_EGL_image_external_essl3 nor "
                 "GL_OES_EGL_image_external"};
  Status checked = checkTextureObject(texture, policy);
  if (checked) checked = prepareSamplers();
  if (checked) checked = prepareProgram(texture.target);
  if (checked) prepared_ = texture;
  return checked;
}

Status TexturePass::prepareSamplers() {
  if (nearest_.get() != 0) return Unit{};
  nearest_ = makeClampedSampler(GL_NEAREST);
  linear_ = makeClampedSampler(GL_LINEAR);
  if (nearest_.get() == 0 || linear_.get() == 0) return outOfMemory("a sampler object");
  return Unit{};
}

Status TexturePass::prepareProgram(GLenum target) {
  const bool external = target == GL_TEXTURE_EXTERNAL_OES;
  const bool is_sampled = external && samples_external_;
  if (external && !is_sampled && !draw_) {
    Result<ExternalDraw> draw = ExternalDraw::create(frame_);
    if (!draw) return draw.error();
    draw_ = std::move(*draw);
  }
  std::optional<ComputeProgram>& program = is_sampled ? external_ : plain_;
  if (program) return Unit{};
  const ShaderDefines defines{{"EXTERNAL_TEXTURE", is_sampled ? 1 : 0},
                              {"GROUP_ROWS", kernel_.group_size / kGroupWidth}};
  Result<ComputeProgram> built = ComputeProgram::create(kernel_.shader, defines, kernel_.programs);
  if (!built && is_sampled && draws_external_) {
    samples_external_ = false;  // the driver has the extension in name only
    return prepareProgram(target);
  }
  if (!built) return built.error();
  program = std::move(*built);
  return Unit{};
}

void TexturePass::bind(const Texture& texture,
                       GlStatePolicy policy,
                       TextureBinding* binding) const {
  glActiveTexture(GL_TEXTURE0);
  if (texture.target != GL_TEXTURE_EXTERNAL_OES) {
    bindPlain(texture);
  } else if (samples_external_) {
    bindExternal(texture, policy, binding);
  } else {
    bindDrawn(texture, policy);
  }
}

void TexturePass::bindPlain(const Texture& texture) const {
  const TexturePlacement place = placeTexture(texture, frame_);
  glBindTexture(GL_TEXTURE_2D, texture.name);
  glBindSampler(0, place.hits_texels ? nearest_.get() : linear_.get());
  plain_->use();
  setUniforms(place, boundWeights());
}

void TexturePass::bindExternal(const Texture& texture,
                               GlStatePolicy policy,
                               TextureBinding* binding) const {
  const TexturePlacement place = placeTexture(texture, frame_);
  binding->external.emplace(policy, GL_TEXTURE_EXTERNAL_OES, GL_TEXTURE_BINDING_EXTERNAL_OES);
  glBindTexture(GL_TEXTURE_EXTERNAL_OES, texture.name);
  glBindSampler(0, place.hits_texels ? nearest_.get() : linear_.get());
  external_->use();
  setUniforms(place, kColourWeights);
}

void TexturePass::bindDrawn(const Texture& texture, GlStatePolicy policy) const {
  const TexturePlacement place = placeTexture(texture, frame_);
  glBindSampler(0, place.hits_texels ? nearest_.get() : linear_.get());
  draw_->run(texture.name, place, policy);
  const Texture drawn{
      draw_->target().get(), GL_TEXTURE_2D, frame_.width, frame_.height, kUpperRowFirst};
  bindPlain(drawn);
}

void TexturePass::abandon() {
  if (plain_) plain_->abandon();
  if (external_) external_->abandon();
  if (draw_) draw_->abandon();
  abandonAll(nearest_, linear_);
}

}  // namespace glide
