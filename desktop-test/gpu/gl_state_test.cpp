#include "gpu/gl_state.h"

#include "support/app_context.h"
#include "support/gl_app.h"

#include "gpu/gl_draw_state.h"
#include "gpu/gl_test.h"
#include "gpu/shader_source.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <optional>
#include <regex>

namespace glide::test {
namespace {

using ::testing::Contains;
using ::testing::Key;

/// Touches all that a kernel of ours may touch.
void compute() {
  const GlBuffer buffer = GlBuffer::allocate(64, GL_DYNAMIC_DRAW);
  const GlTexture texture = GlTexture::allocate(GL_R32F, 4, 4);
  for (GLuint i = 0; i < GlComputeState::kStorageBindings; ++i)
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, i, buffer.get());
  for (GLuint i = 0; i < GlComputeState::kUniformBindings; ++i)
    glBindBufferBase(GL_UNIFORM_BUFFER, i, buffer.get());
  for (GLuint i = 0; i < GlComputeState::kImageUnits; ++i)
    glBindImageTexture(i, texture.get(), 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_R32F);
  for (GLuint i = 0; i < GlComputeState::kTextureUnits; ++i) {
    glActiveTexture(GL_TEXTURE0 + i);
    glBindTexture(GL_TEXTURE_2D, texture.get());
  }
  glUseProgram(0);
}

void draw() {
  const GlTexture texture = GlTexture::allocate(GL_RGBA8, 4, 4);
  GLuint framebuffer = 0;
  glGenFramebuffers(1, &framebuffer);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture.get(), 0);
  GLuint vertices = 0;
  glGenVertexArrays(1, &vertices);
  glBindVertexArray(vertices);
  glViewport(0, 0, 4, 4);
  glClear(GL_COLOR_BUFFER_BIT);
  glDeleteVertexArrays(1, &vertices);
  glDeleteFramebuffers(1, &framebuffer);
}

/// A pass that computes and draws.
void runAll(GlStatePolicy policy) {
  const ScopedGlState state(policy);
  const ScopedDrawState draw_state(policy);
  compute();
  draw();
}

class ScopedGlStateTest : public GlTest {
 protected:
  void SetUp() override {
    GlTest::SetUp();
    if (IsSkipped() || HasFatalFailure()) return;
    main_.emplace();
    Result<AppContext> context = AppContext::create(ContextSharing::none);
    ASSERT_TRUE(context.ok()) << context.error().message;
    context_.emplace(std::move(*context));
  }
  void TearDown() override {
    if (context_) {
      EXPECT_THAT(context_->complaints(), ::testing::IsEmpty());
      context_.reset();
    }
    main_.reset();
    GlTest::TearDown();
  }

 private:
  std::optional<ScopedCurrentContext> main_;
  std::optional<AppContext> context_;
};

TEST_F(ScopedGlStateTest, PreservesEveryPieceOfState) {
  GlApp app(11);
  for (int round = 0; round < 12; ++round) {
    app.randomise();
    const GlSnapshot objects = app.objects();
    const GlSnapshot before = contextState();
    runAll(GlStatePolicy::preserve);
    EXPECT_EQ(differences(before, contextState()), "") << "round " << round;
    EXPECT_EQ(differences(objects, app.objects()), "") << "round " << round;
  }
  app.finish();
}

TEST_F(ScopedGlStateTest, ResetsWhatIsTouchedAndNothingElse) {
  const GlSnapshot initial = contextState();
  runAll(GlStatePolicy::reset);
  EXPECT_EQ(differences(initial, contextState()), "");
  glEnable(GL_POLYGON_OFFSET_FILL);
  glEnable(GL_BLEND);
  glUseProgram(0);
  runAll(GlStatePolicy::reset);
  EXPECT_TRUE(glIsEnabled(GL_POLYGON_OFFSET_FILL));
  EXPECT_FALSE(glIsEnabled(GL_BLEND));
}

TEST_F(ScopedGlStateTest, LeavesTheKernelsStateWithoutAPolicy) {
  glPixelStorei(GL_UNPACK_ROW_LENGTH, 7);
  GLint length = -1;
  { const ScopedGlState state(GlStatePolicy::none); }
  glGetIntegerv(GL_UNPACK_ROW_LENGTH, &length);
  EXPECT_EQ(length, 0);
}

TEST_F(ScopedGlStateTest, SurvivesAProgramThatTheAppHasDeletedWhileItIsCurrent) {
  const GLchar* text = "#version 310 es\nlayout(local_size_x = 1) in;\nvoid main() {}\n";
  const GLuint program = glCreateShaderProgramv(GL_COMPUTE_SHADER, 1, &text);
  glUseProgram(program);
  glDeleteProgram(program);
  runAll(GlStatePolicy::preserve);
  GLint current = -1;
  glGetIntegerv(GL_CURRENT_PROGRAM, &current);
  EXPECT_EQ(current, 0);
}

TEST_F(ScopedGlStateTest, SnapshotOfTheTestSeesEveryKindOfChange) {
  GlApp app(3);
  const GlSnapshot before = contextState();
  const auto changes = [&before](const std::function<void()>& change) {
    change();
    return differences(before, contextState());
  };
  EXPECT_NE(changes([] { glPixelStorei(GL_PACK_ROW_LENGTH, 7); }), "");
  glPixelStorei(GL_PACK_ROW_LENGTH, 0);
  EXPECT_NE(changes([] { glVertexAttrib4f(3, 1, 2, 3, 4); }), "");
  glVertexAttrib4f(3, 0, 0, 0, 1);
  EXPECT_NE(changes([] { glDepthRangef(0.25F, 1.0F); }), "");
  glDepthRangef(0.0F, 1.0F);
  EXPECT_EQ(differences(before, contextState()), "");
  EXPECT_THAT(before, Contains(Key("texture binding 2d[0]")));
  EXPECT_GT(before.size(), 500U);
}

/// The numbers that `declaration` binds in all shaders, at most.
int highestBinding(const std::string& declaration) {
  // layout(..., binding = N...) ... DECLARATION
  const std::regex pattern(R"(layout\([^)]*binding *= *([0-9]+)[^)]*\)[^;{]*)" + declaration);
  int highest = -1;
  for (const EmbeddedShader& shader : embeddedShaders()) {
    const std::string text(shader.text);
    for (std::sregex_iterator i(text.begin(), text.end(), pattern), end; i != end; ++i)
      highest = std::max(highest, std::stoi((*i)[1]));
  }
  return highest;
}

TEST(GlComputeState, CoversWhatTheShadersBind) {
  const auto count = [](std::size_t units) { return static_cast<int>(units); };
  EXPECT_EQ(highestBinding(R"(\bbuffer\b)"), count(GlComputeState::kStorageBindings) - 1);
  EXPECT_EQ(highestBinding(R"(\buniform +\w+ *\{)"), count(GlComputeState::kUniformBindings) - 1);
  EXPECT_EQ(highestBinding(R"(\w*sampler\w+\b)"), count(GlComputeState::kTextureUnits) - 1);
  EXPECT_EQ(highestBinding(R"(\w*image2D\b)"), count(GlComputeState::kImageUnits) - 1);
}

}  // namespace
}  // namespace glide::test
