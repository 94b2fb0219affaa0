// How sessions end: destroyed while they are in use, by their own callbacks, and left to the exit.
#include "unit/capi/c_walk_fixture.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <future>
#include <malloc.h>
#include <thread>
#include <unistd.h>
#include <vector>

namespace glide::test {
namespace {

glide_status backend(glide_session* session) {
  glide_backend_info info = sized<glide_backend_info>();
  return glide_session_backend(session, &info);
}

void waitUntilClosed(glide_session* session) {
  while (backend(session) != GLIDE_ERROR_SESSION_CLOSED) std::this_thread::yield();
}

// What loadThrough returns when the callback had its turn.
constexpr glide_status kEmptyFile = GLIDE_ERROR_DATA_INVALID_FORMAT;

/// Loads an empty file through a callback that calls back.
template <class Callback>
glide_status loadThrough(glide_session* session, Callback* callback) {
  glide_io io = sized<glide_io>();
  io.user = callback;
  io.read = [](void* user, void*, std::size_t) -> std::size_t {
    (*static_cast<Callback*>(user))();
    return 0;
  };
  return glide_map_load_io(session, &io);
}

TEST(CDestroy, WaitsForTheCallsThatAreUnderWay) {
  const CWalk walk(GLIDE_AXES_GL);
  std::promise<void> is_inside;
  std::atomic<bool> is_done{false};
  auto callback = [&] {
    is_inside.set_value();
    waitUntilClosed(walk.session());  // destroy has begun
    is_done = true;
  };
  std::thread loader([&] { EXPECT_EQ(loadThrough(walk.session(), &callback), kEmptyFile); });
  is_inside.get_future().wait();
  glide_session_destroy(walk.session());
  EXPECT_TRUE(is_done);
  loader.join();
}

TEST(CDestroy, OfACallbackTakesEffectWhenItsCallEnds) {
  const CWalk walk(GLIDE_AXES_GL);
  auto callback = [&] { glide_session_destroy(walk.session()); };
  EXPECT_EQ(loadThrough(walk.session(), &callback), kEmptyFile);
  EXPECT_EQ(backend(walk.session()), GLIDE_ERROR_SESSION_CLOSED);
}

TEST(CDestroy, MayComeWhileThreadsCall) {
  CWalk walk(GLIDE_AXES_GL, GLIDE_EXECUTION_THREADED);
  walk.walk(3);
  std::vector<std::thread> callers;
  callers.reserve(4);
  for (int i = 0; i < 3; ++i) callers.emplace_back([&walk] { waitUntilClosed(walk.session()); });
  callers.emplace_back([&walk] {
    while (walk.status() == GLIDE_OK) walk.feed(CWalk::image(9));
    EXPECT_EQ(walk.status(), GLIDE_ERROR_SESSION_CLOSED);
  });
  glide_session_destroy(walk.session());
  for (std::thread& caller : callers) caller.join();
}

// Sanitizers bring an allocator of their own, and other C libraries do not count.
#if defined(__GLIBC__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)

std::size_t bytesInUse() {
  const struct mallinfo2 info = mallinfo2();
  return info.uordblks + info.hblkhd;
}

TEST(CDestroy, LeavesNothingBehind) {
  constexpr int kWarmUp = 10;
  constexpr int kCycles = 60;
  std::size_t before = 0;
  for (int i = 0; i < kWarmUp + kCycles; ++i) {
    if (i == kWarmUp) before = bytesInUse();
    CWalk(GLIDE_AXES_GL, GLIDE_EXECUTION_THREADED).feed(CWalk::image(0));
  }
  // What the threads of the last session cached may be more or less than a few small pieces.
  constexpr std::size_t kNoise = 4096;
  EXPECT_LE(bytesInUse(), before + kNoise) << "in " << kCycles << " sessions";
}

#endif

// What a process does that ends without destroying its session. The handler was registered before
// the library's: it runs after that.
glide_session* session_of_exit = nullptr;

void callAtExit() {
  glide_status status = GLIDE_OK;
  std::thread([&] { status = backend(session_of_exit); }).join();
  if (status != GLIDE_ERROR_SESSION_CLOSED) _exit(2);
}

[[noreturn]] void exitWithAnOpenSession() {
  std::atexit(callAtExit);
  auto* walk = new CWalk(GLIDE_AXES_GL, GLIDE_EXECUTION_THREADED);
  session_of_exit = walk->session();
  walk->walk(3);
  std::exit(0);
}

[[noreturn]] void exitInTheMiddleOfUpdates() {
  auto* walk = new CWalk(GLIDE_AXES_GL, GLIDE_EXECUTION_THREADED);
  std::promise<void> has_begun;
  std::thread([&, image = CWalk::image(0)] {  // its own: what is static ends with the process
    walk->feed(image);
    has_begun.set_value();
    while (walk->status() == GLIDE_OK) walk->feed(image);
  })
      .detach();
  has_begun.get_future().wait();
  std::exit(0);
}

TEST(CExitDeathTest, FindsAnOpenSessionClosed) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  EXPECT_EXIT(exitWithAnOpenSession(), testing::ExitedWithCode(0), "");
}

TEST(CExitDeathTest, MayComeInTheMiddleOfAnUpdate) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  EXPECT_EXIT(exitInTheMiddleOfUpdates(), testing::ExitedWithCode(0), "");
}

}  // namespace
}  // namespace glide::test
