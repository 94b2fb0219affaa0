#include "support/gl_app.h"
#include "support/gl_state_tables.h"

#include <algorithm>

namespace glide::test {
namespace {

GLuint limit(GLenum query) {
  GLint value = 0;
  glGetIntegerv(query, &value);
  return static_cast<GLuint>(value);
}

GLboolean toGl(bool value) { return value ? GL_TRUE : GL_FALSE; }

}  // namespace

void GlApp::randomiseCapabilities() {
  for (const StateQuery& capability : kCapabilities) {
    if (coin()) {
      glEnable(capability.query);
    } else {
      glDisable(capability.query);
    }
  }
  glHint(GL_GENERATE_MIPMAP_HINT, pick({GL_FASTEST, GL_NICEST, GL_DONT_CARE}));
  glHint(GL_FRAGMENT_SHADER_DERIVATIVE_HINT, pick({GL_FASTEST, GL_NICEST, GL_DONT_CARE}));
}

void GlApp::randomiseRaster() {
  const auto number = [this] { return static_cast<GLint>(pick(300)); };
  glViewport(number(), number(), number(), number());
  glScissor(number(), number(), number(), number());
  glDepthRangef(unit(), unit());
  glCullFace(pick({GL_FRONT, GL_BACK, GL_FRONT_AND_BACK}));
  glFrontFace(pick({GL_CW, GL_CCW}));
  glPolygonOffset(unit(), unit());
  glSampleCoverage(unit(), toGl(coin()));
  glSampleMaski(0, static_cast<GLbitfield>(random_()));
  glClearColor(unit(), unit(), unit(), unit());
  glClearDepthf(unit());
  glClearStencil(static_cast<GLint>(pick(256)));
}

void GlApp::randomiseStencil(GLenum face) {
  const auto operation = [this] {
    return pick({GL_KEEP, GL_ZERO, GL_REPLACE, GL_INCR, GL_DECR_WRAP, GL_INVERT});
  };
  glStencilFuncSeparate(
      face, pick({GL_LESS, GL_ALWAYS, GL_EQUAL}), static_cast<GLint>(pick(256)), pick(256));
  glStencilOpSeparate(face, operation(), operation(), operation());
  glStencilMaskSeparate(face, pick(256));
}

void GlApp::randomiseFragmentTests() {
  randomiseStencil(GL_FRONT);
  randomiseStencil(GL_BACK);
  glDepthFunc(pick({GL_NEVER, GL_LESS, GL_GREATER, GL_ALWAYS}));
  glDepthMask(toGl(coin()));
  glColorMask(toGl(coin()), toGl(coin()), toGl(coin()), toGl(coin()));
  const auto factor = [this] { return pick({GL_ZERO, GL_ONE, GL_SRC_ALPHA, GL_DST_COLOR}); };
  glBlendFuncSeparate(factor(), factor(), factor(), factor());
  if (hasGlExtension("GL_KHR_blend_equation_advanced") && coin()) {
    glBlendEquation(pick({GL_MULTIPLY_KHR, GL_SCREEN_KHR, GL_HSL_COLOR_KHR}));
  } else {
    glBlendEquationSeparate(pick({GL_FUNC_ADD, GL_MIN}), pick({GL_FUNC_SUBTRACT, GL_MAX}));
  }
  glBlendColor(unit(), unit(), unit(), unit());
}

void GlApp::randomiseDrawBuffers() {
  if (!isEs(3, 2)) return;
  for (GLuint i = 0; i < limit(GL_MAX_DRAW_BUFFERS); ++i) {
    if (coin()) {
      glEnablei(GL_BLEND, i);
    } else {
      glDisablei(GL_BLEND, i);
    }
    glColorMaski(i, toGl(coin()), toGl(coin()), toGl(coin()), toGl(coin()));
    glBlendFunci(i, pick({GL_ZERO, GL_ONE}), pick({GL_SRC_ALPHA, GL_DST_ALPHA}));
  }
  glMinSampleShading(unit());
  glPatchParameteri(GL_PATCH_VERTICES, static_cast<GLint>(1 + pick(8)));
}

GLuint GlApp::textureOf(GLenum target) {
  std::vector<GLuint> names{0};
  for (const AppTexture& texture : textures_) {
    if (texture.target == target) names.push_back(texture.name);
  }
  return names[pick(static_cast<GLuint>(names.size()))];
}

void GlApp::randomiseTextureUnit(GLuint unit) {
  glActiveTexture(GL_TEXTURE0 + unit);
  for (const GLenum target : {GL_TEXTURE_2D,
                              GL_TEXTURE_3D,
                              GL_TEXTURE_2D_ARRAY,
                              GL_TEXTURE_CUBE_MAP,
                              GL_TEXTURE_2D_MULTISAMPLE}) {
    glBindTexture(target, textureOf(target));
  }
  glBindSampler(unit, coin() ? samplers_[pick(kSamplers)] : 0);
}

void GlApp::randomiseTextures() {
  const GLuint units = limit(GL_MAX_COMBINED_TEXTURE_IMAGE_UNITS);
  for (GLuint unit = 0; unit < units; ++unit) randomiseTextureUnit(unit);
  glActiveTexture(GL_TEXTURE0 + pick(units));
  for (GLuint unit = 0; unit < limit(GL_MAX_IMAGE_UNITS); ++unit) {
    const bool is_array = coin();
    glBindImageTexture(unit,
                       textureOf(is_array ? GL_TEXTURE_2D_ARRAY : GL_TEXTURE_2D),
                       static_cast<GLint>(pick(3)),
                       toGl(is_array && coin()),
                       is_array ? static_cast<GLint>(pick(4)) : 0,
                       pick({GL_READ_ONLY, GL_WRITE_ONLY}),
                       pick({GL_RGBA8, GL_R32UI, GL_R32F}));
  }
}

void GlApp::randomiseSamplers() {
  for (const GLuint sampler : samplers_) {
    glSamplerParameteri(sampler,
                        GL_TEXTURE_MIN_FILTER,
                        static_cast<GLint>(pick({GL_LINEAR_MIPMAP_LINEAR, GL_NEAREST})));
    glSamplerParameteri(sampler, GL_TEXTURE_WRAP_S, coin() ? GL_REPEAT : GL_MIRRORED_REPEAT);
    glSamplerParameterf(sampler, GL_TEXTURE_MIN_LOD, -unit());
  }
}

void GlApp::randomisePixelStore() {
  for (const GLenum name : {GL_UNPACK_ROW_LENGTH,
                            GL_UNPACK_SKIP_ROWS,
                            GL_UNPACK_SKIP_PIXELS,
                            GL_UNPACK_IMAGE_HEIGHT,
                            GL_UNPACK_SKIP_IMAGES,
                            GL_PACK_ROW_LENGTH,
                            GL_PACK_SKIP_ROWS,
                            GL_PACK_SKIP_PIXELS}) {
    glPixelStorei(name, static_cast<GLint>(pick(2000)));
  }
  for (const GLenum name : {GL_UNPACK_ALIGNMENT, GL_PACK_ALIGNMENT})
    glPixelStorei(name, 1 << pick(4));
}

void GlApp::randomiseIndexed(GLenum target, GLenum count_query) {
  constexpr GLintptr kStep = 256;  // aligned for every driver
  const GLuint count = limit(count_query);
  for (GLuint index = 0; index < count; ++index) {
    const GLuint buffer = anyBuffer();
    if (buffer == 0 || coin()) {
      glBindBufferBase(target, index, buffer);
    } else {
      glBindBufferRange(target, index, buffer, kStep * static_cast<GLintptr>(pick(4)), 2 * kStep);
    }
  }
}

void GlApp::randomiseBuffers() {
  glBindTransformFeedback(GL_TRANSFORM_FEEDBACK, 0);
  randomiseIndexed(GL_SHADER_STORAGE_BUFFER, GL_MAX_SHADER_STORAGE_BUFFER_BINDINGS);
  randomiseIndexed(GL_UNIFORM_BUFFER, GL_MAX_UNIFORM_BUFFER_BINDINGS);
  randomiseIndexed(GL_ATOMIC_COUNTER_BUFFER, GL_MAX_ATOMIC_COUNTER_BUFFER_BINDINGS);
  randomiseIndexed(GL_TRANSFORM_FEEDBACK_BUFFER, GL_MAX_TRANSFORM_FEEDBACK_SEPARATE_ATTRIBS);
  for (const GLenum target : {GL_SHADER_STORAGE_BUFFER,
                              GL_UNIFORM_BUFFER,
                              GL_ATOMIC_COUNTER_BUFFER,
                              GL_PIXEL_PACK_BUFFER,
                              GL_PIXEL_UNPACK_BUFFER,
                              GL_ARRAY_BUFFER,
                              GL_COPY_READ_BUFFER,
                              GL_COPY_WRITE_BUFFER,
                              GL_DISPATCH_INDIRECT_BUFFER,
                              GL_DRAW_INDIRECT_BUFFER}) {
    glBindBuffer(target, anyBuffer());
  }
}

void GlApp::randomiseAttributes(GLuint vertex_array) {
  static constexpr std::array<GLfloat, 4> kClientMemory{};
  glBindVertexArray(vertex_array);
  const GLuint count = std::min(limit(GL_MAX_VERTEX_ATTRIBS), limit(GL_MAX_VERTEX_ATTRIB_BINDINGS));
  for (GLuint i = 0; i < count; ++i) {
    const GLuint buffer = vertex_array == 0 ? 0 : buffers_[pick(kBuffers)];
    glBindBuffer(GL_ARRAY_BUFFER, buffer);
    const void* pointer = buffer == 0 ? kClientMemory.data() : nullptr;
    glVertexAttribPointer(i, static_cast<GLint>(1 + pick(4)), GL_FLOAT, toGl(coin()), 16, pointer);
    glVertexAttribDivisor(i, pick(3));
    glVertexAttrib4f(i, unit(), unit(), unit(), unit());
    if (buffer != 0) glVertexAttribBinding(i, pick(count));
    if (coin()) {
      glEnableVertexAttribArray(i);
    } else {
      glDisableVertexAttribArray(i);
    }
  }
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, anyBuffer());
}

void GlApp::randomiseVertexArrays() {
  for (const GLuint array : vertex_arrays_) randomiseAttributes(array);
  glBindVertexArray(vertex_arrays_[pick(kArrays)]);
}

void GlApp::randomiseFramebuffers() {
  const auto any = [this] { return coin() ? framebuffers_[pick(2)] : 0; };
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, any());
  glBindFramebuffer(GL_READ_FRAMEBUFFER, any());
  glBindRenderbuffer(GL_RENDERBUFFER, coin() ? renderbuffers_[pick(2)] : 0);
}

void GlApp::randomiseProgram() {
  glUseProgram(pick({0, compute_, drawing_}));
  glBindProgramPipeline(coin() ? pipeline_ : 0);
}

}  // namespace glide::test
