#include "gpu/gl_state.h"

#include "gpu/gl_query.h"

namespace glide {
namespace {

using TextureUnit = GlComputeState::TextureUnit;
using ImageUnit = GlComputeState::ImageUnit;
using IndexedBuffer = GlComputeState::IndexedBuffer;
using PixelUnpack = GlComputeState::PixelUnpack;

/// The three queries of one indexed buffer target.
struct IndexedTarget {
  GLenum target, binding, start, size;
};
constexpr IndexedTarget kStorage{GL_SHADER_STORAGE_BUFFER,
                                 GL_SHADER_STORAGE_BUFFER_BINDING,
                                 GL_SHADER_STORAGE_BUFFER_START,
                                 GL_SHADER_STORAGE_BUFFER_SIZE};
constexpr IndexedTarget kUniform{
    GL_UNIFORM_BUFFER, GL_UNIFORM_BUFFER_BINDING, GL_UNIFORM_BUFFER_START, GL_UNIFORM_BUFFER_SIZE};

template <class Buffers>
void saveIndexed(const IndexedTarget& target, Buffers* buffers) {
  GLuint index = 0;
  for (IndexedBuffer& buffer : *buffers) {
    buffer.name = glInteger(target.binding, index);
    if (buffer.name != 0) {
      glGetInteger64i_v(target.start, index, &buffer.start);
      glGetInteger64i_v(target.size, index, &buffer.size);
    }
    ++index;
  }
}

template <class Buffers>
void applyIndexed(const IndexedTarget& target, const Buffers& buffers) {
  GLuint index = 0;
  for (const IndexedBuffer& buffer : buffers) {
    if (buffer.size == 0) {  // none, or the whole buffer by glBindBufferBase
      glBindBufferBase(target.target, index, nameOf(buffer.name));
    } else {
      glBindBufferRange(target.target,
                        index,
                        nameOf(buffer.name),
                        static_cast<GLintptr>(buffer.start),
                        static_cast<GLsizeiptr>(buffer.size));
    }
    ++index;
  }
}

ImageUnit currentImage(GLuint unit) {
  return {glInteger(GL_IMAGE_BINDING_NAME, unit),
          glInteger(GL_IMAGE_BINDING_LEVEL, unit),
          glInteger(GL_IMAGE_BINDING_LAYERED, unit),
          glInteger(GL_IMAGE_BINDING_LAYER, unit),
          glInteger(GL_IMAGE_BINDING_ACCESS, unit),
          glInteger(GL_IMAGE_BINDING_FORMAT, unit)};
}

void applyImage(GLuint unit, const ImageUnit& image) {
  // Another context may have deleted the texture since the app bound it.
  const bool exists = image.name != 0 && glIsTexture(nameOf(image.name)) == GL_TRUE;
  glBindImageTexture(unit,
                     exists ? nameOf(image.name) : 0,
                     image.level,
                     image.layered != 0 ? GL_TRUE : GL_FALSE,
                     image.layer,
                     nameOf(image.access),
                     nameOf(image.format));
}

void saveTextures(GlComputeState* state) {
  state->active_texture = glInteger(GL_ACTIVE_TEXTURE);
  GLuint unit = 0;
  for (TextureUnit& texture : state->textures) {
    glActiveTexture(GL_TEXTURE0 + unit++);
    texture = {glInteger(GL_TEXTURE_BINDING_2D), glInteger(GL_SAMPLER_BINDING)};
  }
  glActiveTexture(nameOf(state->active_texture));
  unit = 0;
  for (ImageUnit& image : state->images) image = currentImage(unit++);
}

void applyTextures(const GlComputeState& state) {
  GLuint unit = 0;
  for (const TextureUnit& texture : state.textures) {
    glActiveTexture(GL_TEXTURE0 + unit);
    glBindTexture(GL_TEXTURE_2D, nameOf(texture.texture_2d));
    const bool exists = texture.sampler != 0 && glIsSampler(nameOf(texture.sampler)) == GL_TRUE;
    glBindSampler(unit, exists ? nameOf(texture.sampler) : 0);
    ++unit;
  }
  glActiveTexture(nameOf(state.active_texture));
  unit = 0;
  for (const ImageUnit& image : state.images) applyImage(unit++, image);
}

PixelUnpack currentUnpack() {
  return {glInteger(GL_PIXEL_UNPACK_BUFFER_BINDING),
          glInteger(GL_UNPACK_ALIGNMENT),
          glInteger(GL_UNPACK_ROW_LENGTH),
          glInteger(GL_UNPACK_SKIP_ROWS),
          glInteger(GL_UNPACK_SKIP_PIXELS)};
}

void applyUnpack(const PixelUnpack& unpack) {
  glBindBuffer(GL_PIXEL_UNPACK_BUFFER, nameOf(unpack.buffer));
  glPixelStorei(GL_UNPACK_ALIGNMENT, unpack.alignment);
  glPixelStorei(GL_UNPACK_ROW_LENGTH, unpack.row_length);
  glPixelStorei(GL_UNPACK_SKIP_ROWS, unpack.skip_rows);
  glPixelStorei(GL_UNPACK_SKIP_PIXELS, unpack.skip_pixels);
}

bool isFeedbackRunning() {
  return glInteger(GL_TRANSFORM_FEEDBACK_ACTIVE) == GL_TRUE &&
         glInteger(GL_TRANSFORM_FEEDBACK_PAUSED) == GL_FALSE;
}

}  // namespace

GlComputeState GlComputeState::current() {
  GlComputeState state;
  state.program = glInteger(GL_CURRENT_PROGRAM);
  saveTextures(&state);
  state.unpack = currentUnpack();
  state.storage_buffer = glInteger(GL_SHADER_STORAGE_BUFFER_BINDING);
  state.uniform_buffer = glInteger(GL_UNIFORM_BUFFER_BINDING);
  saveIndexed(kStorage, &state.storage);
  saveIndexed(kUniform, &state.uniform);
  state.is_feedback_running = isFeedbackRunning();
  return state;
}

void GlComputeState::apply() const {
  applyTextures(*this);
  applyUnpack(unpack);
  applyIndexed(kStorage, storage);
  applyIndexed(kUniform, uniform);
  // After the indexed calls, which change these, too.
  glBindBuffer(GL_SHADER_STORAGE_BUFFER, nameOf(storage_buffer));
  glBindBuffer(GL_UNIFORM_BUFFER, nameOf(uniform_buffer));
  // A program that the app had deleted while it was current went when ours took its place.
  const bool exists = program != 0 && glIsProgram(nameOf(program)) == GL_TRUE;
  glUseProgram(exists ? nameOf(program) : 0);
  if (is_feedback_running) glResumeTransformFeedback();  // wants its program to be current
}

void GlComputeState::neutralize() {
  if (isFeedbackRunning()) glPauseTransformFeedback();
  for (GLuint unit = 0; unit < kTextureUnits; ++unit) glBindSampler(unit, 0);
  applyUnpack({0, 1, 0, 0, 0});
}

ScopedTextureBinding::ScopedTextureBinding(GlStatePolicy policy, GLenum target, GLenum binding)
    : policy_(policy), target_(target) {
  glActiveTexture(GL_TEXTURE0);
  if (policy == GlStatePolicy::preserve) texture_ = glInteger(binding);
}

ScopedTextureBinding::~ScopedTextureBinding() {
  if (policy_ == GlStatePolicy::none) return;
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(target_, nameOf(texture_));
}

}  // namespace glide
