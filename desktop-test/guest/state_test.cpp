#include "guest/guest_fixture.h"
#include "support/gl_app.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace glide::test {
namespace {

/// A call of the public API, and what it is called in messages.
struct PublicCall {
  std::string name;
  std::function<void()> run;
};

/// Everything public, in an order in which each does GL work if it can.
class EveryCall {
 public:
  EveryCall(const Config& config, std::function<Result<FrameResult>(Session*, int)> feed)
      : config_(config), feed_(std::move(feed)) {}

  std::vector<PublicCall> calls(int frames) {
    std::vector<PublicCall> calls{{"create", [this] {
                                     Result<Session> made = Session::create(config_);
                                     ASSERT_TRUE(made.ok()) << made.error().message;
                                     session_.emplace(std::move(*made));
                                   }}};
    for (int i = 0; i < frames; ++i) calls.push_back(update());
    calls.push_back({"saveMap", [this] { map_ = session_->saveMap().value(); }});
    calls.push_back({"reset", [this] { session_->reset(); }});
    calls.push_back({"pause", [this] { session_->pause(); }});
    calls.push_back(update());
    calls.push_back({"resume", [this] { session_->resume(); }});
    calls.push_back(update());
    calls.push_back({"loadMap", [this] { EXPECT_TRUE(session_->loadMap(map_).ok()); }});
    for (int i = 0; i < 3; ++i) calls.push_back(update());
    calls.push_back({"locate", [this] { session_->locate(0); }});
    calls.push_back({"map", [this] { session_->map(); }});
    calls.push_back({"waitForMapping", [this] { session_->waitForMapping(); }});
    calls.push_back({"backend", [this] { session_->backend(); }});
    calls.push_back({"releaseGl", [this] { session_->releaseGl(); }});
    for (int i = 0; i < 3; ++i) calls.push_back(update());
    calls.push_back({"abandonGl", [this] { session_->abandonGl(); }});
    calls.push_back(update());
    calls.push_back({"destruction", [this] { session_.reset(); }});
    return calls;
  }
  int directFrames() const { return direct_frames_; }

 private:
  PublicCall update() {
    const int frame = next_frame_++;
    return {"update " + std::to_string(frame), [this, frame] {
              const Result<FrameResult> result = feed_(&*session_, frame);
              ASSERT_TRUE(result.ok()) << result.error().message;
              direct_frames_ += result->tracker == TrackerKind::direct ? 1 : 0;
            }};
  }

  Config config_;
  std::function<Result<FrameResult>(Session*, int)> feed_;
  std::optional<Session> session_;
  std::vector<std::byte> map_;
  int next_frame_ = 0, direct_frames_ = 0;
};

class GuestStateTest : public GuestTest {
 protected:
  EveryCall everyCall() const {
    return EveryCall(config(),
                     [this](Session* session, int frame) { return feed(session, frame); });
  }
  /// Frames until there is a map with a direct frame, and some more.
  int frames() const { return isSlow() ? 14 : 18; }
};

TEST_F(GuestStateTest, NoCallChangesAnyStateOfTheApp) {
  GlApp gl_app(5);
  EveryCall session = everyCall();
  for (const PublicCall& call : session.calls(frames())) {
    gl_app.randomise();
    const GlSnapshot objects = gl_app.objects();
    const GlSnapshot before = contextState();
    call.run();
    EXPECT_EQ(differences(before, contextState()), "") << call.name;
    EXPECT_EQ(differences(objects, gl_app.objects()), "") << call.name;
    ASSERT_FALSE(HasFailure()) << call.name;
  }
  gl_app.finish();
  EXPECT_GT(session.directFrames(), 0) << "the app's state kept the kernels from working";
}

TEST_F(GuestStateTest, ErrorsThatTheAppHasNotFetchedStayAndStayAlone) {
  EveryCall session = everyCall();
  constexpr GLenum kNoCapability = 0xBAD;
  for (const PublicCall& call : session.calls(frames())) {
    glEnable(kNoCapability);
    app().forgetComplaints();
    call.run();
    EXPECT_THAT(app().complaints(), ::testing::IsEmpty()) << call.name;
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_INVALID_ENUM)) << call.name;
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR)) << call.name;
  }
}

TEST_F(GuestStateTest, TheOtherPoliciesTrackTheSamePoses) {
  std::vector<std::vector<double>> positions;
  for (const GlStatePolicy policy :
       {GlStatePolicy::preserve, GlStatePolicy::reset, GlStatePolicy::none}) {
    Config with_policy = config();
    with_policy.gl.state = policy;
    Session session = makeSession(with_policy);
    const int next = trackDirectly(&session);
    const auto& t = feed(&session, next)->T_world_cam.t_xyz;
    positions.emplace_back(t.begin(), t.end());
  }
  EXPECT_EQ(positions[1], positions[0]);
  EXPECT_EQ(positions[2], positions[0]);
}

TEST_F(GuestStateTest, ResetLeavesANewContextsState) {
  const GlSnapshot initial = contextState();
  Config reset = config();
  reset.gl.state = GlStatePolicy::reset;
  Session session = makeSession(reset);
  trackDirectly(&session);
  EXPECT_EQ(differences(initial, contextState()), "");
}

}  // namespace
}  // namespace glide::test
