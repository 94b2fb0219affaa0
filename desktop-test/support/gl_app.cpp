#include "support/gl_app.h"

#include <gtest/gtest.h>

#include <string>

namespace glide::test {
namespace {

constexpr GLsizei kTextureSize = 8;
constexpr GLsizei kTextureLevels = 3;

constexpr const char* kComputeText = R"(#version 310 es
layout(local_size_x = 1) in;
layout(location = 0) uniform vec4 colour;
layout(std430, binding = 0) buffer Out { vec4 value; };
void main() { value = colour; })";
constexpr const char* kVertexText = R"(#version 310 es
layout(location = 0) in vec4 corner;
layout(location = 0) uniform vec4 offset;
out vec4 moved;
void main() { gl_Position = moved = corner + offset; })";
constexpr const char* kFragmentText = R"(#version 310 es
precision highp float;
layout(location = 0) out vec4 colour;
void main() { colour = vec4(1.0); })";
constexpr const char* kStageText = R"(#version 310 es
layout(location = 0) uniform vec4 offset;
void main() { gl_Position = offset; })";

GLuint compile(GLenum stage, const char* text) {
  const GLuint shader = glCreateShader(stage);
  glShaderSource(shader, 1, &text, nullptr);
  glCompileShader(shader);
  return shader;
}

GLuint link(std::initializer_list<GLuint> shaders, const char* varying) {
  const GLuint program = glCreateProgram();
  for (const GLuint shader : shaders) glAttachShader(program, shader);
  if (varying != nullptr) glTransformFeedbackVaryings(program, 1, &varying, GL_INTERLEAVED_ATTRIBS);
  glLinkProgram(program);
  for (const GLuint shader : shaders) glDeleteShader(shader);
  GLint linked = GL_FALSE;
  glGetProgramiv(program, GL_LINK_STATUS, &linked);
  EXPECT_EQ(linked, GL_TRUE) << "a program of the app does not link";
  return program;
}

void allocate(GLenum target) {
  if (target == GL_TEXTURE_3D || target == GL_TEXTURE_2D_ARRAY) {
    glTexStorage3D(target, kTextureLevels, GL_RGBA8, kTextureSize, kTextureSize, kTextureSize);
  } else if (target == GL_TEXTURE_2D_MULTISAMPLE) {
    glTexStorage2DMultisample(target, 1, GL_RGBA8, kTextureSize, kTextureSize, GL_TRUE);
  } else {
    glTexStorage2D(target, kTextureLevels, GL_RGBA8, kTextureSize, kTextureSize);
  }
}

}  // namespace

GlApp::GlApp(std::uint32_t seed) : random_(seed) {
  makeBuffers();
  makeTextures();
  makeFramebuffers();
  makePrograms();
  glGenSamplers(kSamplers, samplers_.data());
  glGenVertexArrays(kArrays - 1, vertex_arrays_.data() + 1);
  for (const GLuint array : vertex_arrays_) glBindVertexArray(array);  // binding makes them
  glGenQueries(1, &query_);
  glGenTransformFeedbacks(1, &feedback_);
  glBindTransformFeedback(GL_TRANSFORM_FEEDBACK, feedback_);
  glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, feedback_buffer_);
  glBindTransformFeedback(GL_TRANSFORM_FEEDBACK, 0);
}

void GlApp::makeBuffers() {
  std::vector<std::uint32_t> words(static_cast<std::size_t>(kBufferBytes) / sizeof(std::uint32_t));
  glGenBuffers(kBuffers, buffers_.data());
  glGenBuffers(1, &feedback_buffer_);
  for (const GLuint buffer : buffers_) {
    for (std::uint32_t& word : words) word = static_cast<std::uint32_t>(random_());
    glBindBuffer(GL_COPY_WRITE_BUFFER, buffer);
    glBufferData(GL_COPY_WRITE_BUFFER, kBufferBytes, words.data(), GL_DYNAMIC_DRAW);
  }
  EXPECT_NE(glMapBufferRange(GL_COPY_WRITE_BUFFER, 64, 256, GL_MAP_WRITE_BIT), nullptr);
  glBindBuffer(GL_COPY_WRITE_BUFFER, feedback_buffer_);
  glBufferData(GL_COPY_WRITE_BUFFER, kBufferBytes, nullptr, GL_STREAM_COPY);
}

void GlApp::makeTextures() {
  for (const GLenum target : {GL_TEXTURE_2D,
                              GL_TEXTURE_2D,
                              GL_TEXTURE_2D,
                              GL_TEXTURE_3D,
                              GL_TEXTURE_2D_ARRAY,
                              GL_TEXTURE_CUBE_MAP,
                              GL_TEXTURE_2D_MULTISAMPLE}) {
    GLuint name = 0;
    glGenTextures(1, &name);
    glBindTexture(target, name);
    allocate(target);
    textures_.push_back({target, name});
    if (target == GL_TEXTURE_2D_MULTISAMPLE) continue;
    const GLenum filter = pick({GL_NEAREST, GL_LINEAR, GL_LINEAR_MIPMAP_LINEAR});
    glTexParameteri(target, GL_TEXTURE_MIN_FILTER, static_cast<GLint>(filter));
    glTexParameteri(target, GL_TEXTURE_SWIZZLE_R, coin() ? GL_ALPHA : GL_RED);
    glTexParameteri(target, GL_TEXTURE_BASE_LEVEL, static_cast<GLint>(pick(2)));
  }
}

void GlApp::makeFramebuffers() {
  glGenRenderbuffers(2, renderbuffers_.data());
  glGenFramebuffers(2, framebuffers_.data());
  for (std::size_t i = 0; i < framebuffers_.size(); ++i) {
    glBindRenderbuffer(GL_RENDERBUFFER, renderbuffers_[i]);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH24_STENCIL8, kTextureSize, kTextureSize);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffers_[i]);
    glFramebufferTexture2D(
        GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, textures_[i].name, 0);
    glFramebufferRenderbuffer(
        GL_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, GL_RENDERBUFFER, renderbuffers_[i]);
  }
}

void GlApp::makePrograms() {
  compute_ = link({compile(GL_COMPUTE_SHADER, kComputeText)}, nullptr);
  drawing_ =
      link({compile(GL_VERTEX_SHADER, kVertexText), compile(GL_FRAGMENT_SHADER, kFragmentText)},
           "moved");
  vertex_stage_ = glCreateShaderProgramv(GL_VERTEX_SHADER, 1, &kStageText);
  glGenProgramPipelines(1, &pipeline_);
  glBindProgramPipeline(pipeline_);
  glUseProgramStages(pipeline_, GL_VERTEX_SHADER_BIT, vertex_stage_);
  glActiveShaderProgram(pipeline_, vertex_stage_);
  for (const GLuint program : {compute_, drawing_, vertex_stage_})
    glProgramUniform4f(program, 0, unit(), unit(), unit(), unit());
}

bool GlApp::isIntact() const {
  bool intact = glIsBuffer(feedback_buffer_) == GL_TRUE && glIsQuery(query_) == GL_TRUE &&
                glIsTransformFeedback(feedback_) == GL_TRUE &&
                glIsProgramPipeline(pipeline_) == GL_TRUE;
  for (const GLuint name : buffers_) intact = intact && glIsBuffer(name) == GL_TRUE;
  for (const AppTexture& texture : textures_)
    intact = intact && glIsTexture(texture.name) == GL_TRUE;
  for (const GLuint name : samplers_) intact = intact && glIsSampler(name) == GL_TRUE;
  for (const GLuint name : renderbuffers_) intact = intact && glIsRenderbuffer(name) == GL_TRUE;
  for (const GLuint name : framebuffers_) intact = intact && glIsFramebuffer(name) == GL_TRUE;
  for (std::size_t i = 1; i < kArrays; ++i)
    intact = intact && glIsVertexArray(vertex_arrays_[i]) == GL_TRUE;
  for (const GLuint name : {compute_, drawing_, vertex_stage_})
    intact = intact && glIsProgram(name) == GL_TRUE;
  return intact;
}

void GlApp::start() {
  // Once begun, the program, the feedback's buffers and the query stay as they are.
  is_query_running_ = coin();
  if (is_query_running_) glBeginQuery(GL_ANY_SAMPLES_PASSED, query_);
  is_feedback_running_ = coin();
  if (!is_feedback_running_) return;
  glBindTransformFeedback(GL_TRANSFORM_FEEDBACK, feedback_);
  glUseProgram(drawing_);
  glBeginTransformFeedback(GL_POINTS);
  if (coin()) glPauseTransformFeedback();
}

void GlApp::finish() {
  if (is_query_running_) glEndQuery(GL_ANY_SAMPLES_PASSED);
  if (is_feedback_running_) glEndTransformFeedback();
  is_query_running_ = is_feedback_running_ = false;
}

void GlApp::randomise() {
  finish();
  randomiseCapabilities();
  randomiseRaster();
  randomiseFragmentTests();
  randomiseDrawBuffers();
  randomiseTextures();
  randomiseSamplers();
  randomiseVertexArrays();
  randomiseFramebuffers();
  randomisePixelStore();
  randomiseBuffers();
  randomiseProgram();
  start();
}

}  // namespace glide::test
