#include "gpu/external_draw.h"

#include "gpu/gl_draw_state.h"
#include "gpu/gl_state.h"
#include "gpu/luma_weights.h"
#include "gpu/program_build.h"
#include "gpu/shader_source.h"

#include <utility>

namespace glide {
namespace {

constexpr GLuint kCorner = 0;  // the vertex attribute
// One triangle that covers the target: no diagonal along which fragments are made twice.
constexpr std::array<float, 6> kCorners{-1.0F, -1.0F, 3.0F, -1.0F, -1.0F, 3.0F};

Result<GlShader> buildStage(GLenum stage, std::string_view name) {
  const Result<std::string> text = assembleShader(embeddedShaders(), name, {});
  if (!text) return text.error();
  return compileShader(stage, name, *text);
}

Result<GlProgram> buildProgram() {
  const Result<GlShader> vertex = buildStage(GL_VERTEX_SHADER, "external_to_grey.vert");
  if (!vertex) return vertex.error();
  const Result<GlShader> fragment = buildStage(GL_FRAGMENT_SHADER, "external_to_grey.frag");
  if (!fragment) return fragment.error();
  GlProgram program(glCreateProgram());
  glAttachShader(program.get(), vertex->get());
  glAttachShader(program.get(), fragment->get());
  glBindAttribLocation(program.get(), kCorner, "corner");
  const Status linked = linkProgram("external_to_grey", program);
  if (!linked) return linked.error();
  return program;
}

/// A vertex array that feeds `corners` to the attribute, bound.
GlName<deleteVertexArray> bindVertices(const GlBuffer& corners) {
  GLuint name = 0;
  glGenVertexArrays(1, &name);
  glBindVertexArray(name);
  glEnableVertexAttribArray(kCorner);
  glVertexAttribFormat(kCorner, 2, GL_FLOAT, GL_FALSE, 0);
  glVertexAttribBinding(kCorner, 0);
  glBindVertexBuffer(0, corners.get(), 0, 2 * sizeof(float));
  return GlName<deleteVertexArray>(name);
}

/// A framebuffer with `target` as its only attachment, bound for drawing.
GlName<deleteFramebuffer> bindFramebuffer(const GlTexture& target) {
  GLuint name = 0;
  glGenFramebuffers(1, &name);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, name);
  glFramebufferTexture2D(GL_DRAW_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, target.get(), 0);
  glViewport(0, 0, target.width(), target.height());
  return GlName<deleteFramebuffer>(name);
}

}  // namespace

Result<ExternalDraw> ExternalDraw::create(FrameSize frame) {
  Result<GlProgram> program = buildProgram();
  if (!program) return program.error();
  GlBuffer corners = GlBuffer::allocate(sizeof(kCorners), GL_STATIC_DRAW);
  GlTexture target = GlTexture::allocate(GL_R8, frame.width, frame.height);
  if (!corners.isComplete() || !target.isComplete())
    return outOfMemory("drawing external textures");
  corners.write(kCorners.data(), sizeof(kCorners));
  return ExternalDraw(std::move(*program), std::move(corners), std::move(target));
}

ExternalDraw::ExternalDraw(GlProgram program, GlBuffer corners, GlTexture target)
    : program_(std::move(program)), corners_(std::move(corners)), target_(std::move(target)) {
  std::size_t i = 0;
  for (const char* name : {"origin", "per_column", "per_row", "weights"})
    uniforms_[i++] = glGetUniformLocation(program_.get(), name);
}

void ExternalDraw::useProgram(const TexturePlacement& place) const {
  glUseProgram(program_.get());
  glUniform2fv(uniforms_[0], 1, place.origin.data());
  glUniform2fv(uniforms_[1], 1, place.per_column.data());
  glUniform2fv(uniforms_[2], 1, place.per_row.data());
  glUniform3fv(uniforms_[3], 1, kColourWeights.data());
}

void ExternalDraw::run(GLuint texture, const TexturePlacement& place, GlStatePolicy policy) const {
  const ScopedDrawState draw_state(policy);
  const ScopedTextureBinding binding(
      policy, GL_TEXTURE_EXTERNAL_OES, GL_TEXTURE_BINDING_EXTERNAL_OES);
  const GlName<deleteVertexArray> vertices = bindVertices(corners_);
  const GlName<deleteFramebuffer> framebuffer = bindFramebuffer(target_);
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_EXTERNAL_OES, texture);
  useProgram(place);
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

}  // namespace glide
