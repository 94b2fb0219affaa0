#include "unit/capi/c_walk_fixture.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <string>
#include <thread>

namespace glide::test {
namespace {

using ::testing::HasSubstr;

constexpr int kFrames = 30;

TEST(CSession, GivesTheSamePosesAsCppInOpenCvAxes) {
  CWalk walk(GLIDE_AXES_CV);
  SequenceFixture sequence;
  Session session = makeSession(sequence.config());
  for (int i = 0; i < kFrames; ++i) {
    const glide_frame frame = walk.walk(i + 1);
    ASSERT_EQ(walk.status(), GLIDE_OK) << glide_last_error();
    const FrameResult expected = sequence.feed(&session, sequence.imageAt(i * 0.01));
    EXPECT_EQ(frame.t_ns, expected.t_ns);
    for (std::size_t k = 0; k < 3; ++k)
      EXPECT_NEAR(frame.camera.p[k], expected.T_world_cam.t_xyz[k], 1e-12);
    for (std::size_t k = 0; k < 4; ++k)
      EXPECT_NEAR(frame.camera.q[k], expected.T_world_cam.q_xyzw[k], 1e-12);
  }
}

TEST(CSession, TurnsPosesToOpenGlAxes) {
  CWalk gl(GLIDE_AXES_GL);
  CWalk cv(GLIDE_AXES_CV);
  const glide_pose a = gl.walk(kFrames).camera;
  const glide_pose b = cv.walk(kFrames).camera;
  EXPECT_NEAR(a.p[0], b.p[0], 1e-12);
  EXPECT_NEAR(a.p[1], -b.p[1], 1e-12);
  EXPECT_NEAR(a.p[2], -b.p[2], 1e-12);
}

TEST(CSession, SaysWhatAUserCanDoBeforeThereIsAMap) {
  CWalk walk(GLIDE_AXES_GL);
  EXPECT_EQ(walk.feed(walk.sequence().blank()).reason, GLIDE_REASON_INSUFFICIENT_FEATURES);
  glide_frame frame{};
  for (int i = 0; i < 4; ++i) frame = walk.feed(0.0);
  EXPECT_EQ(frame.state, GLIDE_STATE_INITIALIZING);
  EXPECT_EQ(frame.reason, GLIDE_REASON_INSUFFICIENT_PARALLAX);
  EXPECT_EQ(frame.confidence, 0.0F);
  EXPECT_GT(frame.start_matches, 60);
}

TEST(CSession, SaysWhoMadeThePoseAndWhyNotTheOther) {
  CWalk walk(GLIDE_AXES_GL);
  int directs = 0;
  for (int i = 0; i < kFrames; ++i) {
    const glide_frame frame = walk.walk(i + 1);
    if (frame.tracker == GLIDE_TRACKER_NONE) continue;
    const bool is_direct = frame.tracker == GLIDE_TRACKER_DIRECT;
    EXPECT_EQ(frame.switch_reason == GLIDE_SWITCH_NONE, is_direct);
    if (!is_direct) continue;  // the start has no error of its own
    EXPECT_GT(frame.rms, 0.0F);
    ++directs;
  }
  EXPECT_GT(directs, 5);
  EXPECT_EQ(glide_session_wait_for_mapping(walk.session()), GLIDE_OK);
}

TEST(CSession, RefusesFramesWhilePausedAndGoesOnAfterwards) {
  CWalk walk(GLIDE_AXES_GL);
  walk.walk(kFrames);
  EXPECT_EQ(glide_session_pause(walk.session()), GLIDE_OK);
  EXPECT_EQ(glide_session_pause(walk.session()), GLIDE_OK);
  walk.feed(0.29);
  EXPECT_EQ(walk.status(), GLIDE_ERROR_SESSION_PAUSED);
  EXPECT_EQ(glide_session_resume(walk.session()), GLIDE_OK);
  EXPECT_EQ(walk.feed(0.29).state, GLIDE_STATE_TRACKING);
}

TEST(CSession, NamesWhatIsWrongWithAConfig) {
  const CWalk walk(GLIDE_AXES_GL);
  glide_session* session = nullptr;
  glide_config config = walk.config();
  config.axes = 7;
  EXPECT_EQ(glide_session_create(&config, &session), GLIDE_ERROR_INVALID_ARGUMENT);
  EXPECT_THAT(glide_last_error(), HasSubstr("axes"));
  config = walk.config();
  config.camera.fx = -1.0;
  EXPECT_EQ(glide_session_create(&config, &session), GLIDE_ERROR_INVALID_ARGUMENT);
  EXPECT_THAT(glide_last_error(), HasSubstr("fx"));
  config = walk.config();
  const char* setting = "direct.patchsize=7";
  config.settings = &setting;
  EXPECT_EQ(glide_session_create(&config, &session), GLIDE_ERROR_INVALID_ARGUMENT);
  EXPECT_THAT(glide_last_error(), HasSubstr("did you mean direct.patch_size?"));
  config.setting_count = 0;
  EXPECT_EQ(glide_session_create(&config, &session), GLIDE_ERROR_INVALID_ARGUMENT);
  EXPECT_THAT(glide_last_error(), HasSubstr("setting_count"));
  EXPECT_EQ(session, nullptr);
}

TEST(CSession, SurvivesNullAndStaleHandles) {
  glide_session* session = nullptr;
  glide_frame frame = sized<glide_frame>();
  EXPECT_EQ(glide_session_update(nullptr, nullptr, &frame), GLIDE_ERROR_SESSION_CLOSED);
  EXPECT_EQ(glide_session_create(nullptr, &session), GLIDE_ERROR_INVALID_ARGUMENT);
  {
    const CWalk walk(GLIDE_AXES_GL);
    session = walk.session();
    EXPECT_EQ(glide_session_update(session, nullptr, &frame), GLIDE_ERROR_INVALID_ARGUMENT);
    EXPECT_EQ(glide_session_create(&walk.config(), nullptr), GLIDE_ERROR_INVALID_ARGUMENT);
  }
  EXPECT_EQ(glide_session_reset(session), GLIDE_ERROR_SESSION_CLOSED);
  std::uint64_t revision = 0;
  EXPECT_EQ(glide_map_revision(reinterpret_cast<glide_map*>(session), &revision),
            GLIDE_ERROR_SESSION_CLOSED);
  glide_session_destroy(session);
  glide_session_destroy(nullptr);
  EXPECT_EQ(glide_session_pause(session), GLIDE_ERROR_SESSION_CLOSED);
  EXPECT_THAT(glide_last_error(), HasSubstr("destroyed"));
}

TEST(CSession, RefusesStructsWithoutASize) {
  const CWalk walk(GLIDE_AXES_GL);
  glide_location location{};
  EXPECT_EQ(glide_session_locate(walk.session(), 0, &location), GLIDE_ERROR_INVALID_ARGUMENT);
  EXPECT_THAT(glide_last_error(), HasSubstr("struct_size"));
}

TEST(CSession, WritesNoMoreThanAnOlderStructHolds) {
  CWalk walk(GLIDE_AXES_GL);
  walk.walk(kFrames);
  glide_location location;
  std::memset(&location, 0x5A, sizeof(location));
  location.struct_size = offsetof(glide_location, camera);  // of a version without the pose
  ASSERT_EQ(glide_session_locate(walk.session(), kFrames * 33'333'333LL, &location), GLIDE_OK);
  EXPECT_EQ(location.flags,
            static_cast<std::uint32_t>(GLIDE_LOCATION_VALID | GLIDE_LOCATION_TRACKED));
  unsigned char untouched = 0;
  std::memcpy(&untouched, &location.camera, 1);
  EXPECT_EQ(untouched, 0x5A);
}

TEST(CSession, RefusesTimesThatDoNotIncrease) {
  const CWalk walk(GLIDE_AXES_GL);
  const ImageU8 image = walk.sequence().imageAt(0.0);
  glide_image input = sized<glide_image>();
  input.t_ns = 5;
  input.width = image.width();
  input.height = image.height();
  input.pixels = image.row(0);
  input.row_stride = image.stride();
  glide_frame frame = sized<glide_frame>();
  EXPECT_EQ(glide_session_update(walk.session(), &input, &frame), GLIDE_OK);
  EXPECT_EQ(glide_session_update(walk.session(), &input, &frame), GLIDE_ERROR_TIMESTAMP_ORDER);
  const glide_imu_sample samples[] = {{1, {0, 0, 9.8F}, {0, 0, 0}}, {1, {0, 0, 9.8F}, {0, 0, 0}}};
  EXPECT_EQ(glide_session_push_imu(walk.session(), samples, 1), GLIDE_OK);
  EXPECT_EQ(glide_session_push_imu(walk.session(), samples + 1, 1), GLIDE_ERROR_TIMESTAMP_ORDER);
  const glide_imu_sample later[] = {{2, {0, 0, 9.8F}, {0, 0, 0}}, {1, {0, 0, 9.8F}, {0, 0, 0}}};
  EXPECT_EQ(glide_session_push_imu(walk.session(), later, 2), GLIDE_ERROR_TIMESTAMP_ORDER);
  EXPECT_EQ(glide_session_push_imu(walk.session(), later, 1), GLIDE_OK);  // nothing was kept
}

TEST(CSession, KeepsTheLastErrorOfEachThread) {
  glide_session_pause(nullptr);
  const std::string here = glide_last_error();
  std::string there = "not asked";
  std::thread([&] { there = glide_last_error(); }).join();
  EXPECT_FALSE(here.empty());
  EXPECT_EQ(there, "");
}

TEST(CSession, TellsALogWhatHappens) {
  const CWalk walk(GLIDE_AXES_GL);
  glide_config config = walk.config();
  std::string log;
  config.log_user = &log;
  config.log = [](void* user, std::int32_t, const char* message) {
    *static_cast<std::string*>(user) += std::string(message) + "\n";
  };
  glide_session* session = nullptr;
  ASSERT_EQ(glide_session_create(&config, &session), GLIDE_OK);
  glide_image input = sized<glide_image>();
  input.t_ns = 1;
  glide_frame frame = sized<glide_frame>();
  EXPECT_EQ(glide_session_update(session, &input, &frame), GLIDE_ERROR_INVALID_ARGUMENT);
  EXPECT_THAT(log, HasSubstr("pixels"));
  glide_session_destroy(session);
}

TEST(CStatus, HasATextForEveryStatus) {
  for (const glide_status status :
       {0, 1, -1, -2, -3, -5, -7, -8, -11, -12, -18, -19, -100, -101, -102, -103, -104})
    EXPECT_STRNE(glide_status_string(status), "unknown status") << status;
  EXPECT_STREQ(glide_status_string(12345), "unknown status");
  EXPECT_EQ(glide_abi_version() >> 16U, static_cast<std::uint32_t>(GLIDE_ABI_MAJOR));
}

}  // namespace
}  // namespace glide::test
