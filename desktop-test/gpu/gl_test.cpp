#include "gpu/gl_test.h"

#include "support/egl_context.h"

#include <EGL/egl.h>

#include <cstdlib>
#include <optional>
#include <random>
#include <regex>
#include <string_view>

namespace glide::test {
namespace {

/// The program's context and what its driver has complained about.
struct SharedGl {
  Result<EglContext> context = EglContext::create(EglDebug::on);
  std::vector<std::string> messages;
};

// NOLINTBEGIN(readability-function-size): the signature is KHR_debug's
void GL_APIENTRY
onMessage(GLenum, GLenum type, GLuint, GLenum, GLsizei, const GLchar* message, const void* user) {
  if (type != GL_DEBUG_TYPE_ERROR_KHR) return;
  auto* messages = static_cast<std::vector<std::string>*>(const_cast<void*>(user));
  messages->emplace_back(message);
}
// NOLINTEND(readability-function-size)

void listen(SharedGl* shared) {
  const auto set_callback = reinterpret_cast<PFNGLDEBUGMESSAGECALLBACKKHRPROC>(
      eglGetProcAddress("glDebugMessageCallbackKHR"));
  if (set_callback == nullptr) return;
  set_callback(onMessage, &shared->messages);
  glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS_KHR);
}

SharedGl& sharedGl() {
  static SharedGl shared;
  static const bool listening = shared.context.ok() && (listen(&shared), true);
  static_cast<void>(listening);
  return shared;
}

bool glRequired() {
  const char* value = std::getenv("GLIDE_REQUIRE_GL");
  return value != nullptr && std::string_view(value) == "1";
}

/// What is wrong with the driver: GLIDE_GL_RENDERER is a regular expression of the one that is
/// tested (scripts/drivers.sh).
std::optional<std::string> otherDriver(const GlCaps& caps) {
  const char* wanted = std::getenv("GLIDE_GL_RENDERER");
  if (wanted == nullptr || std::regex_search(caps.renderer, std::regex(wanted))) {
    return std::nullopt;
  }
  return "GLIDE_GL_RENDERER is " + std::string(wanted) + ", but this is " + caps.renderer;
}

}  // namespace

void GlTest::SetUp() {
  SharedGl& shared = sharedGl();
  std::optional<std::string> problem;
  if (!shared.context) {
    problem = shared.context.error().message;
  } else {
    const Result<GlCaps> queried = GlCaps::query();
    if (queried) caps_ = *queried;
    if (!queried) problem = queried.error().message;
  }
  if (problem && glRequired()) FAIL() << "GLIDE_REQUIRE_GL=1, but " << *problem;
  if (problem) GTEST_SKIP() << "no GL: " << *problem;
  if (const auto other = otherDriver(caps_)) FAIL() << *other;
  shared.messages.clear();
}

void GlTest::forgetDriverMessages() { sharedGl().messages.clear(); }

void GlTest::TearDown() {
  if (!sharedGl().context) return;
  if (IsSkipped()) {
    while (glGetError() != GL_NO_ERROR) {
    }  // of asking for what is not there
    return;
  }
  for (const std::string& message : sharedGl().messages) ADD_FAILURE() << "KHR_debug: " << message;
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
}

ImageF readTexture(const GlTexture& texture) {
  glMemoryBarrier(GL_FRAMEBUFFER_BARRIER_BIT);
  GLuint framebuffer = 0;
  glGenFramebuffers(1, &framebuffer);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture.get(), 0);
  EXPECT_EQ(glCheckFramebufferStatus(GL_FRAMEBUFFER), static_cast<GLenum>(GL_FRAMEBUFFER_COMPLETE));
  const auto width = static_cast<std::size_t>(texture.width());
  std::vector<float> rgba(width * static_cast<std::size_t>(texture.height()) * 4);
  glReadPixels(0, 0, texture.width(), texture.height(), GL_RGBA, GL_FLOAT, rgba.data());
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  glDeleteFramebuffers(1, &framebuffer);
  ImageF image(texture.width(), texture.height());
  for (int y = 0; y < texture.height(); ++y) {
    const float* row = rgba.data() + static_cast<std::size_t>(y) * width * 4;
    for (int x = 0; x < texture.width(); ++x) image.at(x, y) = row[4 * x];
  }
  return image;
}

ImageU8 randomImage(int width, int height, std::uint32_t seed) {
  std::mt19937 random(seed);
  ImageU8 image(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) image.at(x, y) = static_cast<std::uint8_t>(random() & 0xFFU);
  }
  return image;
}

}  // namespace glide::test
