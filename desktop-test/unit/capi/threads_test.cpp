#include "unit/capi/c_walk_fixture.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <cstdint>
#include <future>
#include <string>
#include <thread>
#include <utility>

namespace glide::test {
namespace {

constexpr int kFrames = 30;
// Enough of them for a map.
constexpr int kStart = 16;
// Longer than any machine takes for what must not wait; only a failing test waits so long.
constexpr std::chrono::seconds kPatience{20};

/// Holds the call that logs a message for the first time until it is let go on.
class Gate {
 public:
  explicit Gate(std::string message) : message_(std::move(message)) {}

  glide_config config() {
    glide_config config = sized<glide_config>();
    config.execution = GLIDE_EXECUTION_INLINE;
    config.log_user = this;
    config.log = [](void* user, std::int32_t, const char* message) {
      static_cast<Gate*>(user)->pass(message);
    };
    return config;
  }
  void waitUntilHeld() { held_.get_future().wait(); }
  void open() { open_.set_value(); }

 private:
  void pass(const char* message) {
    if (message_ != message || is_passed_) return;
    is_passed_ = true;
    held_.set_value();
    open_.get_future().wait();
  }

  const std::string message_;
  bool is_passed_ = false;
  std::promise<void> held_, open_;
};

glide_status lookAtPoints(glide_session* session) {
  std::size_t count = 0;
  const float uv[2] = {160.0F, 120.0F};
  const glide_status points = glide_session_point_cloud(session, 0, nullptr, &count);
  if (points < 0) return points;
  if (count == 0) return GLIDE_ERROR_NOT_TRACKING;
  if (glide_session_tracked_points(session, 0, nullptr, &count) < 0) return GLIDE_ERROR_FATAL;
  const glide_status hits = glide_session_hit_test(session, uv, 0, nullptr, &count);
  return hits < 0 ? hits : GLIDE_OK;
}

glide_status lookAtMatrices(glide_session* session) {
  float matrix[16];
  glide_status status = glide_session_set_display(session, 90, 240, 320);
  if (status == GLIDE_OK) status = glide_session_view_matrix(session, matrix);
  if (status == GLIDE_OK) status = glide_session_projection_matrix(session, 0.1F, 9.0F, matrix);
  return status;
}

glide_status lookAtAnchors(glide_session* session) {
  glide_pose pose{};
  pose.q[3] = 1.0;
  std::uint64_t id = 0;
  glide_anchor anchor = sized<glide_anchor>();
  glide_status status = glide_anchor_create(session, &pose, &id);
  if (status == GLIDE_OK) status = glide_anchor_get(session, id, &anchor);
  if (status == GLIDE_OK) status = glide_anchor_destroy(session, id);
  return status;
}

glide_status lookAtMap(glide_session* session) {
  glide_map* map = nullptr;
  const glide_status status = glide_map_acquire(session, &map);
  glide_map_release(map);
  return status;
}

glide_status locate(glide_session* session) {
  glide_location location = sized<glide_location>();
  return glide_session_locate(session, 33'333'333, &location);
}

glide_status pushImu(glide_session* session) {
  const glide_imu_sample sample{1, {0.0F, 0.0F, 9.8F}, {0.0F, 0.0F, 0.0F}};
  return glide_session_push_imu(session, &sample, 1);
}

glide_status backend(glide_session* session) {
  glide_backend_info info = sized<glide_backend_info>();
  return glide_session_backend(session, &info);
}

glide_status changeWorld(glide_session* session) {
  const float down[3] = {0.0F, -1.0F, 0.0F};
  const glide_status status = glide_session_set_gravity(session, down);
  return status == GLIDE_OK ? glide_session_set_metric_scale(session, 2.0F) : status;
}

TEST(CThreads, DoNotWaitForAnUpdateThatIsUnderWay) {
  Gate gate("tracking");
  CWalk walk(gate.config());
  std::thread camera([&] { walk.walk(kStart); });
  gate.waitUntilHeld();
  std::future<glide_status> answer;
  for (const auto& call : {locate,
                           pushImu,
                           backend,
                           lookAtPoints,
                           lookAtMatrices,
                           lookAtAnchors,
                           lookAtMap,
                           changeWorld,
                           glide_session_wait_for_mapping}) {
    answer = std::async(std::launch::async, call, walk.session());
    const bool is_done = answer.wait_for(kPatience) == std::future_status::ready;
    EXPECT_TRUE(is_done);
    if (!is_done) break;
    EXPECT_EQ(answer.get(), GLIDE_OK) << glide_last_error();
  }
  gate.open();
  camera.join();
}

/// The read callback of an app whose map comes over a slow line.
struct SlowLine {
  std::promise<void> is_read, goes_on;

  glide_io io() {
    glide_io io = sized<glide_io>();
    io.user = this;
    io.read = [](void* user, void*, std::size_t) -> std::size_t {
      auto* line = static_cast<SlowLine*>(user);
      line->is_read.set_value();
      line->goes_on.get_future().wait();
      return 0;
    };
    return io;
  }
};

TEST(CThreads, DoNotHoldUpAnUpdateWhileTheyReadAMap) {
  CWalk walk(GLIDE_AXES_GL);
  SlowLine line;
  const glide_io io = line.io();
  auto loaded = std::async(std::launch::async, glide_map_load_io, walk.session(), &io);
  line.is_read.get_future().wait();
  auto frame = std::async(std::launch::async, [&] { return walk.feed(0.0).state; });
  EXPECT_EQ(frame.wait_for(kPatience), std::future_status::ready);
  line.goes_on.set_value();
  EXPECT_EQ(loaded.get(), GLIDE_ERROR_DATA_INVALID_FORMAT);
  EXPECT_EQ(frame.get(), GLIDE_STATE_INITIALIZING);
}

TEST(CThreads, WaitForWhatIsMappedButNotForWhatComesMeanwhile) {
  CWalk walk(GLIDE_AXES_GL, GLIDE_EXECUTION_THREADED);
  walk.walk(kStart);
  std::atomic<bool> has_waited{false};
  std::thread waiter([&] {
    EXPECT_EQ(glide_session_wait_for_mapping(walk.session()), GLIDE_OK);
    has_waited = true;
  });
  for (int i = 0; i < kStart || !has_waited; ++i) walk.feed(CWalk::image(i % (2 * kFrames)));
  waiter.join();
}

TEST(CThreads, SeeNothingOfTheOldMapAfterAReset) {
  CWalk walk(GLIDE_AXES_GL, GLIDE_EXECUTION_THREADED);
  glide_frame frame{};
  for (int i = 1; i <= 200 && !(i > kFrames && frame.keyframe != 0); ++i) {
    glide_session_wait_for_mapping(walk.session());
    frame = walk.walk(i);
  }
  ASSERT_NE(frame.keyframe, 0) << "the mapper has nothing to do";
  std::uint64_t id = 0;
  ASSERT_EQ(glide_anchor_create(walk.session(), &frame.camera, &id), GLIDE_OK);
  ASSERT_EQ(glide_session_reset(walk.session()), GLIDE_OK);
  glide_map* map = nullptr;
  ASSERT_EQ(glide_map_acquire(walk.session(), &map), GLIDE_OK);
  std::size_t count = 9;
  EXPECT_EQ(glide_map_keyframes(map, 0, nullptr, &count), GLIDE_OK);
  EXPECT_EQ(count, 0U);
  glide_map_release(map);
  glide_location location = sized<glide_location>();
  ASSERT_EQ(glide_session_locate(walk.session(), frame.t_ns, &location), GLIDE_OK);
  EXPECT_EQ(location.flags, 0U);
  glide_anchor anchor = sized<glide_anchor>();
  ASSERT_EQ(glide_anchor_get(walk.session(), id, &anchor), GLIDE_OK);
  EXPECT_EQ(anchor.tracking, 0);
}

/// Whether this is what a session may say at any moment: before there is a map some cannot answer.
bool isAnAnswer(glide_status status) {
  return status == GLIDE_OK || status == GLIDE_TRUNCATED || status == GLIDE_ERROR_NOT_TRACKING;
}

TEST(CThreads, MayDoEverythingAtOnce) {
  CWalk walk(GLIDE_AXES_GL, GLIDE_EXECUTION_THREADED);
  std::atomic<bool> is_over{false};
  const auto look = [&] {
    while (!is_over) {
      for (const auto& call : {locate,
                               backend,
                               lookAtPoints,
                               lookAtMatrices,
                               lookAtAnchors,
                               lookAtMap,
                               changeWorld,
                               glide_session_wait_for_mapping})
        EXPECT_TRUE(isAnAnswer(call(walk.session()))) << glide_last_error();
    }
  };
  std::thread looker(look);
  walk.walk(kStart);
  EXPECT_EQ(glide_session_reset(walk.session()), GLIDE_OK);
  for (int i = 0; i < kStart / 4; ++i) walk.feed(CWalk::image(i));
  is_over = true;
  looker.join();
}

}  // namespace
}  // namespace glide::test
