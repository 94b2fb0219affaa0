#include "glide/render_target.h"

#include "support/gl_app.h"
#include "support/gl_snapshot.h"

#include "render/contract_fixture.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace glide::test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr Color kOrange{1.0F, 0.502F, 0.0F, 1.0F};
constexpr int kColumns = 30, kRows = 20;  // three bytes times the width is no multiple of four

RenderTarget makeTarget() {
  Result<RenderTarget> made = RenderTarget::create(kColumns, kRows);
  EXPECT_TRUE(made.ok()) << made.error().message;
  return std::move(*made);
}

std::vector<std::uint8_t> pixelAt(const std::vector<std::uint8_t>& rgb, int x, int y) {
  const auto at = rgb.begin() + 3 * (y * kColumns + x);
  return {at, at + 3};
}

using RenderTargetTest = ContractTest;

TEST_F(RenderTargetTest, IsClearedToTheColour) {
  RenderTarget target = makeTarget();
  EXPECT_EQ(target.width(), kColumns);
  EXPECT_EQ(target.height(), kRows);
  target.begin(kOrange);
  const std::vector<std::uint8_t> rgb = target.readRgb();
  ASSERT_EQ(rgb.size(), static_cast<std::size_t>(3 * kColumns * kRows));
  for (int y = 0; y < kRows; ++y) {
    for (int x = 0; x < kColumns; ++x) EXPECT_THAT(pixelAt(rgb, x, y), ElementsAre(255, 128, 0));
  }
}

TEST_F(RenderTargetTest, GivesTheUppermostRowFirst) {
  RenderTarget target = makeTarget();
  target.begin(kOrange);
  glEnable(GL_SCISSOR_TEST);
  glScissor(0, kRows - 1, 1, 1);
  glClearColor(0.0F, 0.0F, 1.0F, 1.0F);
  glClear(GL_COLOR_BUFFER_BIT);
  const std::vector<std::uint8_t> rgb = target.readRgb();
  EXPECT_THAT(pixelAt(rgb, 0, 0), ElementsAre(0, 0, 255));
  EXPECT_THAT(pixelAt(rgb, 1, 0), ElementsAre(255, 128, 0));
  EXPECT_THAT(pixelAt(rgb, 0, 1), ElementsAre(255, 128, 0));
}

TEST_F(RenderTargetTest, HasADepthBufferThatBeginClears) {
  RenderTarget target = makeTarget();
  target.begin(kOrange);
  GLint bits = 0;
  glGetIntegerv(GL_DEPTH_BITS, &bits);
  EXPECT_GE(bits, 16);
}

TEST_F(RenderTargetTest, BeginBindsItForDrawingAndChangesNoMore) {
  RenderTarget target = makeTarget();
  GlApp gl_app(31);
  for (int round = 0; round < 8; ++round) {
    gl_app.randomise();
    const GlSnapshot objects = gl_app.objects();
    GlSnapshot before = contextState();
    GLint framebuffer = 0;
    glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &framebuffer);
    target.begin(kOrange);
    EXPECT_THAT(pixelAt(target.readRgb(), 5, 5), ElementsAre(255, 128, 0)) << "round " << round;
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, static_cast<GLuint>(framebuffer));
    EXPECT_EQ(differences(before, contextState()), "") << "round " << round;
    EXPECT_EQ(differences(objects, gl_app.objects()), "") << "round " << round;
  }
  gl_app.finish();
}

TEST_F(RenderTargetTest, ComesReadsAndGoesWithoutATrace) {
  GlApp gl_app(32);
  gl_app.randomise();
  const GlSnapshot before = contextState();
  {
    RenderTarget target = makeTarget();
    EXPECT_EQ(differences(before, contextState()), "") << "create";
    target.readRgb();
    EXPECT_EQ(differences(before, contextState()), "") << "readRgb";
  }
  EXPECT_EQ(differences(before, contextState()), "") << "destruction";
  gl_app.finish();
}

TEST_F(RenderTargetTest, LeavesNoNamesBehind) {
  const auto names = [] {
    int count = 0;
    for (GLuint name = 1; name < 64; ++name) {
      count += glIsFramebuffer(name) == GL_TRUE ? 1 : 0;
      count += glIsRenderbuffer(name) == GL_TRUE ? 1 : 0;
      count += glIsSampler(name) == GL_TRUE ? 1 : 0;
    }
    return count;
  };
  const int before = names();
  {
    RenderTarget target = makeTarget();
    target.begin(kOrange);
    EXPECT_GT(names(), before);
  }
  EXPECT_EQ(names(), before);
}

TEST_F(RenderTargetTest, RefusesSizesThatTheContextDoesNotHave) {
  for (const int side : {0, -3, 1 << 24}) {
    const Result<RenderTarget> made = RenderTarget::create(side, kRows);
    ASSERT_FALSE(made.ok());
    EXPECT_EQ(made.error().code, ErrorCode::invalid_argument);
    EXPECT_THAT(made.error().message, HasSubstr(std::to_string(side) + "x20"));
  }
}

TEST_F(RenderTargetTest, NeedsAContext) {
  makeNoContextCurrent();
  const Result<RenderTarget> made = RenderTarget::create(kColumns, kRows);
  ASSERT_FALSE(made.ok());
  EXPECT_EQ(made.error().code, ErrorCode::missing_context);
  app().makeCurrent();
}

TEST_F(RenderTargetTest, IsMadeAnewInAnotherContext) {
  for (const ContextSharing sharing : {ContextSharing::none, ContextSharing::current}) {
    app().makeCurrent();
    RenderTarget target = makeTarget();
    target.begin(kOrange);
    {
      const AppContext other = makeContext(sharing);
      EXPECT_THAT(target.readRgb(), IsEmpty()) << "nothing was drawn here";
      target.begin({0.0F, 1.0F, 0.0F, 1.0F});
      EXPECT_THAT(pixelAt(target.readRgb(), 3, 3), ElementsAre(0, 255, 0));
      EXPECT_THAT(other.complaints(), IsEmpty());
      target.abandonGl();
      EXPECT_THAT(target.readRgb(), IsEmpty());
    }
  }
  app().makeCurrent();
}

TEST_F(RenderTargetTest, SurvivesCallsWithoutAContext) {
  RenderTarget target = makeTarget();
  target.begin(kOrange);
  makeNoContextCurrent();
  const Status begun = target.begin(kOrange);
  ASSERT_FALSE(begun.ok());
  EXPECT_EQ(begun.error().code, ErrorCode::missing_context);
  EXPECT_THAT(target.readRgb(), IsEmpty());
  app().makeCurrent();
  EXPECT_THAT(pixelAt(target.readRgb(), 3, 3), ElementsAre(255, 128, 0)) << "it was not lost";
}

}  // namespace
}  // namespace glide::test
