#pragma once

#include "support/gl_snapshot.h"

// The 3.2 header names what an ES 3.2 context has more; the functions are called only there.
#include <GLES3/gl32.h>

#include <array>
#include <cstdint>
#include <initializer_list>
#include <random>
#include <vector>

namespace glide::test {

/// The app around the library: GL objects of every kind, and random but valid values of every piece
/// of state that contextState() reads. Made for a context of its own (AppContext), which is current
/// in all calls and takes the objects along when it goes.
class GlApp {
 public:
  explicit GlApp(std::uint32_t seed);
  GlApp(const GlApp&) = delete;
  GlApp& operator=(const GlApp&) = delete;

  /// Every piece of state; ends the round before. Three rounds in four leave something running: an
  /// occlusion query, a transform feedback, or both.
  void randomise();
  /// Ends what is running: after the last round.
  void finish();

  /// What the objects hold: parameters of textures, samplers, buffers and renderbuffers,
  /// attachments of framebuffers, attributes of vertex arrays, stages of the pipeline, uniforms,
  /// contents of the buffers, and that every name exists.
  GlSnapshot objects() const;
  /// Whether every name exists still.
  bool isIntact() const;

 private:
  static constexpr std::size_t kBuffers = 6;
  static constexpr std::size_t kSamplers = 3;
  static constexpr std::size_t kArrays = 3;  ///< vertex arrays; the first is 0
  static constexpr GLsizeiptr kBufferBytes = 4096;

  /// A texture and its target.
  struct AppTexture {
    GLenum target;
    GLuint name;
  };

  void makeBuffers();
  void makeTextures();
  void makeFramebuffers();
  void makePrograms();

  void randomiseCapabilities();
  void randomiseRaster();
  void randomiseFragmentTests();
  void randomiseStencil(GLenum face);
  void randomiseDrawBuffers();
  void randomiseTextures();
  void randomiseTextureUnit(GLuint unit);
  void randomiseSamplers();
  void randomiseBuffers();
  void randomiseIndexed(GLenum target, GLenum count_query);
  void randomisePixelStore();
  void randomiseVertexArrays();
  void randomiseAttributes(GLuint vertex_array);
  void randomiseFramebuffers();
  void randomiseProgram();
  void start();

  bool coin() { return (random_() & 1U) != 0; }
  GLuint pick(GLuint count) { return static_cast<GLuint>(random_() % count); }
  GLenum pick(std::initializer_list<GLenum> values) {
    return values.begin()[pick(static_cast<GLuint>(values.size()))];
  }
  GLfloat unit() { return static_cast<GLfloat>(pick(1001)) / 1000.0F; }
  GLuint anyBuffer() { return coin() ? buffers_[pick(kBuffers)] : 0; }
  GLuint textureOf(GLenum target);

  std::mt19937 random_;
  std::array<GLuint, kBuffers> buffers_{};  ///< the last one stays mapped
  GLuint feedback_buffer_ = 0;              ///< only for the transform feedback
  std::vector<AppTexture> textures_;
  std::array<GLuint, kSamplers> samplers_{};
  std::array<GLuint, 2> renderbuffers_{}, framebuffers_{};
  std::array<GLuint, kArrays> vertex_arrays_{};
  GLuint compute_ = 0, drawing_ = 0;  ///< programs
  GLuint vertex_stage_ = 0, pipeline_ = 0;
  GLuint feedback_ = 0, query_ = 0;
  bool is_feedback_running_ = false, is_query_running_ = false;
};

}  // namespace glide::test
