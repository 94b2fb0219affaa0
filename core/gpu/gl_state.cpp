#include "gpu/gl_state.h"

namespace glide {
namespace {

GLuint nameOf(GLint value) { return static_cast<GLuint>(value); }

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

template <class Buffer>
Buffer saveIndexed(const IndexedTarget& target, GLuint index) {
  Buffer saved;
  glGetIntegeri_v(target.binding, index, &saved.name);
  glGetInteger64i_v(target.start, index, &saved.start);
  glGetInteger64i_v(target.size, index, &saved.size);
  return saved;
}

template <class Buffer>
void restoreIndexed(const IndexedTarget& target, GLuint index, const Buffer& saved) {
  if (saved.name == 0 || saved.size == 0) {  // size 0: the whole buffer, by glBindBufferBase
    glBindBufferBase(target.target, index, nameOf(saved.name));
    return;
  }
  glBindBufferRange(target.target,
                    index,
                    nameOf(saved.name),
                    static_cast<GLintptr>(saved.start),
                    static_cast<GLsizeiptr>(saved.size));
}

}  // namespace

ScopedGlState::ScopedGlState() {
  glGetIntegerv(GL_CURRENT_PROGRAM, &program_);
  saveTextures();
  saveBuffers();
}

ScopedGlState::~ScopedGlState() {
  restoreBuffers();
  restoreTextures();
  glUseProgram(nameOf(program_));
}

void ScopedGlState::saveTextures() {
  glGetIntegerv(GL_ACTIVE_TEXTURE, &active_texture_);
  glActiveTexture(GL_TEXTURE0);
  glGetIntegerv(GL_TEXTURE_BINDING_2D, &texture_);
  glGetIntegerv(GL_SAMPLER_BINDING, &sampler_);
  glGetIntegeri_v(GL_IMAGE_BINDING_NAME, 0, &image_.name);
  glGetIntegeri_v(GL_IMAGE_BINDING_LEVEL, 0, &image_.level);
  glGetIntegeri_v(GL_IMAGE_BINDING_LAYERED, 0, &image_.layered);
  glGetIntegeri_v(GL_IMAGE_BINDING_LAYER, 0, &image_.layer);
  glGetIntegeri_v(GL_IMAGE_BINDING_ACCESS, 0, &image_.access);
  glGetIntegeri_v(GL_IMAGE_BINDING_FORMAT, 0, &image_.format);
  // A sampler that filters linearly would make our r32f textures incomplete.
  glBindSampler(0, 0);
}

void ScopedGlState::saveBuffers() {
  glGetIntegerv(GL_PIXEL_UNPACK_BUFFER_BINDING, &unpack_.buffer);
  glGetIntegerv(GL_UNPACK_ALIGNMENT, &unpack_.alignment);
  glGetIntegerv(GL_UNPACK_ROW_LENGTH, &unpack_.row_length);
  glGetIntegerv(GL_UNPACK_SKIP_ROWS, &unpack_.skip_rows);
  glGetIntegerv(GL_UNPACK_SKIP_PIXELS, &unpack_.skip_pixels);
  glBindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glPixelStorei(GL_UNPACK_ROW_LENGTH, 0);
  glPixelStorei(GL_UNPACK_SKIP_ROWS, 0);
  glPixelStorei(GL_UNPACK_SKIP_PIXELS, 0);
  for (int i = 0; i < kStorageBindings; ++i) {
    storage_bindings_[static_cast<std::size_t>(i)] =
        saveIndexed<IndexedBuffer>(kStorage, static_cast<GLuint>(i));
  }
  uniform_binding_ = saveIndexed<IndexedBuffer>(kUniform, 0);
  glGetIntegerv(GL_SHADER_STORAGE_BUFFER_BINDING, &storage_);
  glGetIntegerv(GL_UNIFORM_BUFFER_BINDING, &uniform_);
}

void ScopedGlState::restoreTextures() const {
  glBindImageTexture(0,
                     nameOf(image_.name),
                     image_.level,
                     image_.layered != 0 ? GL_TRUE : GL_FALSE,
                     image_.layer,
                     nameOf(image_.access),
                     nameOf(image_.format));
  glBindSampler(0, nameOf(sampler_));
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, nameOf(texture_));
  glActiveTexture(nameOf(active_texture_));
}

void ScopedGlState::restoreBuffers() const {
  glBindBuffer(GL_PIXEL_UNPACK_BUFFER, nameOf(unpack_.buffer));
  glPixelStorei(GL_UNPACK_ALIGNMENT, unpack_.alignment);
  glPixelStorei(GL_UNPACK_ROW_LENGTH, unpack_.row_length);
  glPixelStorei(GL_UNPACK_SKIP_ROWS, unpack_.skip_rows);
  glPixelStorei(GL_UNPACK_SKIP_PIXELS, unpack_.skip_pixels);
  for (int i = 0; i < kStorageBindings; ++i) {
    restoreIndexed(
        kStorage, static_cast<GLuint>(i), storage_bindings_[static_cast<std::size_t>(i)]);
  }
  restoreIndexed(kUniform, 0, uniform_binding_);
  // The indexed calls above have changed the generic bindings.
  glBindBuffer(GL_SHADER_STORAGE_BUFFER, nameOf(storage_));
  glBindBuffer(GL_UNIFORM_BUFFER, nameOf(uniform_));
}

}  // namespace glide
