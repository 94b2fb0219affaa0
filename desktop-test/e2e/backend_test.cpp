#include "e2e/run_matchers.h"
#include "support/egl_context.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <string_view>

namespace glide::test {
namespace {

constexpr int kFrames = 90;

bool glRequired() {
  const char* value = std::getenv("GLIDE_REQUIRE_GL");
  return value != nullptr && std::string_view(value) == "1";
}

TEST(Backends, GlesAndCpuAgree) {
  const Result<EglContext> context = EglContext::create(EglDebug::off);
  if (!context && glRequired()) FAIL() << "GLIDE_REQUIRE_GL=1, but " << context.error().message;
  if (!context) GTEST_SKIP() << "no GL: " << context.error().message;
  const synthetic::SequenceOptions options = roomWalk(kFrames);
  Config config = inlineConfig();
  const Playback cpu = play(options, config);
  config.backend = Backend::gles;
  const Playback gles = play(options, config);
  ASSERT_THAT(gles, IsTrackedToTheEnd());
  const double cpu_ate_m = evaluate(cpu).ate_rmse_m;
  EXPECT_NEAR(evaluate(gles).ate_rmse_m, cpu_ate_m, 0.2 * cpu_ate_m)
      << "gles: " << describe(gles) << "\ncpu: " << describe(cpu);
  EXPECT_NEAR(directShare(gles), directShare(cpu), 0.05)
      << "gles: " << describe(gles) << "\ncpu: " << describe(cpu);
}

}  // namespace
}  // namespace glide::test
