#include "capi/conversion.h"
#include "guest/guest_fixture.h"

#include "glide/glide.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <future>
#include <string>
#include <thread>

namespace glide::test {
namespace {

class CSessionInContext : public GlTest {
 protected:
  void SetUp() override {
    GlTest::SetUp();
    if (IsSkipped()) return;
    glide_config config;
    GLIDE_INIT(config);
    config.backend = GLIDE_BACKEND_GLES;
    config.execution = GLIDE_EXECUTION_INLINE;
    config.camera = toC(sequence_.config().camera);
    config.log_user = &log_;
    config.log = [](void* user, std::int32_t, const char* message) {
      *static_cast<std::string*>(user) += std::string(message) + "\n";
    };
    ASSERT_EQ(glide_session_create(&config, &session_), GLIDE_OK) << glide_last_error();
  }
  void TearDown() override {
    glide_session_destroy(session_);
    GlTest::TearDown();
  }
  glide_status update() {
    const ImageU8 image = sequence_.imageAt(0.0);
    glide_image input;
    GLIDE_INIT(input);
    input.t_ns = ++t_ns_;
    input.width = image.width();
    input.height = image.height();
    input.pixels = image.row(0);
    input.row_stride = image.stride();
    glide_frame frame;
    GLIDE_INIT(frame);
    return glide_session_update(session_, &input, &frame);
  }
  /// On a thread without a context.
  glide_status elsewhere(glide_status (*call)(glide_session*)) {
    glide_status status = GLIDE_OK;
    std::thread([&] { status = call(session_); }).join();
    return status;
  }

  SequenceFixture sequence_;
  std::string log_;
  glide_session* session_ = nullptr;
  std::int64_t t_ns_ = 0;
};

TEST_F(CSessionInContext, BelongsToTheThreadOfItsFirstUpdateUntilItLetsGo) {
  ASSERT_EQ(update(), GLIDE_OK) << glide_last_error();
  glide_backend_info backend;
  GLIDE_INIT(backend);
  ASSERT_EQ(glide_session_backend(session_, &backend), GLIDE_OK);
  EXPECT_EQ(backend.backend, GLIDE_BACKEND_GLES);
  EXPECT_STRNE(backend.renderer, "");
  glide_status status = GLIDE_OK;
  std::thread([&] { status = update(); }).join();
  EXPECT_EQ(status, GLIDE_ERROR_WRONG_THREAD);
  EXPECT_EQ(elsewhere(glide_session_release_gl), GLIDE_ERROR_WRONG_THREAD);
  ASSERT_EQ(glide_session_release_gl(session_), GLIDE_OK);
  std::thread([&] { status = update(); }).join();
  EXPECT_EQ(status, GLIDE_ERROR_MISSING_GL_CONTEXT);  // its own thread now, but without a context
  EXPECT_EQ(update(), GLIDE_OK) << glide_last_error();
}

/// An app that still reads in its callback when the session is destroyed.
struct SlowReader {
  glide_session* session = nullptr;
  std::promise<void> has_begun;

  std::size_t read() {
    has_begun.set_value();
    glide_backend_info info;
    GLIDE_INIT(info);
    while (glide_session_backend(session, &info) == GLIDE_OK) std::this_thread::yield();
    return 0;
  }
};

TEST_F(CSessionInContext, EndsOnTheThreadThatDestroysItThoughAnotherIsInACall) {
  ASSERT_EQ(update(), GLIDE_OK) << glide_last_error();
  SlowReader reader;
  reader.session = session_;
  glide_io io;
  GLIDE_INIT(io);
  io.user = &reader;
  io.read = [](void* user, void*, std::size_t) { return static_cast<SlowReader*>(user)->read(); };
  std::thread loader(
      [&] { EXPECT_EQ(glide_map_load_io(session_, &io), GLIDE_ERROR_DATA_INVALID_FORMAT); });
  reader.has_begun.get_future().wait();
  glide_session_destroy(session_);
  loader.join();
  EXPECT_THAT(log_, testing::Not(testing::HasSubstr("leaked")));
}

}  // namespace
}  // namespace glide::test
