#include "render/contract_fixture.h"

#include <gmock/gmock.h>

#include <utility>

namespace glide::test {

void ContractTest::SetUp() {
  GlTest::SetUp();
  if (IsSkipped() || HasFatalFailure()) return;
  main_.emplace();
  app_.emplace(makeContext(ContextSharing::none));
  Result<RenderTarget> target = RenderTarget::create(kWidth, kHeight);
  ASSERT_TRUE(target.ok()) << target.error().message;
  target_.emplace(std::move(*target));
  ASSERT_TRUE(target_->begin(kBlack).ok());
}

void ContractTest::TearDown() {
  if (app_) {
    EXPECT_THAT(app_->complaints(), ::testing::IsEmpty());
  }
  target_.reset();
  app_.reset();
  main_.reset();
  GlTest::TearDown();
}

AppContext ContractTest::makeContext(ContextSharing sharing) {
  if (!hasCurrentContext()) main_->restore();  // for its display
  Result<AppContext> context = AppContext::create(sharing);
  EXPECT_TRUE(context.ok()) << context.error().message;
  return std::move(*context);
}

void ContractTest::expectNoTrace(const std::vector<PublicCall>& calls) {
  GlApp gl_app(41);
  for (const PublicCall& call : calls) {
    gl_app.randomise();
    ASSERT_TRUE(target().begin(kBlack).ok());
    const GlSnapshot objects = gl_app.objects();
    const GlSnapshot before = contextState();
    call.run();
    EXPECT_EQ(differences(before, contextState()), "") << call.name;
    EXPECT_EQ(differences(objects, gl_app.objects()), "") << call.name;
    ASSERT_FALSE(HasFailure()) << call.name;
  }
  gl_app.finish();
}

void ContractTest::expectErrorsUntouched(const std::vector<PublicCall>& calls) {
  constexpr GLenum kNoCapability = 0xBAD;
  for (const PublicCall& call : calls) {
    glEnable(kNoCapability);
    app().forgetComplaints();
    call.run();
    EXPECT_THAT(app().complaints(), ::testing::IsEmpty()) << call.name;
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_INVALID_ENUM)) << call.name;
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR)) << call.name;
  }
}

}  // namespace glide::test
