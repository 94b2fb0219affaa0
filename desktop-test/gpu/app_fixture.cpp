#include "gpu/app_fixture.h"

#include "support/gl_app.h"
#include "support/gl_snapshot.h"

#include <gmock/gmock.h>

#include <utility>

namespace glide::test {

void AppTest::SetUp() {
  GlTest::SetUp();
  if (IsSkipped() || HasFatalFailure()) return;
  main_.emplace();
  app_.emplace(makeContext(ContextSharing::none));
}

void AppTest::TearDown() {
  if (app_) {
    for (const std::string& complaint : app_->complaints())
      ADD_FAILURE() << "KHR_debug: " << complaint;
  }
  destroyApp();
  main_.reset();
  GlTest::TearDown();
}

AppContext AppTest::makeContext(ContextSharing sharing) {
  if (!hasCurrentContext()) main_->restore();  // for its display
  Result<AppContext> context = AppContext::create(sharing);
  EXPECT_TRUE(context.ok()) << context.error().message;
  return std::move(*context);
}

void AppTest::expectNoTrace(const std::vector<PublicCall>& calls, std::uint32_t seed) {
  GlApp gl_app(seed);
  for (const PublicCall& call : calls) {
    gl_app.randomise();
    prepareCall();
    const GlSnapshot objects = gl_app.objects();
    const GlSnapshot before = contextState();
    call.run();
    EXPECT_EQ(differences(before, contextState()), "") << call.name;
    EXPECT_EQ(differences(objects, gl_app.objects()), "") << call.name;
    ASSERT_FALSE(HasFailure()) << call.name;
  }
  gl_app.finish();
}

void AppTest::expectErrorsUntouched(const std::vector<PublicCall>& calls) {
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
