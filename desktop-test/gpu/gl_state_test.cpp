#include "gpu/gl_state.h"

#include "gpu/align_fixture.h"
#include "gpu/gl_test.h"
#include "gpu/gpu_aligner.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <initializer_list>
#include <map>
#include <random>
#include <string>

namespace glide::test {
namespace {

/// Every piece of GL state that a compute pass could plausibly touch, by name.
using Snapshot = std::map<std::string, std::int64_t>;

void addInteger(Snapshot* out, const std::string& name, GLenum query) {
  GLint64 value = 0;
  glGetInteger64v(query, &value);
  (*out)[name] = value;
}

void addTextureUnits(Snapshot* out) {
  constexpr int kUnits = 4;
  GLint active = 0;
  glGetIntegerv(GL_ACTIVE_TEXTURE, &active);
  for (int unit = 0; unit < kUnits; ++unit) {
    glActiveTexture(static_cast<GLenum>(GL_TEXTURE0 + unit));
    const std::string suffix = " of unit " + std::to_string(unit);
    addInteger(out, "2D texture" + suffix, GL_TEXTURE_BINDING_2D);
    addInteger(out, "cube map" + suffix, GL_TEXTURE_BINDING_CUBE_MAP);
    addInteger(out, "3D texture" + suffix, GL_TEXTURE_BINDING_3D);
    addInteger(out, "sampler" + suffix, GL_SAMPLER_BINDING);
  }
  glActiveTexture(static_cast<GLenum>(active));
}

void addIndexed(Snapshot* out) {
  constexpr GLenum kQueries[] = {GL_SHADER_STORAGE_BUFFER_BINDING,
                                 GL_SHADER_STORAGE_BUFFER_START,
                                 GL_SHADER_STORAGE_BUFFER_SIZE,
                                 GL_UNIFORM_BUFFER_BINDING,
                                 GL_UNIFORM_BUFFER_START,
                                 GL_UNIFORM_BUFFER_SIZE,
                                 GL_ATOMIC_COUNTER_BUFFER_BINDING,
                                 GL_IMAGE_BINDING_NAME,
                                 GL_IMAGE_BINDING_LEVEL,
                                 GL_IMAGE_BINDING_LAYERED,
                                 GL_IMAGE_BINDING_LAYER,
                                 GL_IMAGE_BINDING_ACCESS,
                                 GL_IMAGE_BINDING_FORMAT};
  for (GLuint index = 0; index < 4; ++index) {
    for (const GLenum query : kQueries) {
      if (query == GL_ATOMIC_COUNTER_BUFFER_BINDING && index > 0) continue;  // ES 3.1 has one
      GLint64 value = 0;
      glGetInteger64i_v(query, index, &value);
      (*out)["query " + std::to_string(query) + " index " + std::to_string(index)] = value;
    }
  }
}

constexpr GLenum kPlainQueries[] = {GL_CURRENT_PROGRAM,
                                    GL_ACTIVE_TEXTURE,
                                    GL_PIXEL_UNPACK_BUFFER_BINDING,
                                    GL_PIXEL_PACK_BUFFER_BINDING,
                                    GL_UNPACK_ALIGNMENT,
                                    GL_UNPACK_ROW_LENGTH,
                                    GL_UNPACK_SKIP_ROWS,
                                    GL_UNPACK_SKIP_PIXELS,
                                    GL_UNPACK_IMAGE_HEIGHT,
                                    GL_UNPACK_SKIP_IMAGES,
                                    GL_PACK_ALIGNMENT,
                                    GL_PACK_ROW_LENGTH,
                                    GL_ARRAY_BUFFER_BINDING,
                                    GL_COPY_READ_BUFFER_BINDING,
                                    GL_COPY_WRITE_BUFFER_BINDING,
                                    GL_SHADER_STORAGE_BUFFER_BINDING,
                                    GL_UNIFORM_BUFFER_BINDING,
                                    GL_DISPATCH_INDIRECT_BUFFER_BINDING,
                                    GL_DRAW_INDIRECT_BUFFER_BINDING,
                                    GL_ATOMIC_COUNTER_BUFFER_BINDING,
                                    GL_TRANSFORM_FEEDBACK_BUFFER_BINDING,
                                    GL_VERTEX_ARRAY_BINDING,
                                    GL_DRAW_FRAMEBUFFER_BINDING,
                                    GL_READ_FRAMEBUFFER_BINDING,
                                    GL_RENDERBUFFER_BINDING,
                                    GL_PROGRAM_PIPELINE_BINDING,
                                    GL_TRANSFORM_FEEDBACK_BINDING,
                                    GL_BLEND,
                                    GL_DEPTH_TEST,
                                    GL_CULL_FACE,
                                    GL_SCISSOR_TEST,
                                    GL_STENCIL_TEST,
                                    GL_DITHER,
                                    GL_RASTERIZER_DISCARD};

Snapshot takeSnapshot() {
  Snapshot out;
  for (const GLenum query : kPlainQueries)
    addInteger(&out, "query " + std::to_string(query), query);
  addTextureUnits(&out);
  addIndexed(&out);
  return out;
}

/// Objects of an app, and random bindings of them.
class AppState {
 public:
  explicit AppState(std::uint32_t seed) : random_(seed) {
    for (int i = 0; i < kCount; ++i) {
      buffers_.push_back(GlBuffer::allocate(kBufferBytes, GL_STATIC_DRAW));
      textures_.push_back(GlTexture::allocate(GL_RGBA8, 8, 8));
    }
    glGenSamplers(kCount, samplers_);
    for (GLuint sampler : samplers_)
      glSamplerParameteri(sampler, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    Result<ComputeProgram> program = ComputeProgram::compile(
        "app", "#version 310 es\nlayout(local_size_x = 1) in;\nvoid main() {}\n");
    if (program) apps_.push_back(std::move(*program));
  }
  ~AppState() {
    reset();
    glDeleteSamplers(kCount, samplers_);
  }
  AppState(const AppState&) = delete;
  AppState& operator=(const AppState&) = delete;

  void randomise() {
    for (GLuint unit = 0; unit < 4; ++unit) {
      glActiveTexture(GL_TEXTURE0 + unit);
      glBindTexture(GL_TEXTURE_2D, anyTexture());
      glBindSampler(unit, coin() ? samplers_[pick(kCount)] : 0);
      glBindImageTexture(
          unit, anyTexture(), 0, GL_FALSE, 0, coin() ? GL_READ_ONLY : GL_READ_WRITE, GL_RGBA8);
      bindIndexed(GL_SHADER_STORAGE_BUFFER, unit);
      bindIndexed(GL_UNIFORM_BUFFER, unit);
    }
    glActiveTexture(GL_TEXTURE0 + pick(8));
    for (const GLenum target : std::initializer_list<GLenum>{GL_SHADER_STORAGE_BUFFER,
                                                             GL_UNIFORM_BUFFER,
                                                             GL_PIXEL_UNPACK_BUFFER,
                                                             GL_ARRAY_BUFFER,
                                                             GL_COPY_READ_BUFFER,
                                                             GL_COPY_WRITE_BUFFER,
                                                             GL_DISPATCH_INDIRECT_BUFFER}) {
      glBindBuffer(target, anyBuffer());
    }
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1 << pick(4));
    glPixelStorei(GL_UNPACK_ROW_LENGTH, static_cast<GLint>(pick(3000)));
    glPixelStorei(GL_UNPACK_SKIP_ROWS, static_cast<GLint>(pick(50)));
    glPixelStorei(GL_UNPACK_SKIP_PIXELS, static_cast<GLint>(pick(50)));
    glPixelStorei(GL_UNPACK_SKIP_IMAGES, static_cast<GLint>(pick(5)));
    glUseProgram(coin() && !apps_.empty() ? apps_.front().get() : 0);
  }

 private:
  static constexpr int kCount = 3;
  static constexpr std::int64_t kBufferBytes = 4096;
  static constexpr GLintptr kOffset = 256;  // aligned for every driver

  /// Back to defaults for the tests that follow.
  void reset() {
    for (GLuint unit = 0; unit < 4; ++unit) {
      glActiveTexture(GL_TEXTURE0 + unit);
      glBindTexture(GL_TEXTURE_2D, 0);
      glBindSampler(unit, 0);
      glBindImageTexture(unit, 0, 0, GL_FALSE, 0, GL_READ_ONLY, GL_R32UI);
      glBindBufferBase(GL_SHADER_STORAGE_BUFFER, unit, 0);
      glBindBufferBase(GL_UNIFORM_BUFFER, unit, 0);
    }
    glActiveTexture(GL_TEXTURE0);
    for (const GLenum target : std::initializer_list<GLenum>{GL_PIXEL_UNPACK_BUFFER,
                                                             GL_ARRAY_BUFFER,
                                                             GL_COPY_READ_BUFFER,
                                                             GL_COPY_WRITE_BUFFER,
                                                             GL_DISPATCH_INDIRECT_BUFFER}) {
      glBindBuffer(target, 0);
    }
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    for (const GLenum name : std::initializer_list<GLenum>{GL_UNPACK_ROW_LENGTH,
                                                           GL_UNPACK_SKIP_ROWS,
                                                           GL_UNPACK_SKIP_PIXELS,
                                                           GL_UNPACK_SKIP_IMAGES}) {
      glPixelStorei(name, 0);
    }
    glUseProgram(0);
  }

  bool coin() { return (random_() & 1U) != 0; }
  GLuint pick(GLuint count) { return static_cast<GLuint>(random_() % count); }
  GLuint anyBuffer() { return coin() ? buffers_[pick(kCount)].get() : 0; }
  GLuint anyTexture() { return coin() ? textures_[pick(kCount)].get() : 0; }
  void bindIndexed(GLenum target, GLuint index) {
    const GLuint buffer = buffers_[pick(kCount)].get();
    switch (pick(3)) {
      case 0:
        glBindBufferBase(target, index, 0);
        break;
      case 1:
        glBindBufferBase(target, index, buffer);
        break;
      default:
        glBindBufferRange(target, index, buffer, kOffset * static_cast<GLintptr>(pick(4)), 512);
    }
  }

  std::mt19937 random_;
  std::vector<GlBuffer> buffers_;
  std::vector<GlTexture> textures_;
  GLuint samplers_[kCount] = {};
  std::vector<ComputeProgram> apps_;
};

class ScopedGlStateTest : public GlTest {};

TEST_F(ScopedGlStateTest, RestoresRandomisedStateAfterAWholeFrame) {
  const AlignScene scene = makeAlignScene({DistortionModel::none, 160, 120, 40, smallMotion(), {}});
  Config::Direct direct;
  direct.levels = 3;
  direct.patch_size = 7;
  AppState app(11);
  for (int round = 0; round < 8; ++round) {
    app.randomise();
    const Snapshot before = takeSnapshot();
    {
      Result<std::unique_ptr<Aligner>> aligner = GpuAligner::create(caps(), direct, scene.camera);
      ASSERT_TRUE(aligner.ok()) << aligner.error().message;
      (*aligner)->loadFrame(scene.reference.view());
      (*aligner)->promoteReference(scene.points_ref);
      (*aligner)->loadFrame(scene.frame.view());
      EXPECT_TRUE(
          (*aligner)->align(SE3d{}).valid);  // the app's sampler and unpack state do no harm
    }
    EXPECT_EQ(takeSnapshot(), before) << "round " << round;
  }
}

TEST_F(ScopedGlStateTest, SnapshotOfTheTestSeesAChange) {
  const Snapshot before = takeSnapshot();
  glPixelStorei(GL_UNPACK_ROW_LENGTH, 7);
  EXPECT_NE(takeSnapshot(), before);
  glPixelStorei(GL_UNPACK_ROW_LENGTH, 0);
  EXPECT_EQ(takeSnapshot(), before);
}

}  // namespace
}  // namespace glide::test
